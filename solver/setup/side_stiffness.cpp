// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/setup/side_stiffness.h"

#include <Eigen/Dense>
#include <cmath>

namespace voussoir::solver {

namespace {

using Matrix12 = Eigen::Matrix<double, 12, 12>;
using Relative = Eigen::Matrix<double, 3, 12>;  // relative displacement from the motions of master and slave

Eigen::Vector3d vector(Vec3 v) { return {v.x, v.y, v.z}; }

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0.0, -v(2), v(1), v(2), 0.0, -v(0), -v(1), v(0), 0.0;
  return m;
}

/// u = x_slave − x_master at a point with the arms a and b.
Relative relative_motion(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  Relative u;
  u << -Eigen::Matrix3d::Identity(), cross_matrix(a), Eigen::Matrix3d::Identity(), -cross_matrix(b);
  return u;
}

}  // namespace

double twist_of(const kernels::SideConstants& c, double constant) {
  constexpr double kDigits = 1e-9;  // of second moments: points lie on a raster of 1e-12 m
  const double polar = *c.sss + *c.stt;
  if (polar <= 0.0 || std::abs(constant - polar) <= kDigits * polar) return 0.0;
  return std::sqrt(constant / polar) - 1.0;
}

Stiffness12 side_stiffness(const kernels::Side& side, const kernels::PointsView& points) {
  const Eigen::Vector3d es = vector(side.es), et = vector(side.et), n = es.cross(et);
  const Eigen::Matrix3d d = side.k.ks * Eigen::Matrix3d::Identity() + (side.k.kn - side.k.ks) * n * n.transpose();
  Eigen::Matrix<double, 1, 12> turn = Eigen::Matrix<double, 1, 12>::Zero();  // about n, of the slave less that of the master
  turn.segment<3>(3) = -n.transpose(), turn.segment<3>(9) = n.transpose();
  Stiffness12 sum{};
  Eigen::Map<Matrix12> k(sum.data());
  for (int i = 0; i < points.n; ++i) {
    const Eigen::Vector3d at = points.s[i] * es + points.t[i] * et;
    Relative b = relative_motion(vector(side.ca) + at, vector(side.cb) + at);
    if (side.twist != 0.0) b.noalias() += side.twist * n.cross(at) * turn;
    k.noalias() += side.factor * points.area[i] * b.transpose() * d * b;
  }
  return sum;
}

}  // namespace voussoir::solver
