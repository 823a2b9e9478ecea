// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "io/input/files/errors.h"
#include "io/input/files/text_file.h"
#include "io/input/stones/stone_file.h"

namespace voussoir::io {
namespace {

using Json = nlohmann::ordered_json;  // keeps the order of the file

constexpr int kDeepest = 200;
constexpr std::array<std::string_view, 2> kCopies{"convex_hull", "geometry_simplified"};  // of an element, beside its geometry

const Json* member(const Json& of, const char* name) {
  if (!of.is_object()) return nullptr;
  const auto at = of.find(name);
  return at == of.end() ? nullptr : &*at;
}

std::string text_of(const Json* value) { return value != nullptr && value->is_string() ? value->get<std::string>() : std::string(); }

/// A 4 × 4 matrix by rows.
using Matrix = std::array<std::array<double, 4>, 4>;

/// Whether a type is that of a solid which is no shape of this program, or of a shape without its data.
bool is_other_solid(const std::string& type) {
  constexpr std::array<std::string_view, 12> kSolids{"Sphere",  "Cylinder",  "Cone", "Torus",      "Capsule", "Ellipsoid",
                                                     "OCCBrep", "RhinoBrep", "Brep", "Polyhedron", "Mesh",    "Box"};
  return std::ranges::find(kSolids, std::string_view(type).substr(type.rfind('/') + 1)) != kSolids.end();
}

class CompasReader {
 public:
  explicit CompasReader(const std::string& path) : path_(path) {}

  StoneFile read(std::string_view text) {
    Json root;
    try {
      root = Json::parse(text.begin(), text.end());
    } catch (const Json::exception& e) {
      throw FileError(path_, std::string("is no JSON: ") + e.what());
    }
    walk(root, {}, 0);
    name_solids();
    for (const auto& [type, count] : left_out_)
      out_.doubts.push_back("left out: " + std::to_string(count) + " of " + shown(type) + ", which are no mesh, polyhedron or box");
    if (passed_over_ > 0) out_.notes.push_back("passed over: " + std::to_string(passed_over_) + " interfaces");
    if (copies_ > 0) out_.notes.push_back("passed over: " + std::to_string(copies_) + " hulls or simplified copies of elements");
    if (out_.solids.empty()) throw FileError(path_, "holds no mesh, polyhedron or box of COMPAS (an object with dtype and data)");
    return std::move(out_);
  }

 private:
  /// Names of a shape derived from its surroundings.
  struct Around {
    std::string key;   // of the node, or index in a list
    std::string name;  // of the element that contains the shape
    bool support = false;
    std::optional<Matrix> transformation;
  };

  [[noreturn]] void fault(const Around& at, const std::string& what) const {
    throw FileError(path_, (at.key.empty() ? std::string("a mesh ") : "mesh \"" + at.key + "\" ") + what);
  }

  void walk(const Json& j, Around around, int depth) {
    if (depth > kDeepest) throw FileError(path_, "is nested too deep");
    if (j.is_array()) {
      for (std::size_t i = 0; i < j.size(); ++i) {
        Around inner = around;
        if (j[i].is_object()) inner.key = around.key.empty() ? std::to_string(i) : around.key;
        walk(j[i], std::move(inner), depth + 1);
      }
      return;
    }
    if (!j.is_object()) return;
    const std::string type = text_of(member(j, "dtype"));
    if (type.find("Interface") != std::string::npos || type.find("Contact") != std::string::npos) {
      ++passed_over_;
      return;
    }
    if (const Json* support = member(j, "is_support"); support != nullptr && support->is_boolean()) around.support = support->get<bool>();
    if (const Json* name = member(j, "name"); name != nullptr && name->is_string()) around.name = name->get<std::string>();
    if (const Json* t = member(j, "transformation"); t != nullptr && t->is_object()) {
      around.transformation = matrix(*t);
      if (!around.transformation) fault(around, "has a transformation without a matrix of four rows of four numbers");
    }
    const Json* data = member(j, "data");
    if (add_shape(data != nullptr ? *data : j, type, around)) return;
    const std::size_t before = out_.solids.size();
    walk_members(j, around, depth);
    if (is_other_solid(type) && out_.solids.size() == before) ++left_out_[type];
  }

