// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "io/input/files/errors.h"
#include "io/input/files/text_file.h"
#include "io/input/stones/stone_file.h"
#include "io/input/stones/words.h"

namespace voussoir::io {
namespace {

constexpr std::size_t kHeadBytes = 84, kTriangleBytes = 50;  // bytes

std::uint32_t stated_count(std::string_view text) {
  std::uint32_t count = 0;
  std::memcpy(&count, text.data() + 80, sizeof count);
  return count;
}

void add_triangle(geometry::Mesh& mesh, const Vec3 (&corners)[3]) {
  const auto first = static_cast<std::int32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), corners, corners + 3);
  mesh.faces.push_back({first, first + 1, first + 2});
}

std::string triangles(std::size_t count) { return std::to_string(count) + (count == 1 ? " triangle" : " triangles"); }

/// Number of triangles of the file, from its head and its length, which should agree.
std::size_t binary_count(const std::string& path, std::string_view text, StoneFile& out) {
  if (text.size() < kHeadBytes)
    throw FileError(path,
                    "has " + std::to_string(text.size()) + " bytes, and the head of a binary STL file has 84: it was cut; export it again");
  const std::size_t stated = stated_count(text), held = (text.size() - kHeadBytes) / kTriangleBytes,
                    rest = (text.size() - kHeadBytes) % kTriangleBytes;
  if (stated == held && rest == 0) return held;
  const bool never_filled = stated == 0 || stated == std::numeric_limits<std::uint32_t>::max();
  const std::string says = "its head says " + triangles(stated) + ", its length holds " + std::to_string(held) +
                           (rest > 0 ? " and " + std::to_string(rest) + " bytes" : std::string());
  if (never_filled && rest == 0) {
    out.doubts.push_back(says + ": taken are the " + std::to_string(held));
    return held;
  }
  if (stated == held) {
    out.doubts.push_back(says + ": the bytes behind the last triangle are passed over");
    return held;
  }
  throw FileError(path, says + ": it was " + (stated > held && !never_filled ? "cut" : "damaged") + "; export it again");
}

StoneFile read_binary(const std::string& path, std::string_view text) {
  StoneFile out;
  const std::size_t count = binary_count(path, text, out);
  FileSolid& solid = out.solids.emplace_back();
  solid.whole = false;
  for (std::size_t i = 0; i < count; ++i) {
    float x[9];
    std::memcpy(x, text.data() + kHeadBytes + kTriangleBytes * i + 12, sizeof x);
    if (!std::all_of(x, x + 9, [](float v) { return std::isfinite(v); }))
      throw FileError(path, "triangle " + std::to_string(i) + " is not finite");
    add_triangle(solid.mesh, {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, {x[6], x[7], x[8]}});
  }
  if (count == 0) throw FileError(path, "holds no triangles");
  return out;
}

/// Reads ASCII STL. Solids with names of their own are stones; all others together are loose faces.
StoneFile read_ascii(const std::string& path, std::string_view text) {
  StoneFile out;
  LineReader lines(text);
  Vec3 corner[3];
  int corners = 0;
  bool open = false;  // within a solid
  long unended = 0;   // line in which a solid begins before the last has ended
  UnknownLines unknown;
  const auto fault = [&](const std::string& what) { throw FileError(path, lines.line(), what); };
  while (const auto line = lines.next()) {
    Words words(*line);
    const std::string key = upper(words.next());
    if (key == "SOLID") {
      if (open && unended == 0) unended = lines.line();
      open = true;
      out.solids.emplace_back().name = trimmed(words.rest());
    } else if (key == "VERTEX") {
      double x[3] = {};
      for (double& value : x) {
        const std::string_view word = words.next();
        const auto number = finite_number(word);
        if (!number) fault(shown(word) + " is no finite number; wanted: vertex x y z");
        value = *number;
      }
      if (corners == 3) fault("a facet of more than three corners");
      corner[corners++] = {x[0], x[1], x[2]};
    } else if (key == "ENDFACET") {
      if (corners != 3) fault("a facet of " + std::to_string(corners) + " corners; wanted: 3");
      if (out.solids.empty()) fault("a facet before any solid");
      add_triangle(out.solids.back().mesh, corner);
      corners = 0;
    } else if (key == "ENDSOLID") {
      open = false;
    } else if (!key.empty() && key != "FACET" && key != "OUTER" && key != "ENDLOOP") {
      unknown.add(lines.line(), key);
    }
  }
  if (corners != 0) fault("ends within a facet");
  std::erase_if(out.solids, [](const FileSolid& s) { return s.mesh.faces.empty(); });
  if (out.solids.empty()) throw FileError(path, "holds no triangles");
  if (unended > 0)
    out.doubts.push_back("begins a solid in line " + std::to_string(unended) + " before 'endsolid' of the last: lines may be missing");
  if (open) out.doubts.push_back("ends without 'endsolid': it may have been cut");
  unknown.tell("STL", out.doubts);
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
  one.doubts = std::move(out.doubts);
  one.solids.push_back(std::move(heap));
  return one;
}

}  // namespace

bool is_binary_stl(std::string_view text) {
  return text.size() >= kHeadBytes && text.size() == kHeadBytes + kTriangleBytes * static_cast<std::size_t>(stated_count(text));
}

bool is_ascii_stl(std::string_view text) {
  Words words(text);
  if (upper(words.next()) != "SOLID") return false;
  const std::string head = upper(text.substr(0, 65536));
  return head.find('\0') == std::string::npos &&
         (head.find("FACET") != std::string::npos || head.find("ENDSOLID") != std::string::npos || text.size() < kHeadBytes);
}

StoneFile read_stl(const std::string& path, std::string_view text) {
  return is_binary_stl(text) || !is_ascii_stl(text) ? read_binary(path, text) : read_ascii(path, text);
}

}  // namespace voussoir::io
