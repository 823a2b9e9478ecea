// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <span>
#include <vector>

#include "cases/model.h"
#include "geometry/nth.h"
#include "solver/setup/setup.h"
#include "solver/setup/worst_dashpots.h"

// Contact dashpots with h = 1 would need a step well under Eq. 19, because their velocities lag by half a step. They are taken
// semi-implicitly (THEORY.md (20)), c' = c / (1 + Δt (β_A + β_B)), where β bounds the damping rate of a body. Here: the largest eigenvalue
// of M⁻¹C when the dashpots of all its segments act at once, and bounds for each of its faces alone, of which the faces that have something
// near make the β of now (contact/near_faces.h). Then the damping matrix of the whole assembly has Δt λ_max(M⁻¹C') < 1 for
// whatever faces touch at the stiffness of Eq. 2 (that of a joint with mortar stiffer than its blocks is not asked). A sum over the
// dashpots of c dA (1/m + r²/I_min) is a bound too, but three times as large, and would cost effective damping.
namespace voussoir::solver {

namespace {

/// The distinct kinds of faces in the model: whatever a face may come to touch, but for the ground.
std::vector<FaceClass> face_classes(const std::vector<kernels::Face>& faces) {
  std::set<FaceClass> classes;
  for (const kernels::Face& f : faces) {
    if (!f.is_ground()) classes.insert({f.compliance_n, f.compliance_s, f.mass});
  }
  return {classes.begin(), classes.end()};
}

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Damping matrices of all elements, filled segment by segment or face by face.
class DampingMatrices {
 public:
  explicit DampingMatrices(World& w) : w_(w), c_(static_cast<std::size_t>(w.elements.count), Matrix6::Zero()) {
    const std::vector<FaceClass> classes = face_classes(w.faces);
    const std::vector<std::array<double, 2>> worst = worst_dashpots(classes, w.contact.damping, w.team);
    for (const kernels::Face& f : w.faces) {
      if (f.is_ground()) {
        dashpot_.push_back({});
        continue;
      }
      const FaceClass k{f.compliance_n, f.compliance_s, f.mass};
      dashpot_.push_back(nth(worst, std::lower_bound(classes.begin(), classes.end(), k) - classes.begin()));
    }
  }

  void add(std::int32_t element, std::int32_t face, const geometry::Frame& f, geometry::SegmentList segments) {
    const Eigen::Matrix3d c = dashpots(element, face, f.normal);
    for (const geometry::Segment& s : segments)
      nth(c_, element) += of_point(element, c, f.centre + s.s * f.axis_s + s.t * f.axis_t, s.area);
  }

  void add_whole(std::int32_t element, std::int32_t face) {
    for_each_third(element, face, [&](const Matrix6& c) { nth(c_, element) += c; });
  }

