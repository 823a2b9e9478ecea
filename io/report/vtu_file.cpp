// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/report/vtu_file.h"

#include <array>
#include <cstdio>
#include <functional>

#include "io/replay/cells.h"

namespace voussoir::io {
namespace {

std::string number(double value, const char* format) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

void append(std::string& out, Vec3 v, const char* format) {
  for (const double x : {v.x, v.y, v.z}) out += number(x, format) + ' ';
  out += '\n';
}

/// An array of the grid, its values written by `fill`.
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
      for (const Vec3 v : b.shape.vertices) append(o, v, "%.10g");
    }
  });
  out += "</Points>\n";
}

void write_cells(std::string& out, const Cells& cells) {
  out += "<Cells>\n";
  array(out, "Int64", "connectivity", 1, [&](std::string& o) {
    for (const std::int32_t c : cells.corners) o += c < 0 ? "" : std::to_string(c) + ' ';
  });
  array(out, "Int64", "offsets", 1, [&](std::string& o) {
    int end = 0;
    for (const std::uint8_t t : cells.type) o += std::to_string(end += corners_of(t)) + ' ';
  });
  array(out, "UInt8", "types", 1, [&](std::string& o) {
    for (const std::uint8_t t : cells.type) o += std::to_string(t) + ' ';
  });
  out += "</Cells>\n";
}

void write_mode(std::string& out, const cases::Model& model, const solver::Mode& mode, std::size_t number_of_mode) {
  const std::string name = "mode " + std::to_string(number_of_mode) + " (" + number(mode.frequency, "%.3f") + " Hz)";
  array(out, "Float32", name, 3, [&](std::string& o) {
    for (std::size_t e = 0; e < model.blocks.size(); ++e) {
      const Vec3 centroid = model.assembly.elements[e].mass.centroid;
      for (const Vec3 v : model.blocks[e].shape.vertices) append(o, mode.displacement[e] + cross(mode.rotation[e], v - centroid), "%.6g");
    }
  });
}

}  // namespace

std::string mode_shapes_vtu(const cases::Model& model, std::span<const solver::Mode> modes) {
  const Cells cells = cells_of(model);
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
  array(out, "Int32", "element", 1, [&](std::string& o) {
    for (const std::int32_t e : cells.element) o += std::to_string(e) + ' ';
  });
  array(out, "Int32", "material", 1, [&](std::string& o) {
    for (const std::int32_t e : cells.element) o += std::to_string(model.blocks[static_cast<std::size_t>(e)].material) + ' ';
  });
  return out + "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace voussoir::io
