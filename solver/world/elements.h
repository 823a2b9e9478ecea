// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "kernels/contact/contact_patch.h"
#include "kernels/integrate.h"
#include "solver/world/array.h"

namespace voussoir::solver {

/// The masses and inertias of a relaxation (solver/equilibrium): fictitious ones, which have nothing to do with weights. Empty: none.
struct Inert {
  Array<double> mass, inv_mass;         // kg, 1/kg; 0: fixed
  Array<double> inv_inertia;            // 1/(kg m2), about any axis; 0: does not turn
  Array<double> zeros;                  // products of inertia
  std::vector<std::uint8_t> principal;  // by batch, see kernels::ElementsView
  [[nodiscard]] bool any() const noexcept { return !mass.empty(); }
};

/// Elements, structure of arrays. Rows [0, count) are elements; row `base` is the base at rest; the remaining rows pad to whole batches
/// (kernels::kBatch) and have no effect.
struct Elements {
  std::int32_t count = 0, base = 0;
  std::int64_t rows = 0;
  // State in global axes; velocities are half a step behind positions (THEORY.md (22) to (24)).
  Array<double> ux, uy, uz;      // m, displacement of the centroid relative to the ground
  Array<double> qw, qx, qy, qz;  // unit quaternion of the orientation
  Array<double> vx, vy, vz;      // m/s, relative to the ground
  Array<double> lx, ly, lz;      // kg m2/s, angular momentum about the centroid
  Array<double> wx, wy, wz;      // rad/s
  Array<double> tally;           // J, see kernels::Tally
  Array<double> alpha;           // 1/s (changes when debris loses its damping)
  Array<std::int32_t> bonds;     // number of bonded segment sides left
  // Constants.
  Array<double> mass, inv_mass;                // kg, 1/kg
  Array<double> ixx, iyy, izz, ixy, ixz, iyz;  // inverse inertia, body axes
  std::vector<std::uint8_t> principal;         // by batch, see kernels::ElementsView
  Inert inert;
  std::vector<kernels::BodyConstants> body;
  Array<double> radius;                              // m, about the centroid
  Array<double> half_x, half_y, half_z;              // m, half extents of the bounding box in body axes, about the centroid
  std::vector<std::int32_t> first_face, face_count;  // range in World::faces
  std::vector<std::int32_t> bonds_at_start;
  std::vector<std::uint8_t> fixed;
  // Rows, see kernels/rows.h; velocity rows are kept up to date for active batches only (travel.h).
  Array<double> pose, twist, wrench, dashpot;

  [[nodiscard]] kernels::ElementsView view() noexcept;
  /// kg, that forces accelerate.
  [[nodiscard]] const Array<double>& inert_mass() const noexcept { return inert.any() ? inert.mass : mass; }
  /// 1/kg, likewise.
  [[nodiscard]] const Array<double>& inert_inv_mass() const noexcept { return inert.any() ? inert.inv_mass : inv_mass; }
  /// Inverse inertia that torques meet, body axes.
  [[nodiscard]] Mat3 inv_inertia(std::size_t i) const noexcept {
    if (inert.any()) return inert.inv_inertia[i] * Mat3{};
    return {{ixx[i], ixy[i], ixz[i]}, {ixy[i], iyy[i], iyz[i]}, {ixz[i], iyz[i], izz[i]}};
  }
  /// Writes the velocity row of an element from its state.
  void store_velocity_row(std::int32_t element) noexcept;
  /// Writes the velocity rows of all elements.
  void store_velocity_rows() noexcept;
};

}  // namespace voussoir::solver
