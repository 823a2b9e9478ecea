// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/files/errors.h"
#include "io/files/text_file.h"
#include "io/stones/stone_file.h"
#include "io/stones/words.h"

namespace voussoir::io {
namespace {

/// ASCII STL begins with "solid" and goes on with facets; binary STL says how many triangles it has, and is as long.
bool looks_like_stl(std::string_view text) {
  if (text.starts_with("solid")) return true;
  if (text.size() < 84) return false;
  const auto byte = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(text[80 + i])); };
  return text.size() == 84 + 50 * (byte(0) | byte(1) << 8 | byte(2) << 16 | byte(3) << 24);
}

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

}  // namespace

StoneFile read_stone_file(const std::string& path, std::string_view text) {
  const std::string_view start = trimmed(text.substr(0, 4096));
  if (start.empty()) throw FileError(path, "is empty");
  if (start.starts_with("ply")) return read_ply(path, text);
  if (looks_like_stl(text)) return read_stl(path, text);
  if (start.starts_with("{") || start.starts_with("[")) return read_compas(path, text);
  if (start.starts_with("<")) return read_vtu(path, text);
  if (looks_like_obj(text)) return read_obj(path, text);
  throw FileError(path, "is of no format that is read: OBJ, PLY, STL, VTU, JSON of COMPAS");
}

}  // namespace voussoir::io
