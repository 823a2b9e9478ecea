// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include "io/input/files/errors.h"
#include "io/input/files/foreign_text.h"
#include "io/input/files/text_file.h"
#include "io/input/stones/stone_file.h"
#include "io/input/stones/words.h"

namespace voussoir::io {
namespace {

bool looks_like_obj(std::string_view text) {
  LineReader lines(text);
  for (int i = 0; i < 1000; ++i) {
    const auto line = lines.next();
    if (!line) return false;
    Words words(*line);
    const std::string_view key = words.next();
    if (key.empty() || key.starts_with('#')) continue;
    for (const char* known : {"v", "vn", "vt", "vp", "f", "o", "g", "s", "mtllib", "usemtl", "l", "p", "cstype"}) {
      if (key == known) return true;
    }
    return false;
  }
  return false;
}

/// Reads a format with names in text of any encoding.
StoneFile read_text(StoneFile (*read)(const std::string&, std::string_view), const std::string& path, std::string_view text) {
  return is_all_utf8(text) ? read(path, text) : read(path, as_utf8(path, std::string(text)));
}

/// Whether the name is that of STL, and head or length are wrong.
bool is_damaged_stl(const std::string& path, std::string_view text) {
  return upper(std::filesystem::path(path).extension().string()) == ".STL" && text.find('\0') != std::string_view::npos;
}

constexpr std::size_t kMostCorners = 1000;  // of a face: what is done with a face takes the square of them

StoneFile read_by_format(const std::string& path, std::string_view text) {
  if (utf16_of(text) != Utf16::no && !is_binary_stl(text)) return read_by_format(path, as_utf8(path, std::string(text)));
  text = without_utf8_mark(text);
  const std::string_view start = trimmed(text.substr(0, 4096));
  if (start.empty()) throw FileError(path, "is empty");
  if (start.starts_with("ply")) return read_ply(path, text);
  if (is_binary_stl(text) || is_damaged_stl(path, text)) return read_stl(path, text);
  if (is_ascii_stl(text)) return read_text(read_stl, path, text);
  if (start.starts_with("{") || start.starts_with("[")) return read_text(read_compas, path, text);
  if (start.starts_with("<")) return read_vtu(path, text);
  if (looks_like_obj(text)) return read_text(read_obj, path, text);
  throw FileError(path, "is of no format that is read: OBJ, PLY, STL, VTU, JSON of COMPAS");
}

}  // namespace

StoneFile read_stone_file(const std::string& path, std::string_view text) {
  StoneFile file = read_by_format(path, text);
  for (const FileSolid& solid : file.solids)
    for (const auto& face : solid.mesh.faces)
      if (face.size() > kMostCorners)
        throw FileError(path, "holds a face of " + std::to_string(face.size()) + " corners" +
                                  (solid.name.empty() ? "" : ", of " + shown(solid.name)) + "; allowed: at most " +
                                  std::to_string(kMostCorners));
  return file;
}

}  // namespace voussoir::io
