// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "tests/io/input/stones/stones_fixture.h"

/// The same stones in every format, as other programs write them.
namespace stones {

/// Voussoirs of a semicircular arch of so many stones; the outer ones stand on the ground. Along y from 0 to `depth`.
inline std::vector<Named> arch(int count, double inner, double outer, double depth) {
  std::vector<Named> all;
  for (int i = 0; i < count; ++i) {
    std::vector<Vec3> v;
    for (const double y : {0.0, depth}) {
      for (const auto& [r, k] : {std::pair(inner, i), {outer, i}, {outer, i + 1}, {inner, i + 1}}) {
        const double a = M_PI * k / count;
        v.push_back({r * std::cos(a), y, r * std::sin(a)});
      }
    }
    all.push_back(
        {"voussoir_" + std::to_string(i), {v, {{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}}}});
  }
  return all;
}

/// Quadrilaterals as two triangles.
inline Mesh in_triangles(const Mesh& m) {
  Mesh out{m.vertices, {}};
  for (const auto& loop : m.faces) {
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) out.faces.push_back({loop[0], loop[i], loop[i + 1]});
  }
  return out;
}

template <class T>
void append_bytes(std::string& text, T value, bool swap = false) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  if (swap) std::reverse(bytes, bytes + sizeof value);
  text.append(bytes, sizeof value);
}

inline std::string compas(const std::vector<Named>& all, bool first_is_support) {
  std::string nodes;
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::string vertices, faces;
    const Mesh& m = all[i].mesh;
    for (std::size_t v = 0; v < m.vertices.size(); ++v) {
      vertices += (v == 0 ? "\"" : ", \"") + std::to_string(v) + "\": {\"x\": " + number(m.vertices[v].x) +
                  ", \"y\": " + number(m.vertices[v].y) + ", \"z\": " + number(m.vertices[v].z) + "}";
    }
    for (std::size_t f = 0; f < m.faces.size(); ++f) {
      faces += (f == 0 ? "\"" : ", \"") + std::to_string(f) + "\": [";
      for (std::size_t k = 0; k < m.faces[f].size(); ++k) faces += (k == 0 ? "" : ", ") + std::to_string(m.faces[f][k]);
      faces += "]";
    }
    nodes += (i == 0 ? "\"" : ", \"") + std::to_string(i) +
             "\": {\"block\": {\"dtype\": \"compas_assembly.datastructures/Block\", \"data\": {\"vertex\": {" + vertices +
             "}, \"face\": {" + faces + "}}, \"name\": \"Mesh\"}" + (i == 0 && first_is_support ? ", \"is_support\": true" : "") + "}";
  }
  return "{\"dtype\": \"compas_assembly.datastructures/Assembly\", \"data\": {\"graph\": {\"data\": {\"node\": {" + nodes +
         "}, \"edge\": {\"0\": {\"1\": {\"interfaces\": [{\"dtype\": \"compas_assembly.datastructures/Interface\", \"data\": {}}]}}}}}}}";
}

enum class Ply { ascii, little, big, little_float };
inline std::string ply(const Mesh& m, Ply kind) {
  const bool floats = kind == Ply::little_float, swap = kind == Ply::big;
  const std::string type = floats ? "float" : "double";
  std::string text = std::string("ply\nformat ") +
                     (kind == Ply::ascii ? "ascii"
                      : swap             ? "binary_big_endian"
                                         : "binary_little_endian") +
                     " 1.0\ncomment by a test\nelement vertex " + std::to_string(m.vertices.size()) + "\n";
  for (const char* axis : {"x", "y", "z"}) text += "property " + type + " " + axis + "\n";
  text += "property uchar red\nelement face " + std::to_string(m.faces.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Vec3& v : m.vertices) {
    if (kind == Ply::ascii) {
      text += number(v.x) + " " + number(v.y) + " " + number(v.z) + " 200\n";
      continue;
    }
    for (const double x : {v.x, v.y, v.z}) floats ? append_bytes(text, static_cast<float>(x)) : append_bytes(text, x, swap);
    append_bytes(text, std::uint8_t{200});
  }
  for (const auto& loop : m.faces) {
    if (kind == Ply::ascii) {
      text += std::to_string(loop.size());
      for (const int v : loop) text += " " + std::to_string(v);
      text += "\n";
      continue;
    }
    append_bytes(text, static_cast<std::uint8_t>(loop.size()));
    for (const std::int32_t v : loop) append_bytes(text, v, swap);
  }
  return text;
}

inline std::string stl(const std::vector<Mesh>& all, bool ascii) {
  std::string body;
  std::uint32_t count = 0;
  for (const Mesh& mesh : all) {
    const Mesh m = in_triangles(mesh);
    for (const auto& t : m.faces) {
      ++count;
      if (!ascii) body.append(12, '\0');
      if (ascii) body += "facet normal 0 0 0\nouter loop\n";
      for (const int v : t) {
        const Vec3 p = m.vertices[static_cast<std::size_t>(v)];
        if (ascii) body += "vertex " + number(p.x) + " " + number(p.y) + " " + number(p.z) + "\n";
        if (!ascii)
          for (const double x : {p.x, p.y, p.z}) append_bytes(body, static_cast<float>(x));
      }
      if (ascii) body += "endloop\nendfacet\n";
      if (!ascii) body.append(2, '\0');
    }
  }
  if (ascii) return "solid\n" + body + "endsolid\n";
  std::string head(80, ' ');
  append_bytes(head, count);
  return head + body;
}

}  // namespace stones
