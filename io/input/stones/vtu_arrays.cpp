// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/stones/vtu_arrays.h"

#include <zlib.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <optional>

#include "io/input/files/errors.h"
#include "io/input/files/text_file.h"
#include "io/input/stones/words.h"

namespace voussoir::io {
namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 31;  // of one array, unpacked

/// The value of an attribute of a tag, or "".
std::string attribute(std::string_view tag, std::string_view name) {
  for (std::size_t at = tag.find(name); at != std::string_view::npos; at = tag.find(name, at + 1)) {
    const std::size_t after = at + name.size();
    const bool alone = at > 0 && std::string_view(" \t\r\n").find(tag[at - 1]) != std::string_view::npos;
    if (!alone || after + 1 >= tag.size() || tag[after] != '=' || (tag[after + 1] != '"' && tag[after + 1] != '\'')) continue;
    const std::size_t end = tag.find(tag[after + 1], after + 2);
    if (end == std::string_view::npos) return "";
    return std::string(tag.substr(after + 2, end - after - 2));
  }
  return "";
}

int sextet(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

/// Decodes base64 up to a padding or an invalid character. \param used  number of characters read
std::string base64(std::string_view text, std::size_t& used) {
  std::string out;
  std::uint32_t bits = 0;
  int have = 0;
  for (used = 0; used < text.size(); ++used) {
    const int value = sextet(text[used]);
    if (value < 0) break;
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    have += 6;
    if (have >= 8) {
      have -= 8;
      out.push_back(static_cast<char>(bits >> have & 0xFFU));
    }
  }
  while (used < text.size() && text[used] == '=') ++used;
  return out;
}

template <class T>
void append_as(std::string_view bytes, std::vector<double>& out) {
  for (std::size_t at = 0; at + sizeof(T) <= bytes.size(); at += sizeof(T)) {
    T value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    out.push_back(static_cast<double>(value));
  }
}

bool append_numbers(const std::string& type, std::string_view bytes, std::vector<double>& out) {
  if (type == "Float64") return append_as<double>(bytes, out), true;
  if (type == "Float32") return append_as<float>(bytes, out), true;
  if (type == "Int64") return append_as<std::int64_t>(bytes, out), true;
  if (type == "UInt64") return append_as<std::uint64_t>(bytes, out), true;
  if (type == "Int32") return append_as<std::int32_t>(bytes, out), true;
  if (type == "UInt32") return append_as<std::uint32_t>(bytes, out), true;
  if (type == "Int16") return append_as<std::int16_t>(bytes, out), true;
  if (type == "UInt16") return append_as<std::uint16_t>(bytes, out), true;
  if (type == "Int8") return append_as<std::int8_t>(bytes, out), true;
  if (type == "UInt8") return append_as<std::uint8_t>(bytes, out), true;
  return false;
}

}  // namespace

VtuArrays::VtuArrays(const std::string& path, std::string_view text) : path_(path) {
  std::string section;
  int pieces = 0;
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at)) {
    if (text.substr(at).starts_with("<!--")) {
      at = std::min(text.find("-->", at), text.size());
      continue;
    }
    const std::size_t end = text.find('>', at);
    if (end == std::string_view::npos) throw FileError(path_, "ends within a tag");
    const std::string_view tag = text.substr(at + 1, end - at - 1);
    at = end + 1;
    const std::string_view name = tag.substr(0, tag.find_first_of(" \t\r\n/", 1));
    if (name == "VTKFile") {
      if (attribute(tag, "type") != "UnstructuredGrid")
        throw FileError(path_, "is a VTK file of type " + shown(attribute(tag, "type")) + "; wanted: UnstructuredGrid");
      if (attribute(tag, "byte_order") == "BigEndian")
        throw FileError(path_, "has its bytes in the big-endian order; write it as little-endian or ASCII");
      const std::string packer = attribute(tag, "compressor");
      deflated_ = packer == "vtkZLibDataCompressor";
      if (!packer.empty() && !deflated_)
        throw FileError(path_, "is packed by " + shown(packer) + "; wanted: vtkZLibDataCompressor, or none");
      long_heads_ = attribute(tag, "header_type") == "UInt64";
    } else if (name == "Piece") {
      if (++pieces > 1) throw FileError(path_, "has several pieces; write it as one");
    } else if (name == "Points" || name == "Cells" || name == "CellData" || name == "PointData") {
      section = name;
    } else if (name == "DataArray") {
      const bool empty = !tag.empty() && tag.back() == '/';
      const std::size_t close = empty ? at : std::min(text.find('<', at), text.size());
      take_array(section, tag, text.substr(at, close - at));
    } else if (name == "AppendedData") {
      appended_raw_ = attribute(tag, "encoding") == "raw";
      const std::size_t mark = text.find('_', at);
      appended_ = mark == std::string_view::npos ? std::string_view() : text.substr(mark + 1);
      break;  // the rest is no XML
    }
  }
  if (pieces == 0) throw FileError(path_, "holds no piece of an unstructured grid");
}

