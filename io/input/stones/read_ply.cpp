// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>

#include "geometry/nth.h"
#include "io/input/files/errors.h"
#include "io/input/files/text_file.h"
#include "io/input/stones/stone_file.h"
#include "io/input/stones/words.h"

namespace voussoir::io {
namespace {

enum class Number { i8, u8, i16, u16, i32, u32, f32, f64 };
constexpr std::array<std::pair<std::string_view, Number>, 16> kNumbers{{{"char", Number::i8},
                                                                        {"int8", Number::i8},
                                                                        {"uchar", Number::u8},
                                                                        {"uint8", Number::u8},
                                                                        {"short", Number::i16},
                                                                        {"int16", Number::i16},
                                                                        {"ushort", Number::u16},
                                                                        {"uint16", Number::u16},
                                                                        {"int", Number::i32},
                                                                        {"int32", Number::i32},
                                                                        {"uint", Number::u32},
                                                                        {"uint32", Number::u32},
                                                                        {"float", Number::f32},
                                                                        {"float32", Number::f32},
                                                                        {"double", Number::f64},
                                                                        {"float64", Number::f64}}};

std::size_t bytes_of(Number n) {
  constexpr std::array<std::size_t, 8> kBytes{1, 1, 2, 2, 4, 4, 4, 8};
  return nth(kBytes, n);
}

struct Property {
  std::string name;
  Number type = Number::f64;
  std::optional<Number> count;  // type of a list's count
};
struct ElementKind {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

template <class T>
double as(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return static_cast<double>(value);
}

class PlyReader {
 public:
  PlyReader(const std::string& path, std::string_view text) : path_(path), text_(text) {}

  StoneFile read() {
    read_head();
    StoneFile out;
    FileSolid solid;
    solid.whole = false;
    for (const ElementKind& kind : kinds_) {
      if (kind.name == "vertex") {
        read_vertices(kind, solid.mesh);
      } else if (kind.name == "face") {
        read_faces(kind, solid.mesh);
      } else {
        if (kind.name == "tristrips" && kind.count > 0) out.doubts.push_back("left out: its strips of triangles (tristrips); write faces");
        for (std::size_t i = 0; i < kind.count; ++i) pass_over(kind);
      }
    }
    if (solid.mesh.faces.empty()) throw FileError(path_, "holds no faces");
    check_corners(solid.mesh);
    if (const std::size_t rest = text_.substr(at_).size(); !trimmed(text_.substr(at_)).empty())
      out.doubts.push_back(std::to_string(rest) + (rest == 1 ? " byte" : " bytes") +
                           " behind its last element are passed over: its head may say too few");
    out.solids.push_back(std::move(solid));
    return out;
  }

 private:
  [[noreturn]] void fault(const std::string& what) const { throw FileError(path_, what); }

  Number number_type(std::string_view word) const {
    const auto found = std::find_if(kNumbers.begin(), kNumbers.end(), [&](const auto& n) { return n.first == word; });
    if (found == kNumbers.end()) fault("PLY type " + shown(word) + " is unknown");
    return found->second;
  }

  void read_head() {
    for (;;) {
      const std::size_t end = text_.find('\n', at_);
      if (end == std::string_view::npos) fault("its PLY head has no end_header");
      Words line(text_.substr(at_, end - at_));
      at_ = end + 1;
      const std::string_view key = line.next();
      if (key == "end_header") break;
      if (key == "format") set_format(line.next());
      if (key == "element") add_element(line);
      if (key == "property") add_property(line);
    }
    if (!formatted_) fault("its PLY head names no format");
  }

  void set_format(std::string_view word) {
    formatted_ = true;
    ascii_ = word == "ascii";
    swap_ = word == "binary_big_endian";
    if (!ascii_ && !swap_ && word != "binary_little_endian") fault("PLY format " + shown(word) + " is unknown");
  }
  void add_element(Words& line) {
    ElementKind kind;
    kind.name = line.next();
    const auto count = finite_number(line.next());
    if (!count || *count < 0.0 || *count > 1e9 || *count != std::floor(*count)) fault("PLY element " + shown(kind.name) + " has no count");
    kind.count = static_cast<std::size_t>(*count);
    kinds_.push_back(std::move(kind));
  }
  void add_property(Words& line) {
    if (kinds_.empty()) fault("a PLY property stands before any element");
    Property p;
    std::string_view word = line.next();
    if (word == "list") {
      p.count = number_type(line.next());
      word = line.next();
    }
    p.type = number_type(word);
    p.name = line.next();
    kinds_.back().properties.push_back(std::move(p));
  }

