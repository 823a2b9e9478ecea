// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mass.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>

#include "geometry/nth.h"

namespace voussoir::geometry {

namespace {

/// ∫dV, ∫x dV and ∫x xᵀ dV about a local origin.
struct Moments {
  double volume = 0.0;
  Vec3 first;
  Mat3 second = Mat3::zero();
};

/// Moments by the divergence theorem, as a sum over the tetrahedra between `origin` and the triangles of every face.
Moments moments(const Polyhedron& p, Vec3 origin) {
  Moments m;
  for (const auto& loop : p.faces) {
    const auto at = [&](std::size_t i) { return nth(p.vertices, loop[i]) - origin; };
    const Vec3 a = at(0);
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      const Vec3 b = at(i), c = at(i + 1);
      const double six_volumes = dot(a, cross(b, c));
      const Vec3 sum = a + b + c;
      m.volume += six_volumes / 6.0;
      m.first += (six_volumes / 24.0) * sum;
      m.second = m.second + (six_volumes / 120.0) * (outer(a, a) + outer(b, b) + outer(c, c) + outer(sum, sum));
    }
  }
  return m;
}

Vec3 mean_vertex(const Polyhedron& p) {
  const Vec3 first = p.vertices.front();
  Vec3 sum;
  for (const Vec3& v : p.vertices) sum += v - first;
  return first + sum / static_cast<double>(p.vertices.size());
}

/// Inertia tr(S) − S, with off-diagonal round-off set to zero, so that boxes stay exactly diagonal.
Mat3 inertia_of(const Mat3& second) {
  const double xx = second.r0.x, yy = second.r1.y, zz = second.r2.z;
  const double least = 1e-14 * std::max({yy + zz, xx + zz, xx + yy});
  const auto snapped = [&](double off) { return std::abs(off) <= least ? 0.0 : -off; };
  const double xy = snapped(second.r0.y), xz = snapped(second.r0.z), yz = snapped(second.r1.z);
  return {{yy + zz, xy, xz}, {xy, xx + zz, yz}, {xz, yz, xx + yy}};
}

void diagonal_axes(MassProperties& m) {
  constexpr std::array<Vec3, 3> kUnit{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const std::array<double, 3> moment{m.inertia.r0.x, m.inertia.r1.y, m.inertia.r2.z};
  std::array<int, 3> order{0, 1, 2};
  // Equal moments up to round-off (a cube) keep the order x, y, z wherever the block lies.
  const double tie = 1e-12 * *std::max_element(moment.begin(), moment.end());
  for (int pass = 0; pass < 2; ++pass) {
    for (int i = 0; i < 2; ++i) {
      if (moment[order[i]] > moment[order[i + 1]] + tie) std::swap(order[i], order[i + 1]);
    }
  }
  m.principal = {moment[order[0]], moment[order[1]], moment[order[2]]};
  m.axes.r0 = kUnit[order[0]];
  m.axes.r1 = kUnit[order[1]];
  m.axes.r2 = cross(m.axes.r0, m.axes.r1);
}

/// Fixes the sign of an eigenvector, which is arbitrary: its largest component is made positive.
Vec3 with_fixed_sign(Vec3 v) {
  double largest = v.x;
  if (std::abs(v.y) > std::abs(largest)) largest = v.y;
  if (std::abs(v.z) > std::abs(largest)) largest = v.z;
  return largest < 0.0 ? -v : v;
}

void general_axes(MassProperties& m) {
  Eigen::Matrix3d matrix;
  const Mat3& t = m.inertia;
  matrix << t.r0.x, t.r0.y, t.r0.z, t.r1.x, t.r1.y, t.r1.z, t.r2.x, t.r2.y, t.r2.z;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
  const auto& vectors = solver.eigenvectors();
  m.principal = {solver.eigenvalues()(0), solver.eigenvalues()(1), solver.eigenvalues()(2)};
  m.axes.r0 = with_fixed_sign(normalised({vectors(0, 0), vectors(1, 0), vectors(2, 0)}));
  m.axes.r1 = with_fixed_sign(normalised({vectors(0, 1), vectors(1, 1), vectors(2, 1)}));
  m.axes.r2 = normalised(cross(m.axes.r0, m.axes.r1));
}

}  // namespace

double signed_volume(const Polyhedron& p) {
  const Vec3 origin = mean_vertex(p);
  return moments(p, origin).volume;
}

MassProperties mass_properties(const Polyhedron& p) {
  const Vec3 near = mean_vertex(p);
  const Moments rough = moments(p, near);
  MassProperties m;
  m.centroid = near + rough.first / rough.volume;
  // A second pass about the centroid itself, since the parallel-axis theorem would cancel digits.
  const Moments exact = moments(p, m.centroid);
  m.volume = exact.volume;
  m.inertia = inertia_of(exact.second);
  const bool diagonal = m.inertia.r0.y == 0.0 && m.inertia.r0.z == 0.0 && m.inertia.r1.z == 0.0;
  if (diagonal) {
    diagonal_axes(m);
  } else {
    general_axes(m);
  }
  return m;
}

}  // namespace voussoir::geometry
