// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/equilibrium/masses.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/nth.h"
#include "solver/world/first_touch.h"

namespace voussoir::solver {

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Lever = Eigen::Matrix<double, 3, 6>;  // displacement of a point from displacement and rotation of its element

constexpr double kOfStep = 0.8;  // of 4/Δt², for joints, free points and ties; the loading spring and overlaps need the rest

Eigen::Vector3d vector(Vec3 v) { return {v.x, v.y, v.z}; }

Lever lever(Vec3 r) {
  Lever j;
  j << Eigen::Matrix3d::Identity(), (Eigen::Matrix3d() << 0.0, r.z, -r.y, -r.z, 0.0, r.x, r.y, -r.x, 0.0).finished();
  return j;
}

/// Normal and shear stiffness per area [Pa/m].
struct Pair {
  double n = 0.0, s = 0.0;
};

/// What bounds the springs of each element as if all others were fixed: THEORY.md (33).
class Bounds {
 public:
  explicit Bounds(const World& w) : w_(w), k_(static_cast<std::size_t>(w.elements.count), Matrix6::Zero()) {
    add_sides();
    add_patches();
    add_ties();
  }

  [[nodiscard]] const Matrix6& of(std::size_t i) const { return k_[i]; }

 private:
  [[nodiscard]] const kernels::Face& face(std::int32_t f) const { return nth(w_.faces, f); }

  void add_point(Matrix6& sum, Vec3 arm, Vec3 normal, Pair k, double area) const {
    const Eigen::Vector3d n = vector(normal);
    const Lever j = lever(arm);
    sum.noalias() += area * (j.transpose() * (k.s * Eigen::Matrix3d::Identity() + (k.n - k.s) * n * n.transpose()) * j);
  }

  void add_points(std::int32_t element, Vec3 centre, Vec3 es, Vec3 et, Pair k, double factor, const kernels::PointsView& p) {
    if (element == w_.elements.base || nth(w_.elements.fixed, element) != 0) return;
    Matrix6 sum = Matrix6::Zero();
    for (int i = 0; i < p.n; ++i) add_point(sum, centre + p.s[i] * es + p.t[i] * et, cross(es, et), k, factor * p.area[i]);
    nth(k_, element) += sum;
  }

  /// A joint k̄ between faces of the compliances C_A and C_B stores no more than ½ k̄ (1 + C_B/C_A) a² + ½ k̄ (1 + C_A/C_B) b².
  [[nodiscard]] Pair share(kernels::Stiffness k, const kernels::Face& own, const kernels::Face& other) const {
    if (own.is_ground()) return {};
    return {k.kn * (1.0 + other.compliance_n / own.compliance_n), k.ks * (1.0 + other.compliance_s / own.compliance_s)};
  }

  void add_sides() {
    for (std::int64_t id = 0; id < w_.sides.count(); ++id) {
      const auto i = static_cast<std::size_t>(id);
      if (w_.sides.joint[i] < 0 || w_.sides.retired[i] != 0) continue;
      const kernels::Side s = w_.sides.side(id);
      const kernels::Face &a = face(w_.sides.master_face[i]), &b = face(w_.sides.slave_face[i]);
      kernels::Stiffness k = s.k;
      if (s.laws->closing.on()) k.kn = s.laws->closing.blocks;  // what it comes to under pressure
      k.ks *= std::max(1.0, (1.0 + s.twist) * (1.0 + s.twist));
      const kernels::PointsView p = w_.points.view(w_.sides.set[i]);
      add_points(s.master, s.ca, s.es, s.et, share(k, a, b), s.factor, p);
      add_points(s.slave, s.cb, s.es, s.et, share(k, b, a), s.factor, p);
    }
  }

  /// Whatever meets them, a rigid face at the stiffest.
  void add_patches() {
    for (const FreePatch& p : w_.patches.patch) {
      const kernels::Face& own = face(p.face);
      if (own.is_ground()) continue;
      add_points(p.element, p.centre, p.es, p.et, {1.0 / own.compliance_n, 1.0 / own.compliance_s}, 1.0, w_.points.view(p.set));
    }
  }

  /// As THEORY.md (32), in any direction.
  void add_ties() {
    const Ties& ties = w_.ties;
    const auto moves = [&](const Ties::Hold& h) { return h.element != w_.elements.base && nth(w_.elements.fixed, h.element) == 0; };
    std::vector<double> moving(ties.tie.size(), 0.0);
    for (const Ties::Hold& h : ties.hold) nth(moving, h.tie) += moves(h) ? std::abs(h.share) : 0.0;
    for (const Ties::Hold& h : ties.hold) {
      if (!moves(h)) continue;
      const double k = nth(moving, h.tie) * std::abs(h.share) * nth(ties.tie, h.tie).law.stiffness;
      add_point(nth(k_, h.element), h.arm, {}, {k, k}, 1.0);
    }
  }

  const World& w_;
  std::vector<Matrix6> k_;
};

double largest(const Eigen::Matrix3d& m) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m, Eigen::EigenvaluesOnly).eigenvalues()(2);
}

void assign(Inert& inert, const Elements& e, Team& team) {
  const auto rows = static_cast<std::size_t>(e.rows);
  for (Array<double>* a : {&inert.mass, &inert.inv_mass, &inert.inv_inertia, &inert.zeros}) assign_in_shares(*a, rows, 0.0, team);
  inert.principal.assign(rows / kernels::kBatch, 1);
}

}  // namespace

void find_inert_masses(World& w) {
  Elements& e = w.elements;
  if (!e.inert.any()) assign(e.inert, e, w.team);
  const Bounds bounds(w);
  const double step = 0.25 * w.dt * w.dt / kOfStep;
  for (std::size_t i = 0; i < static_cast<std::size_t>(e.count); ++i) {
    if (e.fixed[i]) continue;
    const Matrix6& k = bounds.of(i);
    const double translation = largest(k.topLeftCorner<3, 3>()), rotation = largest(k.bottomRightCorner<3, 3>());
    if (!(translation > 0.0)) {  // nothing ever touches it
      e.inert.mass[i] = e.mass[i], e.inert.inv_mass[i] = e.inv_mass[i];
      continue;
    }
    const double arm2 = rotation / translation;  // m2, of inertia over mass
    Matrix6 scaled = k;
    scaled.rightCols<3>() /= std::sqrt(arm2), scaled.bottomRows<3>() /= std::sqrt(arm2);
    const double mass = step * Eigen::SelfAdjointEigenSolver<Matrix6>(scaled, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
    e.inert.mass[i] = mass, e.inert.inv_mass[i] = 1.0 / mass;
    e.inert.inv_inertia[i] = e.ixx[i] > 0.0 ? 1.0 / (mass * arm2) : 0.0;  // 0: held level
  }
}

}  // namespace voussoir::solver