  /// The solids of an element's geometry, beside which files may hold the same solid as a hull and simplified. \return whether there are any
  bool walk_geometry(const Json& j, const Around& around, int depth) {
    const Json* geometry = member(j, "geometry");
    const bool copied = std::ranges::any_of(kCopies, [&](std::string_view key) { return member(j, key.data()) != nullptr; });
    if (geometry == nullptr || !copied) return false;
    const std::size_t before = out_.solids.size();
    walk(*geometry, around, depth + 1);
    return out_.solids.size() > before;
  }

  void walk_members(const Json& j, const Around& around, int depth) {
    const bool done = walk_geometry(j, around, depth);
    for (const auto& [key, value] : j.items()) {
      if (done && key == "geometry") continue;
      if (done && std::ranges::find(kCopies, key) != kCopies.end()) {
        if (value.is_structured() && !value.empty()) ++copies_;
        continue;
      }
      if (key == "interfaces" || key == "contacts") {
        passed_over_ += value.is_array() ? value.size() : 0;
        continue;
      }
      if (key == "node" && value.is_object()) {
        walk_nodes(value, around, depth + 1);
      } else if (value.is_structured()) {
        walk(value, around, depth + 1);
      }
    }
  }

  /// Walks through nodes of a graph, whose keys are names.
  void walk_nodes(const Json& nodes, const Around& around, int depth) {
    for (const auto& [key, node] : nodes.items()) {
      Around inner = around;
      inner.key = key;
      inner.name.clear();
      walk(node, std::move(inner), depth);
    }
  }

  static std::optional<Matrix> matrix(const Json& transformation) {
    const Json* data = member(transformation, "data");
    const Json* rows = data == nullptr ? member(transformation, "matrix") : member(*data, "matrix");
    if (rows == nullptr || !rows->is_array() || rows->size() != 4) return std::nullopt;
    Matrix m{};
    for (std::size_t i = 0; i < 4; ++i) {
      if (!(*rows)[i].is_array() || (*rows)[i].size() != 4) return std::nullopt;
      for (std::size_t k = 0; k < 4; ++k) {
        if (!(*rows)[i][k].is_number()) return std::nullopt;
        m[i][k] = (*rows)[i][k].get<double>();
      }
    }
    return m;
  }

  /// Adds a shape. \return whether `data` is one
  bool add_shape(const Json& data, const std::string& type, const Around& around) {
    const Json *vertex = member(data, "vertex"), *face = member(data, "face");
    geometry::Mesh mesh;
    if (vertex != nullptr && face != nullptr && vertex->is_object() && face->is_object()) {
      mesh = mesh_of(*vertex, *face, around);
    } else if (const Json* points = member(data, "vertices"), *loops = member(data, "faces");
               points != nullptr && loops != nullptr && points->is_array() && loops->is_array()) {
      mesh = polyhedron_of(*points, *loops, around);
    } else if (type.ends_with("/Box") && member(data, "frame") != nullptr) {
      mesh = box_of(data, around);
    } else {
      return false;
    }
    if (around.transformation) apply(*around.transformation, mesh);
    if (!std::ranges::all_of(mesh.vertices, [](Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }))
      fault(around, "has corners that are no finite numbers once it is in its place");
    FileSolid solid;
    solid.mesh = std::move(mesh);
    solid.support = around.support;
    out_.solids.push_back(std::move(solid));
    around_.push_back(around);
    return true;
  }

  double number(const Json* value, const Around& at) const {
    if (value == nullptr || !value->is_number() || !std::isfinite(value->get<double>()))
      fault(at, "has a coordinate that is no finite number");
    return value->get<double>();
  }
  Vec3 point(const Json& value, const Around& at) const {
    const Json* inner = member(value, "data");  // a compas.geometry/Point
    const Json& p = inner == nullptr ? value : *inner;
    if (!p.is_array() || p.size() != 3) fault(at, "has a point that is no [x, y, z]");
    return {number(&p[0], at), number(&p[1], at), number(&p[2], at)};
  }