void VtuArrays::take_array(const std::string& section, std::string_view tag, std::string_view content) {
  Array a{attribute(tag, "type"), attribute(tag, "format"), 0, content};
  if (const auto offset = finite_number(attribute(tag, "offset")); offset && *offset >= 0.0 && *offset < 1e15)
    a.offset = static_cast<std::size_t>(*offset);
  arrays_[section == "Points" ? "Points" : section + "/" + attribute(tag, "Name")] = a;
}

std::string VtuArrays::blocks(std::string_view coded, bool raw, const std::string& name) const {
  const auto fault = [&](const std::string& what) { throw FileError(path_, "the array " + name + " " + what); };
  const std::size_t word = long_heads_ ? 8 : 4;
  const auto number = [&](std::string_view from, std::size_t i) -> std::size_t {
    std::uint64_t v = 0;
    if (from.size() < word * (i + 1)) fault("ends early");
    std::memcpy(&v, from.data() + word * i, word);
    if (v > kMostBytes) fault("claims more than this program reads");
    return static_cast<std::size_t>(v);
  };
  const auto decoded = [&](std::string_view from) {
    std::size_t used = 0;
    std::string all = base64(from, used);
    if (all.size() == word) all += base64(from.substr(used), used);  // a separately encoded head
    return all;
  };
  if (!deflated_) {
    const std::string all = raw ? std::string() : decoded(coded);
    const std::string_view bytes = raw ? coded : std::string_view(all);
    const std::size_t size = number(bytes, 0);
    if (bytes.size() - word < size) fault("ends early");
    return std::string(bytes.substr(word, size));
  }
  // The head (number of blocks, their size, size of the last one, packed sizes) is encoded separately.
  const std::string first = raw ? std::string(coded.substr(0, word)) : decoded(coded.substr(0, (word + 2) / 3 * 4));
  const std::size_t count = number(first, 0), head_bytes = word * (3 + count);
  if (count > coded.size()) fault("claims more than the file has");
  std::size_t head_text = raw ? head_bytes : (head_bytes + 2) / 3 * 4;
  const std::string head = raw ? std::string(coded.substr(0, head_bytes)) : decoded(coded.substr(0, head_text));
  const std::string rest = raw ? std::string() : decoded(coded.substr(std::min(head_text, coded.size())));
  std::string_view packed = raw ? coded.substr(std::min(head_text, coded.size())) : std::string_view(rest);
  std::string out;
  for (std::size_t b = 0; b < count; ++b) {
    const std::size_t size = number(head, 3 + b), last = number(head, 2), whole = b + 1 == count && last != 0 ? last : number(head, 1);
    if (packed.size() < size || out.size() + whole > kMostBytes || whole / 1100 > size + 64)
      fault("ends early, or claims more than it holds");
    const std::size_t from = out.size();
    out.resize(from + whole);
    uLongf length = whole;
    if (uncompress(reinterpret_cast<Bytef*>(out.data() + from), &length, reinterpret_cast<const Bytef*>(packed.data()), size) != Z_OK ||
        length != whole)
      fault("cannot be unpacked");
    packed.remove_prefix(size);
  }
  return out;
}

std::string VtuArrays::bytes(const Array& a, const std::string& name) const {
  if (a.format == "appended") {
    if (a.offset > appended_.size()) throw FileError(path_, "the array " + name + " lies beyond the end of the file");
    return blocks(appended_.substr(a.offset), appended_raw_, name);
  }
  return blocks(trimmed(a.text), false, name);
}

std::vector<double> VtuArrays::values(const Array& a, const std::string& name) const {
  std::vector<double> out;
  if (a.format == "ascii" || a.format.empty()) {
    Words words(a.text);
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
      const auto number = finite_number(word);
      if (!number) throw FileError(path_, "the array " + name + " holds " + shown(word) + ", no finite number");
      out.push_back(*number);
    }
    return out;
  }
  if (a.format != "binary" && a.format != "appended") throw FileError(path_, "the array " + name + " is of format " + shown(a.format));
  if (!append_numbers(a.type, bytes(a, name), out)) throw FileError(path_, "the array " + name + " is of type " + shown(a.type));
  return out;
}

std::vector<double> VtuArrays::points() const { return cell_part("Points"); }

std::vector<double> VtuArrays::cell_part(const std::string& name) const {
  const auto found = arrays_.find(name == "Points" ? name : "Cells/" + name);
  if (found == arrays_.end()) throw FileError(path_, "has no array " + name);
  return values(found->second, name);
}

std::vector<double> VtuArrays::cell_data(const std::string& name) const {
  const auto found = arrays_.find("CellData/" + name);
  return found == arrays_.end() ? std::vector<double>{} : values(found->second, name);
}

}  // namespace voussoir::io
