// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/vtu_file.h"

#include <functional>

#include "cases/model.h"
#include "geometry/message.h"
#include "geometry/nth.h"
#include "io/output/replay/cells.h"

namespace voussoir::io {
namespace {

constexpr std::uint8_t kPolyhedron = 42;  // cell type of VTK

void append(std::string& out, Vec3 v, const char* format) {
  for (const double x : {v.x, v.y, v.z}) out += geometry::printed(format, x) + ' ';
  out += '\n';
}

/// Appends an array of the grid, with values written by `fill`.
void array(std::string& out, const char* type, const std::string& name, int components, const std::function<void(std::string&)>& fill) {
  out += std::string("<DataArray type=\"") + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" + std::to_string(components) +
         "\" format=\"ascii\">\n";
  fill(out);
  out += "</DataArray>\n";
}

void write_points(std::string& out, const cases::Model& model) {
  out += "<Points>\n";
  array(out, "Float64", "points", 3, [&](std::string& o) {
    for (const cases::Block& b : model.blocks) {
      for (const Vec3 v : b.shape.vertices) append(o, model.origin + v, "%.17g");
    }
  });
  out += "</Points>\n";
}

/// Hexahedra and wedges as cells; any other element as one polyhedron, whose faces are in a separate array.
struct Grid {
  std::vector<std::int64_t> corners, ends, faces, face_ends;
  std::vector<std::uint8_t> type;
  std::vector<std::int32_t> element;
};

void add_polyhedron(const geometry::Polyhedron& p, std::int64_t first, Grid& g) {
  for (std::size_t v = 0; v < p.vertices.size(); ++v) g.corners.push_back(first + static_cast<std::int64_t>(v));
  g.faces.push_back(static_cast<std::int64_t>(p.faces.size()));
  for (const auto& loop : p.faces) {
    g.faces.push_back(static_cast<std::int64_t>(loop.size()));
    for (const std::int32_t v : loop) g.faces.push_back(first + v);
  }
}

Grid grid_of(const cases::Model& model) {
  const Cells cells = cells_of(model);
  std::vector<std::int64_t> first_vertex;
  std::int64_t vertices = 0;
  for (const cases::Block& b : model.blocks) {
    first_vertex.push_back(vertices);
    vertices += static_cast<std::int64_t>(b.shape.vertices.size());
  }
  Grid g;
  for (std::size_t c = 0; c < cells.type.size(); ++c) {
    const std::int32_t e = cells.element[c];
    const bool polyhedron = cells.type[c] == kTetrahedron;
    if (polyhedron && !g.element.empty() && g.element.back() == e) continue;  // one polyhedron for all its tetrahedra
    if (polyhedron) {
      add_polyhedron(nth(model.blocks, e).shape, nth(first_vertex, e), g);
    } else {
      const auto row = cells.corners.begin() + static_cast<std::ptrdiff_t>(8 * c);
      g.corners.insert(g.corners.end(), row, row + corners_of(cells.type[c]));
    }
    g.ends.push_back(static_cast<std::int64_t>(g.corners.size()));
    g.face_ends.push_back(polyhedron ? static_cast<std::int64_t>(g.faces.size()) : -1);
    g.type.push_back(polyhedron ? kPolyhedron : cells.type[c]);
    g.element.push_back(e);
  }
  return g;
}

template <class T>
void numbers(std::string& out, const char* type, const char* name, const std::vector<T>& values) {
  array(out, type, name, 1, [&](std::string& o) {
    for (const T v : values) o += std::to_string(v) + ' ';
  });
}

void write_cells(std::string& out, const Grid& g) {
  out += "<Cells>\n";
  numbers(out, "Int64", "connectivity", g.corners);
  numbers(out, "Int64", "offsets", g.ends);
  numbers(out, "UInt8", "types", g.type);
  if (!g.faces.empty()) {
    numbers(out, "Int64", "faces", g.faces);
    numbers(out, "Int64", "faceoffsets", g.face_ends);
  }
  out += "</Cells>\n";
}

void write_mode(std::string& out, const cases::Model& model, const solver::Mode& mode, std::size_t number_of_mode) {
  const std::string name = "mode " + std::to_string(number_of_mode) + " (" + geometry::printed("%.3f", mode.frequency) + " Hz)";
  array(out, "Float32", name, 3, [&](std::string& o) {
    for (std::size_t e = 0; e < model.blocks.size(); ++e) {
      const Vec3 centroid = model.assembly.elements[e].mass.centroid;
      for (const Vec3 v : model.blocks[e].shape.vertices) append(o, mode.displacement[e] + cross(mode.rotation[e], v - centroid), "%.6g");
    }
  });
}

}  // namespace

std::string mode_shapes_vtu(const cases::Model& model, std::span<const solver::Mode> modes) {
  const Grid cells = grid_of(model);
  std::size_t vertices = 0;
  for (const cases::Block& b : model.blocks) vertices += b.shape.vertices.size();
  std::string out = "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">\n";
  out += "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" + std::to_string(vertices) + "\" NumberOfCells=\"" +
         std::to_string(cells.type.size()) + "\">\n";
  write_points(out, model);
  write_cells(out, cells);
  out += "<PointData>\n";
  for (std::size_t i = 0; i < modes.size(); ++i) write_mode(out, model, modes[i], i + 1);
  out += "</PointData>\n<CellData>\n";
  numbers(out, "Int32", "element", cells.element);
  array(out, "Int32", "material", 1, [&](std::string& o) {
    for (const std::int32_t e : cells.element) o += std::to_string(nth(model.blocks, e).material) + ' ';
  });
  return out + "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace voussoir::io
