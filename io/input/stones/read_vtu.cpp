// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "geometry/nth.h"
#include "io/input/files/errors.h"
#include "io/input/stones/stone_file.h"
#include "io/input/stones/vtu_arrays.h"

namespace voussoir::io {
namespace {

using Loop = std::vector<std::int32_t>;

/// Faces of VTK's cells, counter-clockwise seen from outside.
const std::map<int, std::vector<Loop>>& faces_by_type() {
  static const std::map<int, std::vector<Loop>> faces{
      {10, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}},
      {11, {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}}},
      {12, {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}},
      {13, {{0, 1, 2}, {3, 5, 4}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}}},
      {14, {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}}};
  return faces;
}

constexpr int kTriangle = 5, kPolygon = 7, kQuadrilateral = 9, kPolyhedron = 42;

class VtuReader {
 public:
  VtuReader(const std::string& path, std::string_view text) : path_(path), text_(text), arrays_(path, text) {}

  StoneFile read() {
    const std::vector<double> points = arrays_.points();
    if (points.size() % 3 != 0) fault("its points are no triples");
    for (std::size_t i = 0; i < points.size(); i += 3) points_.push_back({points[i], points[i + 1], points[i + 2]});
    for (const Vec3& p : points_) {
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) fault("a point is not finite");
    }
    read_cells();
    StoneFile out;
    for (auto& [key, cell] : cells_) out.solids.push_back(solid_of(key, cell));
    if (!heap_.empty()) {
      FileSolid heap{"", {}, mesh_of(heap_), false, false};
      out.solids.push_back(std::move(heap));
    }
    if (left_over_ > 0)
      out.doubts.push_back(std::to_string(left_over_) + " numbers behind the last cell of its connectivity are passed over");
    if (text_.find("</VTKFile>") == std::string_view::npos) out.doubts.push_back("ends without </VTKFile>: it may have been cut");
    if (out.solids.empty()) fault("holds no cells of three dimensions, nor polygons");
    return out;
  }

 private:
  [[noreturn]] void fault(const std::string& what) const { throw FileError(path_, what); }

  [[nodiscard]] std::vector<std::int64_t> whole_numbers(const char* name) {
    std::vector<std::int64_t> out;
    for (const double v : arrays_.cell_part(name)) {
      if (!(std::abs(v) < 9e15) || v != std::floor(v)) fault(std::string("its ") + name + " are no whole numbers");
      out.push_back(static_cast<std::int64_t>(v));
    }
    return out;
  }

  [[nodiscard]] std::int32_t point(std::int64_t v) const {
    if (v < 0 || v >= static_cast<std::int64_t>(points_.size()))
      fault("a cell names point " + std::to_string(v) + ", there are " + std::to_string(points_.size()));
    return static_cast<std::int32_t>(v);
  }

  void read_cells() {
    const auto corners = whole_numbers("connectivity"), ends = whole_numbers("offsets"), types = whole_numbers("types");
    if (ends.size() != types.size()) fault("its offsets and types are not as many");
    std::vector<std::int64_t> faces, face_ends;
    if (std::find(types.begin(), types.end(), kPolyhedron) != types.end())
      faces = whole_numbers("faces"), face_ends = whole_numbers("faceoffsets");
    const std::vector<double> element = arrays_.cell_data("element");
    if (!element.empty() && element.size() != types.size()) fault("its cell array element is not as long as its types");
    if (!std::ranges::all_of(element, [](double e) { return std::isfinite(e); }))
      fault("its cell array element has values that are not finite");
    std::int64_t start = 0;
    for (std::size_t c = 0; c < types.size(); ++c) {
      if (ends[c] < start || ends[c] > static_cast<std::int64_t>(corners.size()))
        fault("its offsets do not rise, or pass the end of its connectivity");
      const std::vector<std::int64_t> own(corners.begin() + start, corners.begin() + ends[c]);
      start = ends[c];
      const double key = element.empty() ? static_cast<double>(c) : element[c];
      const auto type = static_cast<int>(types[c]);
      if (type == kTriangle || type == kQuadrilateral || type == kPolygon) {
        add_polygon(own, heap_);
      } else if (type == kPolyhedron) {
        if (face_ends.size() != types.size()) fault("its faceoffsets are not as many as its cells");
        add_polyhedron(faces, face_ends[c], c, cells_[key]);
      } else if (const auto known = faces_by_type().find(type); known != faces_by_type().end()) {
        add_cell(own, known->second, cells_[key]);
      } else {
        fault("cell " + std::to_string(c) + " is of VTK's type " + std::to_string(type) +
              "; wanted: 10 to 14 or 42 (solids), 5, 7 or 9 (polygons)");
      }
    }
    left_over_ = static_cast<std::int64_t>(corners.size()) - start;
  }

  void add_polygon(const std::vector<std::int64_t>& own, std::vector<Loop>& to) const {
    if (own.size() < 3) fault("a polygon of fewer than 3 corners");
    Loop loop;
    for (const std::int64_t v : own) loop.push_back(point(v));
    to.push_back(std::move(loop));
  }

  void add_cell(const std::vector<std::int64_t>& own, const std::vector<Loop>& faces, std::vector<Loop>& to) const {
    for (const Loop& face : faces) {
      Loop loop;
      for (const std::int32_t k : face) {
        if (static_cast<std::size_t>(k) >= own.size()) fault("a cell has fewer corners than its type");
        loop.push_back(point(nth(own, k)));
      }
      to.push_back(std::move(loop));
    }
  }

  /// Adds the faces of one cell from the stream: number of faces, then for each the number of its corners, and the corners. `end` comes
  /// from faceoffsets.
  void add_polyhedron(const std::vector<std::int64_t>& faces, std::int64_t end, std::size_t cell, std::vector<Loop>& to) {
    std::int64_t& at = face_at_;
    const auto next = [&] {
      if (at >= end || at >= static_cast<std::int64_t>(faces.size())) fault("the faces of cell " + std::to_string(cell) + " end early");
      return nth(faces, at++);
    };
    const std::int64_t count = next();
    for (std::int64_t f = 0; f < count; ++f) {
      const std::int64_t corners = next();
      if (corners < 3) fault("a face of cell " + std::to_string(cell) + " has fewer than 3 corners");
      std::vector<std::int64_t> own;
      for (std::int64_t i = 0; i < corners; ++i) own.push_back(next());
      add_polygon(own, to);
    }
    if (at != end) fault("the faces of cell " + std::to_string(cell) + " are fewer than its faceoffsets say");
  }

  /// A separate mesh, without faces shared by two cells.
  [[nodiscard]] geometry::Mesh mesh_of(const std::vector<Loop>& loops) const {
    geometry::Mesh mesh;
    std::map<std::int32_t, std::int32_t> number;
    for (const Loop& loop : loops) {
      auto& out = mesh.faces.emplace_back();
      for (const std::int32_t v : loop) {
        const auto [at, is_new] = number.try_emplace(v, static_cast<std::int32_t>(mesh.vertices.size()));
        if (is_new) mesh.vertices.push_back(nth(points_, v));
        out.push_back(at->second);
      }
    }
    return mesh;
  }

  [[nodiscard]] FileSolid solid_of(double key, const std::vector<Loop>& loops) const {
    std::map<Loop, std::size_t> seen;
    for (Loop sorted : loops) {
      std::sort(sorted.begin(), sorted.end());
      ++seen[sorted];
    }
    std::vector<Loop> outer;
    for (const Loop& loop : loops) {
      Loop sorted = loop;
      std::sort(sorted.begin(), sorted.end());
      if (seen[sorted] == 1) outer.push_back(loop);
    }
    FileSolid solid;
    solid.name = key == std::floor(key) && std::abs(key) < 1e15 ? std::to_string(static_cast<std::int64_t>(key)) : std::to_string(key);
    solid.mesh = mesh_of(outer);
    return solid;
  }

  const std::string& path_;
  std::string_view text_;
  VtuArrays arrays_;
  std::int64_t left_over_ = 0;  // of the connectivity
  std::vector<Vec3> points_;
  std::map<double, std::vector<Loop>> cells_;  // faces, by element
  std::vector<Loop> heap_;
  std::int64_t face_at_ = 0;  // start of the faces of the next polyhedron
};

}  // namespace

StoneFile read_vtu(const std::string& path, std::string_view text) { return VtuReader(path, text).read(); }

}  // namespace voussoir::io