  /// Reads the next number of the body.
  double next(Number type) {
    if (ascii_) return next_word();
    std::array<char, 8> bytes{};
    const std::size_t size = std::min(bytes_of(type), bytes.size());
    if (text_.size() - at_ < size) fault("ends within its numbers");
    std::copy_n(text_.data() + at_, size, bytes.data());
    if (swap_) std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    at_ += size;
    switch (type) {
      case Number::i8:
        return as<std::int8_t>(bytes.data());
      case Number::u8:
        return as<std::uint8_t>(bytes.data());
      case Number::i16:
        return as<std::int16_t>(bytes.data());
      case Number::u16:
        return as<std::uint16_t>(bytes.data());
      case Number::i32:
        return as<std::int32_t>(bytes.data());
      case Number::u32:
        return as<std::uint32_t>(bytes.data());
      case Number::f32:
        return as<float>(bytes.data());
      case Number::f64:
        break;
    }
    return as<double>(bytes.data());
  }
  double next_word() {
    Words words(text_.substr(at_));
    const std::string_view word = words.next();
    if (word.empty()) fault("ends within its numbers");
    at_ = static_cast<std::size_t>(word.data() + word.size() - text_.data());
    const auto number = finite_number(word);
    if (!number) fault(shown(word) + " is no finite number");
    return *number;
  }

  std::size_t list_length(const Property& p) {
    const double count = next(*p.count);
    if (!(count >= 0.0) || count > static_cast<double>(text_.size()))
      fault("a list of " + std::to_string(count) + " numbers in " + shown(p.name));
    return static_cast<std::size_t>(count);
  }
  void pass_over(const Property& p) {
    const std::size_t count = p.count ? list_length(p) : 1;
    for (std::size_t i = 0; i < count; ++i) next(p.type);
  }
  void pass_over(const ElementKind& kind) {
    for (const Property& p : kind.properties) pass_over(p);
    if (kind.properties.empty()) fault("PLY element " + shown(kind.name) + " has no properties");
  }

  void read_vertices(const ElementKind& kind, geometry::Mesh& mesh) {
    constexpr std::array<std::string_view, 3> kAxes{"x", "y", "z"};
    for (const std::string_view axis : kAxes) {
      if (std::none_of(kind.properties.begin(), kind.properties.end(), [&](const Property& p) { return p.name == axis && !p.count; }))
        fault("its PLY vertices have no " + std::string(axis));
    }
    for (std::size_t i = 0; i < kind.count; ++i) {
      std::array<double, 3> x{};
      for (const Property& p : kind.properties) {
        const auto axis = std::find(kAxes.begin(), kAxes.end(), p.name);
        if (axis == kAxes.end()) {
          pass_over(p);
        } else {
          nth(x, axis - kAxes.begin()) = next(p.type);
        }
      }
      if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2])) fault("vertex " + std::to_string(i) + " is not finite");
      mesh.vertices.push_back({x[0], x[1], x[2]});
    }
  }

  void read_faces(const ElementKind& kind, geometry::Mesh& mesh) {
    const auto is_loop = [](const Property& p) { return p.count && (p.name == "vertex_indices" || p.name == "vertex_index"); };
    if (std::none_of(kind.properties.begin(), kind.properties.end(), is_loop)) fault("its PLY faces have no list vertex_indices");
    for (std::size_t i = 0; i < kind.count; ++i) {
      for (const Property& p : kind.properties) {
        if (!is_loop(p)) {
          pass_over(p);
          continue;
        }
        std::vector<std::int32_t> loop(list_length(p));
        if (loop.size() < 3) fault("face " + std::to_string(i) + " has fewer than 3 corners");
        for (std::int32_t& v : loop) {
          const double value = next(p.type);
          if (!(value >= 0.0 && value < 2e9) || value != std::floor(value)) fault("face " + std::to_string(i) + " names what is no vertex");
          v = static_cast<std::int32_t>(value);
        }
        mesh.faces.push_back(std::move(loop));
      }
    }
  }

  void check_corners(const geometry::Mesh& mesh) const {
    for (const auto& loop : mesh.faces) {
      for (const std::int32_t v : loop) {
        if (static_cast<std::size_t>(v) >= mesh.vertices.size())
          fault("a face names vertex " + std::to_string(v) + ", there are " + std::to_string(mesh.vertices.size()));
      }
    }
  }

  const std::string& path_;
  std::string_view text_;
  std::size_t at_ = 0;
  bool ascii_ = false, swap_ = false, formatted_ = false;
  std::vector<ElementKind> kinds_;
};

}  // namespace

StoneFile read_ply(const std::string& path, std::string_view text) { return PlyReader(path, text).read(); }

}  // namespace voussoir::io
