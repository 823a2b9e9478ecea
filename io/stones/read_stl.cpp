// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstring>

#include "io/files/errors.h"
#include "io/files/text_file.h"
#include "io/stones/stone_file.h"
#include "io/stones/words.h"

namespace voussoir::io {
namespace {

constexpr std::size_t kHeadBytes = 84, kTriangleBytes = 50;  // bytes

/// Binary files may begin with "solid", too: their length tells.
bool is_binary(std::string_view text) {
  if (text.size() < kHeadBytes) return false;
  std::uint32_t count = 0;
  std::memcpy(&count, text.data() + 80, sizeof count);
  return text.size() == kHeadBytes + kTriangleBytes * static_cast<std::size_t>(count) || !text.starts_with("solid");
}

void add_triangle(geometry::Mesh& mesh, const Vec3 (&corners)[3]) {
  const auto first = static_cast<std::int32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), corners, corners + 3);
  mesh.faces.push_back({first, first + 1, first + 2});
}

StoneFile read_binary(const std::string& path, std::string_view text) {
  std::uint32_t count = 0;
  std::memcpy(&count, text.data() + 80, sizeof count);
  if ((text.size() - kHeadBytes) / kTriangleBytes < count)
    throw FileError(path, "ends within its triangles: " + std::to_string(count) + " are announced, there is room for " +
                              std::to_string((text.size() - kHeadBytes) / kTriangleBytes));
  StoneFile out;
  FileSolid& solid = out.solids.emplace_back();
  solid.whole = false;
  for (std::uint32_t i = 0; i < count; ++i) {
    float x[9];
    std::memcpy(x, text.data() + kHeadBytes + kTriangleBytes * i + 12, sizeof x);
    if (!std::all_of(x, x + 9, [](float v) { return std::isfinite(v); }))
      throw FileError(path, "triangle " + std::to_string(i) + " is not finite");
    add_triangle(solid.mesh, {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, {x[6], x[7], x[8]}});
  }
  if (count == 0) throw FileError(path, "holds no triangles");
  return out;
}

/// Solids with names of their own are stones; others are one heap.
StoneFile read_ascii(const std::string& path, std::string_view text) {
  StoneFile out;
  LineReader lines(text);
  Vec3 corner[3];
  int corners = 0;
  const auto fault = [&](const std::string& what) { throw FileError(path, lines.line(), what); };
  while (const auto line = lines.next()) {
    Words words(*line);
    const std::string_view key = words.next();
    if (key == "solid") {
      out.solids.emplace_back().name = trimmed(words.rest());
    } else if (key == "vertex") {
      double x[3] = {};
      for (double& value : x) {
        const std::string_view word = words.next();
        const auto number = finite_number(word);
        if (!number) fault(shown(word) + " is no finite number; wanted: vertex x y z");
        value = *number;
      }
      if (corners == 3) fault("a facet of more than three corners");
      corner[corners++] = {x[0], x[1], x[2]};
    } else if (key == "endfacet") {
      if (corners != 3) fault("a facet of " + std::to_string(corners) + " corners; wanted: 3");
      if (out.solids.empty()) fault("a facet before any solid");
      add_triangle(out.solids.back().mesh, corner);
      corners = 0;
    }
  }
  if (corners != 0) fault("ends within a facet");
  std::erase_if(out.solids, [](const FileSolid& s) { return s.mesh.faces.empty(); });
  if (out.solids.empty()) throw FileError(path, "holds no triangles");
  std::vector<std::string> names;
  for (const FileSolid& s : out.solids) names.push_back(s.name);
  std::sort(names.begin(), names.end());
  const bool named = out.solids.size() > 1 && !names.front().empty() && std::adjacent_find(names.begin(), names.end()) == names.end();
  if (named) return out;
  FileSolid heap;
  heap.whole = false;
  for (const FileSolid& s : out.solids) {
    const auto first = static_cast<std::int32_t>(heap.mesh.vertices.size());
    heap.mesh.vertices.insert(heap.mesh.vertices.end(), s.mesh.vertices.begin(), s.mesh.vertices.end());
    for (const auto& loop : s.mesh.faces) heap.mesh.faces.push_back({first + loop[0], first + loop[1], first + loop[2]});
  }
  StoneFile one;
  one.solids.push_back(std::move(heap));
  return one;
}

}  // namespace

StoneFile read_stl(const std::string& path, std::string_view text) {
  return is_binary(text) ? read_binary(path, text) : read_ascii(path, text);
}

}  // namespace voussoir::io
