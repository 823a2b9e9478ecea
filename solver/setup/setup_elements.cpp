// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "cases/case.h"
#include "cases/model.h"
#include "cases/names.h"
#include "geometry/nth.h"
#include "solver/setup/setup.h"
#include "solver/world/first_touch.h"

namespace voussoir::solver {

namespace {

double plane_strain_modulus(const cases::Material& m) { return m.young / (1.0 - m.poisson * m.poisson); }

void size_arrays(Elements& e, Team& team) {
  const auto n = static_cast<std::size_t>(e.rows);
  for (Array<double>* a : {&e.ux,  &e.uy,  &e.uz,  &e.qx,  &e.qy,     &e.qz,     &e.vx,     &e.vy,       &e.vz,  &e.lx,
                           &e.ly,  &e.lz,  &e.wx,  &e.wy,  &e.wz,     &e.alpha,  &e.mass,   &e.inv_mass, &e.ixx, &e.iyy,
                           &e.izz, &e.ixy, &e.ixz, &e.iyz, &e.radius, &e.half_x, &e.half_y, &e.half_z}) {
    assign_in_shares(*a, n, 0.0, team);
  }
  assign_in_shares(e.tally, n / kernels::kBatch * kernels::kTallies, 0.0, team);
  assign_in_shares(e.qw, n, 1.0, team);
  assign_in_shares(e.body, n, {}, team);
  e.bonds.assign(n, 0);
  e.bonds_at_start.assign(n, 0);
  e.fixed.assign(n, 1);
  e.first_face.assign(n, 0);
  e.face_count.assign(n, 0);
  assign_in_shares(e.pose, n * kernels::kPoseStride, 0.0, team);
  assign_in_shares(e.twist, n * kernels::kTwistStride, 0.0, team);
  assign_in_shares(e.wrench, n * kernels::kWrenchStride, 0.0, team);
  assign_in_shares(e.dashpot, n * kernels::kDashpotStride, 0.0, team);
}

// Of the trace of the inertia: a smaller product of inertia is the round-off of a body that has none. It would tilt a body that spins flat.
constexpr double kNoProduct = 1e-13;

/// In reference axes.
void set_inverse_inertia(Elements& e, std::size_t i, const Mat3& inertia) {
  Eigen::Matrix3d j;
  j << inertia.r0.x, inertia.r0.y, inertia.r0.z, inertia.r1.x, inertia.r1.y, inertia.r1.z, inertia.r2.x, inertia.r2.y, inertia.r2.z;
  const double least = kNoProduct * j.trace();
  for (const auto& [r, c] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) {
    if (std::abs(j(r, c)) < least) j(r, c) = j(c, r) = 0.0;
  }
  const Eigen::Matrix3d inverse = j.inverse();
  e.ixx[i] = inverse(0, 0), e.iyy[i] = inverse(1, 1), e.izz[i] = inverse(2, 2);
  e.ixy[i] = inverse(0, 1), e.ixz[i] = inverse(0, 2), e.iyz[i] = inverse(1, 2);
}

/// What batches have in common. Call when all elements are there.
void set_up_batches(Elements& e) {
  e.principal.assign(static_cast<std::size_t>(e.rows / kernels::kBatch), 1);
  for (std::size_t i = 0; i < static_cast<std::size_t>(e.rows); ++i) {
    if (e.ixy[i] != 0.0 || e.ixz[i] != 0.0 || e.iyz[i] != 0.0) e.principal[i / kernels::kBatch] = 0;
  }
}

void set_extent(Elements& e, std::size_t i, const geometry::Polyhedron& shape, Vec3 centroid) {
  for (const Vec3& v : shape.vertices) {
    const Vec3 r = v - centroid;
    e.radius[i] = std::max(e.radius[i], norm(r));
    e.half_x[i] = std::max(e.half_x[i], std::abs(r.x));
    e.half_y[i] = std::max(e.half_y[i], std::abs(r.y));
    e.half_z[i] = std::max(e.half_z[i], std::abs(r.z));
  }
}

double mass_damping(const cases::Damping& d) {
  if (d.alpha) return *d.alpha;
  if (d.own_frequency && !d.frequency && d.ratio > 0.0)
    throw cases::InputError("damping.frequency", "is \"auto\" still: solver::fill_own_frequency finds it before the world is built");
  return d.frequency ? 2.0 * d.ratio * 2.0 * std::numbers::pi * *d.frequency : 0.0;  // Eq. 14
}

constexpr double kShortestStep = 1e-9;  // s, so that the number of steps of any run fits into 64 bits

/// Faces of a part of the base are as that of the base: they add no compliance and no mass to a contact.
kernels::Face face_of(const geometry::Face& face, const cases::Block& block, const cases::Material& material) {
  kernels::Face f{.normal = face.normal, .distance = face.distance, .material = block.material};
  if (block.ground >= 0) return f;
  f.compliance_n = face.distance / plane_strain_modulus(material);  // Eq. 1
  f.compliance_s = face.distance * 2.0 * (1.0 + material.poisson) / material.young;
  f.mass = material.density * face.distance;  // Eq. 10
  return f;
}

/// From which heights count in a model without a base.
double lowest_corner(const cases::Model& m) {
  double low = std::numeric_limits<double>::infinity();
  for (const cases::Block& b : m.blocks)
    for (const Vec3& v : b.shape.vertices) low = std::min(low, v.z);
  return std::isfinite(low) ? low : 0.0;
}

}  // namespace

double share_of_bound(const cases::Case& c) noexcept { return c.contact.restitution ? kImpactShare : 1.0; }

double choose_step(const cases::Case& c, const Options& o, double bound) {
  if (o.step || c.time.step) {
    const double step = o.step ? *o.step : *c.time.step;
    if (step < kShortestStep) throw cases::InputError("time.step", "= " + cases::text(step) + " s is out of range; allowed: at least 1e-9");
    return step;
  }
  if (!std::isfinite(bound)) return c.output.history_interval;  // nothing moves but what is fixed
  const double cycle = c.multirate();                        // whole cycles
  return c.output.history_interval / (cycle * std::ceil(c.output.history_interval / (cycle * 0.995 * share_of_bound(c) * bound)));
}

void set_up_elements(World& w, const cases::Case& c) {
  const cases::Model& m = w.model;
  Elements& e = w.elements;
  e.count = static_cast<std::int32_t>(m.blocks.size());
  e.base = e.count;
  e.rows = round_up(e.count + 1, kernels::kBatch);
  size_arrays(e, w.team);
  const double alpha = mass_damping(c.damping);
  for (std::size_t i = 0; i < m.blocks.size(); ++i) {
    const cases::Block& b = m.blocks[i];
    const geometry::Element& g = m.assembly.elements[i];
    const double density = nth(m.materials, b.material).value.density;
    e.body[i].ref = g.mass.centroid;
    e.first_face[i] = g.first_face, e.face_count[i] = g.face_count;
    set_extent(e, i, b.shape, g.mass.centroid);
    e.fixed[i] = b.fixed ? 1 : 0;
    if (b.fixed) continue;
    e.mass[i] = density * g.mass.volume;
    e.inv_mass[i] = 1.0 / e.mass[i];
    e.alpha[i] = alpha;
    set_inverse_inertia(e, i, density * g.mass.inertia);
  }
  set_up_batches(e);
  const auto base = static_cast<std::size_t>(e.base);
  e.body[base].ref.z = c.base ? c.base->z : lowest_corner(m);
  e.first_face[base] = static_cast<std::int32_t>(m.assembly.faces.size());
  e.face_count[base] = 1;
}

void set_initial_velocities(World& w) {
  Elements& e = w.elements;
  for (std::size_t i = 0; i < w.model.blocks.size(); ++i) {
    const cases::Block& b = w.model.blocks[i];
    const Vec3 v = b.fixed ? Vec3{} : b.velocity, spin = b.fixed ? Vec3{} : b.angular_velocity;
    const double density = nth(w.model.materials, b.material).value.density;
    const Mat3 r = rotation({e.qw[i], e.qx[i], e.qy[i], e.qz[i]});
    const Vec3 l = r * (density * (w.model.assembly.elements[i].mass.inertia * (transposed(r) * spin)));
    e.vx[i] = v.x, e.vy[i] = v.y, e.vz[i] = v.z;
    e.wx[i] = spin.x, e.wy[i] = spin.y, e.wz[i] = spin.z;
    e.lx[i] = l.x, e.ly[i] = l.y, e.lz[i] = l.z;
  }
  e.store_velocity_rows();
}

void set_up_faces(World& w) {
  const cases::Model& m = w.model;
  w.faces.reserve(m.assembly.faces.size() + 1);
  for (std::size_t i = 0; i < m.blocks.size(); ++i) {
    const geometry::Element& e = m.assembly.elements[i];
    if (e.face_count > kernels::kMostFaces) {
      throw cases::InputError("", cases::describe(m.blocks[i], i) + " has " + std::to_string(e.face_count) + " faces; allowed: at most " +
                                      std::to_string(kernels::kMostFaces));
    }
    w.most_faces = std::max(w.most_faces, e.face_count);
    const cases::Material& material = nth(m.materials, m.blocks[i].material).value;
    for (std::int32_t f = e.first_face; f < e.first_face + e.face_count; ++f) {
      w.faces.push_back(face_of(nth(m.assembly.faces, f), m.blocks[i], material));
    }
  }
  w.faces.push_back(
      {.normal = {0.0, 0.0, 1.0}, .material = static_cast<std::int32_t>(m.materials.size())});  // the base, a rigid half-space
}

}  // namespace voussoir::solver
