// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string>

#include "geometry/vec3.h"
#include "io/input/files/errors.h"
#include "io/input/files/hdf5_file.h"
#include "io/output/replay/covered_faces.h"
#include "io/output/replay/joint_cracks.h"

namespace voussoir::io {
namespace {

struct Corner {
  Vec3 at;
  bool on_surface;  // of the edge from here to the next corner
};
using Polygon = std::vector<Corner>;

constexpr double kOnFace = 1e-7;     // m
constexpr double kParallel = 0.999;  // cosine above which a face is parallel to the joint and cuts nothing off

/// The part of a convex polygon with normal·p <= distance. \param on_surface  property of the new edge
Polygon cut(const Polygon& polygon, Vec3 normal, double distance, bool on_surface) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double at_p = dot(normal, p.at) - distance, at_q = dot(normal, q.at) - distance;
    const bool on_face = std::abs(at_p) <= kOnFace && std::abs(at_q) <= kOnFace;  // two faces at one edge: either may be the surface
    if (at_p <= kOnFace)
      kept.push_back({p.at, on_face ? p.on_surface || on_surface : at_q > kOnFace && at_p > -kOnFace ? on_surface : p.on_surface});
    if ((at_p < -kOnFace && at_q > kOnFace) || (at_p > kOnFace && at_q < -kOnFace))
      kept.push_back({p.at + (at_p / (at_p - at_q)) * (q.at - p.at), at_p < 0 ? on_surface : p.on_surface});
  }
  return kept;
}

/// A square about a point, perpendicular to a unit normal.
Polygon square(Vec3 centre, Vec3 normal, double half) {
  const Vec3 aside = std::abs(normal.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  Vec3 u = cross(normal, aside);
  u = (half / norm(u)) * u;
  const Vec3 v = cross(normal, u);
  return {{centre - u - v, false}, {centre + u - v, false}, {centre + u + v, false}, {centre - u + v, false}};
}

struct Faces {
  std::vector<std::int32_t> element;
  std::vector<double> normal, distance, centre;
  std::vector<std::int32_t> first;    // of each element
  std::vector<std::uint8_t> covered;  // 1: entirely covered by joints

  Faces(const Hdf5File& run, DryJoints dry)
      : element(run.read<std::int32_t>("/model/face/element")),
        normal(run.read<double>("/model/face/normal")),
        distance(run.read<double>("/model/face/distance")),
        centre(run.read<double>("/model/element/position0")),
        first(run.read<std::int32_t>("/model/element/first_face")) {
    if (normal.size() != 3 * element.size() || distance.size() != element.size() || centre.size() != 3 * first.size())
      throw FileError(run.path(), "/model/face does not fit together");
    covered = covered_face_rows(run, dry);
  }
  /// Cuts a polygon, which lies on the face of element e with normal `along`, by the other faces of e.
  [[nodiscard]] Polygon within(std::int32_t e, Vec3 along, Polygon polygon) const {
    const auto of = static_cast<std::size_t>(e);
    const Vec3 c{centre[3 * of], centre[3 * of + 1], centre[3 * of + 2]};
    for (auto f = static_cast<std::size_t>(first[of]); f < element.size() && element[f] == e; ++f) {
      const Vec3 n{normal[3 * f], normal[3 * f + 1], normal[3 * f + 2]};
      if (std::abs(dot(n, along)) < kParallel) polygon = cut(polygon, n, distance[f] + dot(n, c), covered[f] == 0);
    }
    return polygon;
  }
};

/// The areas shared by the two elements of joints.
std::vector<Polygon> shared_areas(const Hdf5File& run, const std::vector<std::size_t>& joints, DryJoints dry) {
  const Faces faces(run, dry);
  const auto a = run.read<std::int32_t>("/model/joint/element_a"), b = run.read<std::int32_t>("/model/joint/element_b");
  const auto centre = run.read<double>("/model/joint/centre"), normal = run.read<double>("/model/joint/normal");
  if (b.size() != a.size() || centre.size() != 3 * a.size() || normal.size() != 3 * a.size())
    throw FileError(run.path(), "/model/joint does not fit together");
  const auto elements = static_cast<std::int64_t>(faces.first.size());
  std::vector<Polygon> all;
  for (const std::size_t j : joints) {
    if (a[j] < 0 || a[j] >= elements || b[j] >= elements)
      throw FileError(run.path(), "/model/joint: row " + std::to_string(j) + " refers to no element");
    const Vec3 n{normal[3 * j], normal[3 * j + 1], normal[3 * j + 2]};
    constexpr double kFar = 1e3;  // m; beyond any face
    Polygon p = faces.within(a[j], n, square({centre[3 * j], centre[3 * j + 1], centre[3 * j + 2]}, n, kFar));
    if (b[j] >= 0) p = faces.within(b[j], n, std::move(p));
    all.push_back(std::move(p));
  }
  return all;
}

}  // namespace

std::vector<std::vector<JointEdge>> joint_edges(const Hdf5File& run, const std::vector<std::size_t>& joints, DryJoints dry) {
  std::vector<std::vector<JointEdge>> all;
  for (const Polygon& p : shared_areas(run, joints, dry)) {
    auto& edges = all.emplace_back();
    for (std::size_t i = 0; i < p.size(); ++i)
      if (p[i].on_surface) edges.push_back({p[i].at, p[(i + 1) % p.size()].at});
  }
  return all;
}

std::vector<std::vector<Vec3>> joint_corners(const Hdf5File& run, const std::vector<std::size_t>& joints) {
  std::vector<std::vector<Vec3>> all;
  for (const Polygon& p : shared_areas(run, joints, DryJoints::open)) {
    auto& corners = all.emplace_back();
    for (const Corner& c : p) corners.push_back(c.at);
  }
  return all;
}

}  // namespace voussoir::io
