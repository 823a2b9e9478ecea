// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <string>

#include "geometry/message.h"
#include "solver/setup/setup.h"

namespace voussoir::solver {

namespace {

/// Pa/m, of the softest contact that the model can have: of its joints, and of any two faces.
/// \param pressure  Pa, the least at which it softens
double least_stiffness(const World& w, double pressure) {
  double least = std::numeric_limits<double>::infinity(), softest = 0.0;
  for (std::size_t id = 0; id < w.sides.joint.size(); ++id) {
    if (w.sides.joint[id] < 0) continue;
    const kernels::Side side = w.sides.side(static_cast<std::int64_t>(id));
    least = std::min(least, side.closing == nullptr ? side.k.kn : kernels::stiffness_at(pressure, *side.closing));
  }
  for (const kernels::Face& f : w.faces) softest = std::max(softest, f.compliance_n);
  return softest > 0.0 ? std::min(least, 0.5 / softest) : least;
}

/// Strength must fall no faster than the springs of a contact unload, or it would snap through.
void refuse_snap_through(const World& w, const cases::Contact& c) {
  const double fall = c.compression - c.residual_compression, least = 0.5 * fall * fall / least_stiffness(w, c.residual_compression);
  if (c.crushing_energy == 0.0 || c.crushing_energy > least) return;
  throw cases::InputError(
      "contact.crushing_energy",
      "= " + geometry::short_figure(c.crushing_energy) +
          " J/m2 is no more than (compression - residual_compression)^2 / (2 x stiffness) = " + geometry::short_figure(least) +
          " J/m2 in the softest contact of this model: it would snap through; allowed: 0 (no softening), or more "
          "than that");
}

}  // namespace

kernels::Crushing crushing_of(const cases::Contact& c) {
  const double fall = c.compression - c.residual_compression;
  return {.strength = c.compression,
          .residual = c.residual_compression,
          .slope = c.crushing_energy > 0.0 ? 0.5 * fall * fall / c.crushing_energy : 0.0,
          .depth = c.crushing_depth};
}

void set_up_crushing(World& w, const cases::Contact& c) {
  if (!w.contact.crushing.on()) return;
  refuse_snap_through(w, c);
  Sides& s = w.sides;
  s.crushed.assign_zeros(s.bond.size());
  s.crushed_of.assign(s.joint.size(), nullptr);
  for (std::size_t id = 0; id < s.joint.size(); ++id) {
    if (s.joint[id] >= 0) s.crushed_of[id] = s.crushed.data() + (s.parts[id].segments.bond - s.bond.data());
  }
}

}  // namespace voussoir::solver