  geometry::Mesh mesh_of(const Json& vertex, const Json& face, const Around& at) const {
    geometry::Mesh mesh;
    std::map<std::string, std::int32_t> number_of;
    for (const auto& [key, attributes] : vertex.items()) {
      number_of[key] = static_cast<std::int32_t>(mesh.vertices.size());
      const auto part = [&, &of = attributes](const char* axis) {
        return member(of, axis) == nullptr ? 0.0 : number(member(of, axis), at);
      };
      mesh.vertices.push_back({part("x"), part("y"), part("z")});
    }
    for (const auto& [key, loop] : face.items()) {
      if (!loop.is_array() || loop.size() < 3) fault(at, "has a face of fewer than 3 corners");
      auto& out = mesh.faces.emplace_back();
      for (const Json& v : loop) {
        const auto found = number_of.find(v.is_string() ? v.get<std::string>() : v.dump());
        if (found == number_of.end()) fault(at, "has a face with the vertex " + shown(v.dump()) + ", which is not there");
        out.push_back(found->second);
      }
    }
    return mesh;
  }

  geometry::Mesh polyhedron_of(const Json& points, const Json& loops, const Around& at) const {
    geometry::Mesh mesh;
    for (const Json& p : points) mesh.vertices.push_back(point(p, at));
    for (const Json& loop : loops) {
      if (!loop.is_array() || loop.size() < 3) fault(at, "has a face of fewer than 3 corners");
      auto& out = mesh.faces.emplace_back();
      for (const Json& v : loop) {
        if (!v.is_number_integer() || v.get<std::int64_t>() < 0 || v.get<std::int64_t>() >= static_cast<std::int64_t>(mesh.vertices.size()))
          fault(at, "has a face with the vertex " + shown(v.dump()) + ", which is not there");
        out.push_back(v.get<std::int32_t>());
      }
    }
    return mesh;
  }

  geometry::Mesh box_of(const Json& data, const Around& at) const {
    const Json& frame_object = *member(data, "frame");
    const Json* inner = member(frame_object, "data");
    const Json& frame = inner == nullptr ? frame_object : *inner;
    for (const char* key : {"point", "xaxis", "yaxis"}) {
      if (member(frame, key) == nullptr) fault(at, std::string("is a box whose frame has no ") + key);
    }
    const Vec3 centre = point(*member(frame, "point"), at), x = point(*member(frame, "xaxis"), at), y = point(*member(frame, "yaxis"), at);
    if (norm(cross(x, y)) == 0.0) fault(at, "is a box whose axes are parallel");
    const Vec3 ex = normalised(x), ez = normalised(cross(x, y)), ey = cross(ez, ex);
    const double size[3] = {number(member(data, "xsize"), at), number(member(data, "ysize"), at), number(member(data, "zsize"), at)};
    const auto unit = geometry::make_box({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
    geometry::Mesh mesh{{}, unit.faces};
    for (const Vec3& v : unit.vertices)
      mesh.vertices.push_back(centre + (v.x * size[0]) * ex + (v.y * size[1]) * ey + (v.z * size[2]) * ez);
    return mesh;
  }

  static void apply(const Matrix& m, geometry::Mesh& mesh) {
    for (Vec3& v : mesh.vertices) {
      const auto row = [&](std::size_t i) { return m[i][0] * v.x + m[i][1] * v.y + m[i][2] * v.z + m[i][3]; };
      v = {row(0), row(1), row(2)};
    }
  }

  /// Names the solids by their own names if all have one and all differ, else by node or index.
  void name_solids() {
    const auto all_different = [&](std::string Around::*member) {
      std::map<std::string, int> seen;
      for (const Around& a : around_) {
        if ((a.*member).empty() || ++seen[a.*member] > 1) return false;
      }
      return true;
    };
    const bool by_name = all_different(&Around::name), by_key = all_different(&Around::key);
    for (std::size_t i = 0; i < around_.size(); ++i) {
      out_.solids[i].name = by_name ? around_[i].name : by_key ? around_[i].key : std::to_string(i);
    }
  }

  const std::string& path_;
  StoneFile out_;
  std::vector<Around> around_;  // by solid
  std::size_t passed_over_ = 0, copies_ = 0;
  std::map<std::string, std::size_t> left_out_;  // solids of other kinds, by type
};

}  // namespace

StoneFile read_compas(const std::string& path, std::string_view text) { return CompasReader(path).read(text); }

}  // namespace voussoir::io