  [[nodiscard]] double rate(std::size_t i) const {
    return Eigen::GeneralizedSelfAdjointEigenSolver<Matrix6>(c_[i], mass_matrix(i), Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
  }

  /// Upper bounds of the rates of the faces of an element, each alone, to World::dashpot_bounds: the 64th root of the sum of the 64th
  /// powers of the six eigenvalues, which exceeds the largest by less than 3 % and needs no decomposition.
  void bound_faces(std::size_t i) {
    const Matrix6 inverse = mass_matrix(i).inverse();
    for (std::int32_t f = 0; f < w_.elements.face_count[i]; ++f) {
      Matrix6 power = Matrix6::Zero();
      for_each_third(static_cast<std::int32_t>(i), f, [&](const Matrix6& third) { power += third; });
      power = inverse * power;
      const double sum = power.trace();
      if (!(sum > 0.0)) continue;
      power /= sum;
      for (int k = 0; k < 6; ++k) power = power * power;
      nth(w_.dashpot_bounds.face, w_.elements.first_face[i] + f) = sum * std::pow(power.trace(), 1.0 / 64);
    }
  }

 private:
  [[nodiscard]] Matrix6 mass_matrix(std::size_t i) const {
    const geometry::Element& g = w_.model.assembly.elements[i];
    const double mass = w_.elements.mass[i], density = mass / g.mass.volume;
    const Mat3& inertia = g.mass.inertia;
    Matrix6 m = Matrix6::Zero();
    m.topLeftCorner<3, 3>() = mass * Eigen::Matrix3d::Identity();
    m.bottomRightCorner<3, 3>() << inertia.r0.x, inertia.r0.y, inertia.r0.z, inertia.r1.x, inertia.r1.y, inertia.r1.z, inertia.r2.x,
        inertia.r2.y, inertia.r2.z;
    m.bottomRightCorner<3, 3>() *= density;
    return m;
  }

  /// Calls `each(C)` for matrices that add up to that of a whole face. It takes second moments alone, for which the middles of the edges of
  /// triangles are exact. With points up to the rim the points of a face depend on how its free part was cut into convex pieces, and so on
  /// the order of its corners.
  template <class Each>
  void for_each_third(std::int32_t element, std::int32_t face, Each each) const {
    const geometry::Polyhedron& shape = nth(w_.model.blocks, element).shape;
    const auto corner = [&](std::int32_t i) { return nth(shape.vertices, i); };
    const auto& loop = nth(shape.faces, face);
    const Vec3 n = nth(w_.model.assembly.faces, nth(w_.model.assembly.elements, element).first_face + face).normal;
    const Eigen::Matrix3d c = dashpots(element, face, n);
    for (std::size_t i = 2; i < loop.size(); ++i) {
      const Vec3 p = corner(loop[0]), q = corner(loop[i - 1]), r = corner(loop[i]);
      const double third = dot(cross(q - p, r - p), n) / 6.0;
      for (const Vec3 at : {0.5 * (p + q), 0.5 * (q + r), 0.5 * (r + p)}) each(of_point(element, c, at, third));
    }
  }

  /// Largest dashpots of a face [Pa s/m].
  [[nodiscard]] Eigen::Matrix3d dashpots(std::int32_t element, std::int32_t face, Vec3 normal) const {
    const auto [cn, cs] = nth(dashpot_, nth(w_.model.assembly.elements, element).first_face + face);
    const Eigen::Vector3d n(normal.x, normal.y, normal.z);
    return cs * Eigen::Matrix3d::Identity() + (cn - cs) * n * n.transpose();
  }

  [[nodiscard]] Matrix6 of_point(std::int32_t element, const Eigen::Matrix3d& c, Vec3 at, double area) const {
    const Vec3 r = at - nth(w_.model.assembly.elements, element).mass.centroid;
    Eigen::Matrix<double, 3, 6> j;  // velocity of the point from (v, ω)
    j << Eigen::Matrix3d::Identity(), (Eigen::Matrix3d() << 0, r.z, -r.y, -r.z, 0, r.x, r.y, -r.x, 0).finished();
    return area * (j.transpose() * c * j);
  }

  World& w_;
  std::vector<Matrix6> c_;
  std::vector<std::array<double, 2>> dashpot_;  // c_n, c_s by face
};

/// Adds the segments of elements first to last − 1.
void add_segments(const geometry::Assembly& a, DampingMatrices& matrices, std::int64_t first, std::int64_t last) {
  const auto add = [&](std::int32_t element, std::int32_t face, const geometry::Frame& frame, geometry::SegmentList segments) {
    if (first <= element && element < last) matrices.add(element, face, frame, segments);
  };
  for (const geometry::Joint& j : a.joints) {
    add(j.element_a, j.face_a, j.frame(), j.side_a);
    if (j.element_b != geometry::kBase) add(j.element_b, j.face_b, j.frame(), j.merged ? j.side_a : j.side_b);
  }
  for (const geometry::FreePatch& p : a.patches) add(p.element, p.face, p.frame(), p.segments);
}

}  // namespace

void set_up_damping_bound(World& w) {
  const geometry::Assembly& a = w.model.assembly;
  DampingMatrices matrices(w);
  w.dashpot_bounds.all.assign(w.elements.body.size(), 0.0), w.dashpot_bounds.face.assign(w.faces.size(), 0.0);
  // Each range goes through all joints and adds to its own elements alone, so every element gets its segments in one order.
  const std::int64_t at_a_time = (w.elements.count + w.team.size() - 1) / w.team.size();
  w.team.share_out(w.elements.count, std::max<std::int64_t>(at_a_time, 1), [&](std::int64_t first, std::int64_t last) {
    if (a.rule != geometry::SegmentRule::centres) {
      for (std::int64_t i = first; i < last; ++i) {
        for (std::int32_t f = 0; f < a.elements[static_cast<std::size_t>(i)].face_count; ++f)
          matrices.add_whole(static_cast<std::int32_t>(i), f);
      }
    } else {
      add_segments(a, matrices, first, last);
    }
    for (std::int64_t i = first; i < last; ++i) {
      const auto e = static_cast<std::size_t>(i);
      if (w.elements.fixed[e]) continue;
      w.dashpot_bounds.all[e] = w.elements.body[e].beta = matrices.rate(e);
      matrices.bound_faces(e);
    }
  });
}

}  // namespace voussoir::solver
