// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/solids/flatten.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "geometry/message.h"
#include "geometry/nth.h"
#include "geometry/solids/face_groups.h"

namespace voussoir::geometry {

namespace {

constexpr double kPlane = 9e-10;                     // of the size, below the 1e-9 of validate()
constexpr double kConverged = 1e-13;                 // of the size, remaining distance at which iteration stops
constexpr int kMostRounds = 2000, kMostMore = 3000;  // iterations with the planes of contacts fixed, and released
constexpr double kSlack = 3e-7;                      // m, allowed distance of a contact from its plane: find_contacts allows 1e-6

/// A plane by one of its points and its normal, so that stones far from the origin keep their digits.
struct Plane {
  Vec3 normal, point;
  bool fixed = false;  // shared with faces of other solids
};

/// The common plane of a group: the mean of its two sides.
Plane plane_of(const FaceGroup& group, const RoughFaces& faces, std::optional<double> base_z) {
  const LoopPlane& first = faces.face[group.faces.front()].plane;
  if (group.on_base) return {{0, 0, 1}, {first.centre.x, first.centre.y, *base_z}, true};
  const auto side = [&](std::size_t f) { return dot(faces.face[f].plane.normal, first.normal) > 0.0 ? 1.0 : -1.0; };
  Vec3 sum;
  for (const std::size_t f : group.faces) sum += side(f) * faces.face[f].plane.area * faces.face[f].plane.normal;
  const Vec3 normal = normalised(sum);
  double height[2] = {0.0, 0.0}, area[2] = {0.0, 0.0};  // of both sides, above the first face
  for (const std::size_t f : group.faces) {
    const LoopPlane& p = faces.face[f].plane;
    const int s = side(f) > 0.0 ? 0 : 1;
    height[s] += p.area * dot(p.centre - first.centre, normal);
    area[s] += p.area;
  }
  const double mean = area[1] > 0.0 ? 0.5 * (height[0] / area[0] + height[1] / area[1]) : height[0] / area[0];
  return {normal, first.centre + mean * normal, true};
}

/// The least-squares shortest step that brings a point onto all planes, as far as the planes meet.
Vec3 step_onto(Vec3 x, const std::vector<const Plane*>& planes) {
  constexpr double kParallel = 1e-6;  // of the largest eigenvalue: smaller ones mean parallel planes
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  for (const Plane* p : planes) {
    const Eigen::Vector3d n(p->normal.x, p->normal.y, p->normal.z);
    a += n * n.transpose();
    b += dot(p->point - x, p->normal) * n;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(a);
  Vec3 step;
  for (int k = 0; k < 3; ++k) {
    const double value = solver.eigenvalues()(k);
    if (value <= kParallel * solver.eigenvalues()(2)) continue;
    const Eigen::Vector3d v = solver.eigenvectors().col(k);
    const double along = v.dot(b) / value;
    step += along * Vec3{v(0), v(1), v(2)};
  }
  return step;
}

/// Moves the vertices of one solid onto the planes of its faces.
class Solid {
 public:
  Solid(Mesh& mesh, std::vector<Plane> planes) : mesh_(mesh), planes_(std::move(planes)), start_(mesh.vertices), size_(diagonal(mesh)) {
    of_vertex_.resize(mesh.vertices.size());
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      for (const std::int32_t v : mesh.faces[f]) nth(of_vertex_, v).push_back(&planes_[f]);
    }
    round_off_ = 4e-16 * norm(mesh.vertices.front());
  }

  /// Iterates to the intersections of the planes. \return the largest remaining distance of a vertex from one of its planes [m]
  double settle() {
    const double enough = kConverged * size_ + round_off_;
    double left = 0.0;
    for (int round = 0; round < kMostRounds + kMostMore; ++round) {
      for (std::size_t v = 0; v < mesh_.vertices.size(); ++v) move(v);
      left = distance();
      if (left <= enough || (round >= kMostRounds && left <= 0.1 * kPlane * size_)) break;
      if (round == kMostRounds && left > kSlack) break;
      fit_planes(round >= kMostRounds);
    }
    return left;
  }

  [[nodiscard]] double moved() const {
    double most = 0.0;
    for (std::size_t v = 0; v < start_.size(); ++v) most = std::max(most, norm(mesh_.vertices[v] - start_[v]));
    return most;
  }

 private:
  /// Refits planes to their vertices. \param all  also planes of contacts, once they are met within kSlack: for corners with more planes
  /// than can meet there
  void fit_planes(bool all) {
    for (std::size_t f = 0; f < planes_.size(); ++f) {
      if (planes_[f].fixed && !all) continue;
      const LoopPlane p = loop_plane(mesh_, f);
      planes_[f] = {p.normal, p.centre, planes_[f].fixed};
    }
  }
  void move(std::size_t v) {
    Vec3& x = mesh_.vertices[v];
    for (int pass = 0; pass < 3; ++pass) {
      double off = 0.0;
      for (const Plane* p : of_vertex_[v]) off = std::max(off, std::abs(dot(x - p->point, p->normal)));
      if (off <= 0.5 * kConverged * size_ + round_off_) return;
      x += step_onto(x, of_vertex_[v]);
    }
  }
  [[nodiscard]] double distance() const {
    double most = 0.0;
    for (std::size_t v = 0; v < of_vertex_.size(); ++v) {
      for (const Plane* p : of_vertex_[v]) most = std::max(most, std::abs(dot(mesh_.vertices[v] - p->point, p->normal)));
    }
    return most;
  }

  Mesh& mesh_;
  std::vector<Plane> planes_;  // by face
  std::vector<std::vector<const Plane*>> of_vertex_;
  std::vector<Vec3> start_;
  double size_, round_off_;
};

/// The greatest warp of the faces of a solid [m]. \throw ModelError if above its snap
double checked_warp(const RoughSolid& s, int subject) {
  double most = 0.0;
  for (std::size_t f = 0; f < s.mesh.faces.size(); ++f) {
    const double w = warp(s.mesh, f);
    if (w > std::max(s.snap, kPlane * diagonal(s.mesh))) {
      throw ModelError(
          block_prefix(subject) + "has a face warped by " + millimetres(w) + " at " + place_text(loop_plane(s.mesh, f).centre) +
              " m (allowed " + millimetres(s.snap) +
              ", stones.snap); part it into triangles (stones.warped = \"triangles\") or make it plane where it was drawn, or raise snap",
          subject);
    }
    most = std::max(most, w);
  }
  return most;
}

/// Target plane of each face of all solids: that of its group, else its own.
std::vector<Plane> planes_of(const RoughFaces& faces, const std::vector<FaceGroup>& groups, std::optional<double> base_z) {
  std::vector<Plane> planes;
  for (const FlatFace& f : faces.face) planes.push_back({f.plane.normal, f.plane.centre, false});
  for (const FaceGroup& g : groups) {
    const Plane common = plane_of(g, faces, base_z);
    for (const std::size_t f : g.faces) {
      planes[f].fixed = true;
      if (!g.exact) planes[f] = common;
    }
  }
  return planes;
}

struct Settled {
  double left = 0.0, moved = 0.0;  // m
};

Settled settle(RoughSolid& s, std::vector<Plane> planes) {
  Solid solid(s.mesh, std::move(planes));
  const double left = solid.settle();
  return {left, solid.moved()};
}

double most_allowed(const RoughSolid& s, const Flattened& done) { return 2.0 * (s.snap + (done.beds.empty() ? 0.0 : s.gap.value_or(0.0))); }

void check(const Settled& done, const RoughSolid& s, double allowed, bool fitted, int subject) {
  const std::string place = place_text(s.mesh.vertices.front());
  if (done.moved > allowed) {
    throw ModelError(block_prefix(subject) + "would have to move a corner by " + millimetres(done.moved) +
                         (fitted ? " to lie against its neighbours" : " to make its faces plane") + " (allowed " + millimetres(allowed) +
                         " with this stones.snap), at " + place +
                         (fitted ? " m; draw the faces that touch in one plane, or lower snap"
                                 : " m; part its faces into triangles, make them plane where it was drawn, or lower snap"),
                     subject);
  }
  if (done.left > kPlane * diagonal(s.mesh)) {
    throw ModelError(
        block_prefix(subject) + "has faces that cannot be made plane together: " + millimetres(done.left) + " are left, at " + place +
            " m; raise stones.snap to a few times the warp of faces that touch, part them into triangles, or make them plane where "
            "it was drawn",
        subject);
  }
}

}  // namespace

std::vector<Flattened> flatten(std::span<RoughSolid> solids, std::optional<double> base_z) {
  std::vector<Flattened> out(solids.size());
  std::vector<std::uint8_t> active(solids.size(), 0), fitted(solids.size(), 0);
  for (std::size_t i = 0; i < solids.size(); ++i) {
    out[i].warped = checked_warp(solids[i], static_cast<int>(i));
    active[i] = out[i].warped > kPlane * diagonal(solids[i].mesh) ? 1 : 0;
  }
  const RoughFaces faces = faces_of(solids);
  const std::vector<FaceGroup> groups = face_groups(solids, faces, base_z);
  const std::vector<Plane> planes = planes_of(faces, groups, base_z);
  for (const FaceGroup& g : groups) {
    for (const std::size_t f : g.faces) {
      const auto i = static_cast<std::size_t>(faces.solid[f]);
      fitted[i] = 1;
      if (!g.exact) active[i] = 1;
      if (!g.bed) continue;
      const double sign = dot(planes[f].normal, faces.face[f].plane.normal) > 0.0 ? 1.0 : -1.0;
      out[i].beds.push_back({sign * planes[f].normal, sign * dot(planes[f].normal, planes[f].point)});
    }
  }
  for (std::size_t i = 0; i < solids.size(); ++i) {
    if (active[i] == 0) continue;
    const auto first = planes.begin() + static_cast<std::ptrdiff_t>(faces.first[i]),
               end = planes.begin() + static_cast<std::ptrdiff_t>(faces.first[i + 1]);
    const Settled done = settle(solids[i], {first, end});
    out[i].moved = done.moved;
    check(done, solids[i], most_allowed(solids[i], out[i]), fitted[i] != 0, static_cast<int>(i));
  }
  return out;
}

}  // namespace voussoir::geometry
