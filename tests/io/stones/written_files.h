// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "tests/io/stones/stones_fixture.h"

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
    all.push_back({"voussoir_" + std::to_string(i), {v, {{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}}}});
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
      vertices += (v == 0 ? "\"" : ", \"") + std::to_string(v) + "\": {\"x\": " + number(m.vertices[v].x) + ", \"y\": " + number(m.vertices[v].y) +
                  ", \"z\": " + number(m.vertices[v].z) + "}";
    }
    for (std::size_t f = 0; f < m.faces.size(); ++f) {
      faces += (f == 0 ? "\"" : ", \"") + std::to_string(f) + "\": [";
      for (std::size_t k = 0; k < m.faces[f].size(); ++k) faces += (k == 0 ? "" : ", ") + std::to_string(m.faces[f][k]);
      faces += "]";
    }
    nodes += (i == 0 ? "\"" : ", \"") + std::to_string(i) + "\": {\"block\": {\"dtype\": \"compas_assembly.datastructures/Block\", \"data\": {\"vertex\": {" +
             vertices + "}, \"face\": {" + faces + "}}, \"name\": \"Mesh\"}" + (i == 0 && first_is_support ? ", \"is_support\": true" : "") + "}";
  }
  return "{\"dtype\": \"compas_assembly.datastructures/Assembly\", \"data\": {\"graph\": {\"data\": {\"node\": {" + nodes +
         "}, \"edge\": {\"0\": {\"1\": {\"interfaces\": [{\"dtype\": \"compas_assembly.datastructures/Interface\", \"data\": {}}]}}}}}}}";
}

enum class Ply { ascii, little, big, little_float };
inline std::string ply(const Mesh& m, Ply kind) {
  const bool floats = kind == Ply::little_float, swap = kind == Ply::big;
  const std::string type = floats ? "float" : "double";
  std::string text = std::string("ply\nformat ") + (kind == Ply::ascii ? "ascii" : swap ? "binary_big_endian" : "binary_little_endian") +
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
        if (!ascii) for (const double x : {p.x, p.y, p.z}) append_bytes(body, static_cast<float>(x));
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

inline std::string base64(const std::string& bytes) {
  static const char* const kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) out += i + k > bytes.size() ? '=' : kLetters[bits >> (18 - 6 * k) & 63U];
  }
  return out;
}

/// An array of VTK as it stands in the file: a head and the bytes, or deflated in two blocks.
inline std::string vtk_binary(const std::string& bytes, bool deflated) {
  std::string head;
  if (!deflated) {
    append_bytes(head, static_cast<std::uint32_t>(bytes.size()));
    return base64(head + bytes);
  }
  const std::size_t block = (bytes.size() + 1) / 2;
  std::string packed;
  append_bytes(head, std::uint32_t{2});
  append_bytes(head, static_cast<std::uint32_t>(block));
  append_bytes(head, static_cast<std::uint32_t>(bytes.size() - block));
  for (const std::string& part : {bytes.substr(0, block), bytes.substr(block)}) {
    std::vector<Bytef> room(compressBound(part.size()));
    uLongf size = room.size();
    compress(room.data(), &size, reinterpret_cast<const Bytef*>(part.data()), part.size());
    append_bytes(head, static_cast<std::uint32_t>(size));
    packed.append(reinterpret_cast<const char*>(room.data()), size);
  }
  return base64(head) + base64(packed);
}

enum class Vtu { ascii, base64, deflated };
inline std::string vtu(const std::vector<Named>& all, Vtu kind) {
  std::vector<double> points;
  std::vector<std::int64_t> corners, ends, faces, face_ends;
  for (const Named& n : all) {
    const auto first = static_cast<std::int64_t>(points.size() / 3);
    for (const Vec3& v : n.mesh.vertices) points.insert(points.end(), {v.x, v.y, v.z});
    for (std::size_t v = 0; v < n.mesh.vertices.size(); ++v) corners.push_back(first + static_cast<std::int64_t>(v));
    ends.push_back(static_cast<std::int64_t>(corners.size()));
    faces.push_back(static_cast<std::int64_t>(n.mesh.faces.size()));
    for (const auto& loop : n.mesh.faces) {
      faces.push_back(static_cast<std::int64_t>(loop.size()));
      for (const int v : loop) faces.push_back(first + v);
    }
    face_ends.push_back(static_cast<std::int64_t>(faces.size()));
  }
  const auto array = [&](const std::string& name, const char* type, const auto& values) {
    std::string out = std::string("<DataArray type=\"") + type + "\" Name=\"" + name + "\" format=\"" + (kind == Vtu::ascii ? "ascii" : "binary") + "\">\n";
    if (kind == Vtu::ascii) {
      for (const auto v : values) out += number(static_cast<double>(v)) + " ";
    } else {
      std::string bytes;
      for (const auto v : values) append_bytes(bytes, v);
      out += "  " + vtk_binary(bytes, kind == Vtu::deflated);
    }
    return out + "\n</DataArray>\n";
  };
  return std::string("<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\"") +
         (kind == Vtu::deflated ? " compressor=\"vtkZLibDataCompressor\"" : "") + ">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
         std::to_string(points.size() / 3) + "\" NumberOfCells=\"" + std::to_string(all.size()) + "\">\n<Points>\n" + array("Points", "Float64", points) +
         "</Points>\n<Cells>\n" + array("connectivity", "Int64", corners) + array("offsets", "Int64", ends) +
         array("types", "UInt8", std::vector<std::uint8_t>(all.size(), 42)) + array("faces", "Int64", faces) + array("faceoffsets", "Int64", face_ends) +
         "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace stones
