// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "geometry/message.h"
#include "solver/schedule/colouring.h"
#include "solver/setup/setup.h"

namespace voussoir::solver {

namespace {

/// A fracture energy and what a side needs of it.
struct Budget {
  double given = 0.0, strength = 0.0, stiffness = 0.0;  // J/m2 of the side, Pa, Pa/m
  /// Stored at the limit [J/m2]. A bond that softens must lose more, or it would snap back.
  [[nodiscard]] double stored() const { return 0.5 * strength * strength / stiffness; }
  [[nodiscard]] bool softens() const { return given > 0.0 && strength > 0.0; }
  /// Displacement that wears by 1 [m]: the rest of the energy over the strength.
  [[nodiscard]] double length() const { return softens() ? (given - stored()) / strength : 0.0; }
};

Budget tension_of(const cases::JointLaw& law, const kernels::Side& side, double factor) {
  return {factor * law.fracture_energy_tension, side.strength.tension, side.k.kn};
}
Budget shear_of(const cases::JointLaw& law, const kernels::Side& side, double factor) {
  return {factor * law.fracture_energy_shear, side.strength.cohesion, side.k.ks};
}

kernels::Softening softening_of(const cases::JointLaw& law, const kernels::Side& side, double factor) {
  const Budget tension = tension_of(law, side, factor), shear = shear_of(law, side, factor);
  return {.opening = tension.softens() ? tension.length() * side.k.kn / side.strength.tension : 0.0,
          .slip = shear.length(),
          .dilatancy = std::tan(law.dilatancy * std::numbers::pi / 180.0),
          .linear = law.softening == cases::SofteningCurve::linear};
}

const cases::JointLaw& law_of(const World& w, std::size_t side) {
  return w.model.laws[static_cast<std::size_t>(w.model.joint_law[static_cast<std::size_t>(w.sides.joint[side])])].value;
}
double scatter_of(const World& w, std::size_t side) { return w.model.joint_strength[static_cast<std::size_t>(w.sides.joint[side])]; }

bool softens(const cases::JointLaw& law) { return law.fracture_energy_tension > 0.0 || law.fracture_energy_shear > 0.0; }

/// A fracture energy of which nothing is left after the elastic energy at the limit is refused, with the least that all sides of the law
/// could have.
void refuse_snap_back(const World& w, const char* key, double cases::JointLaw::*energy,
                      Budget (*budget)(const cases::JointLaw&, const kernels::Side&, double)) {
  std::vector<double> least(w.model.laws.size(), 0.0);
  for (std::size_t id = 0; id < w.sides.joint.size(); ++id) {
    if (w.sides.joint[id] < 0) continue;
    const Budget b = budget(law_of(w, id), w.sides.side(static_cast<std::int64_t>(id)), scatter_of(w, id));
    if (!b.softens()) continue;
    double& of_law = least[static_cast<std::size_t>(w.model.joint_law[static_cast<std::size_t>(w.sides.joint[id])])];
    of_law = std::max(of_law, b.stored() / scatter_of(w, id));
  }
  for (std::size_t i = 0; i < least.size(); ++i) {
    const double given = w.model.laws[i].value.*energy;
    if (least[i] == 0.0 || given > least[i]) continue;
    throw cases::InputError(
        "joint_laws." + w.model.laws[i].name + "." + key,
        "= " + geometry::short_figure(given) +
            " J/m2 is no more than the elastic energy at the limit, strength^2 / (2 x stiffness) = " + geometry::short_figure(least[i]) +
            " J/m2 in the stiffest joint of this law: the bond would snap back; allowed: 0 "
            "(brittle), or more than that");
  }
}

}  // namespace

void set_up_softening(World& w) {
  Sides& s = w.sides;
  const auto is_soft = [&](std::size_t id) { return s.joint[id] >= 0 && softens(law_of(w, id)); };
  std::size_t segments = 0;
  for (std::size_t id = 0; id < s.joint.size(); ++id) {
    if (is_soft(id)) segments += static_cast<std::size_t>(round_up(s.parts[id].points.n, kernels::kLanes));
  }
  if (segments == 0) return;
  refuse_snap_back(w, "fracture_energy_tension", &cases::JointLaw::fracture_energy_tension, tension_of);
  refuse_snap_back(w, "fracture_energy_shear", &cases::JointLaw::fracture_energy_shear, shear_of);
  s.wear.assign_zeros(segments);
  s.soft.resize(s.joint.size());
  std::size_t at = 0;
  for (std::size_t id = 0; id < s.joint.size(); ++id) {
    if (!is_soft(id)) continue;
    s.soft[id] = {softening_of(law_of(w, id), s.side(static_cast<std::int64_t>(id)), scatter_of(w, id)), s.wear.data() + at};
    at += static_cast<std::size_t>(round_up(s.parts[id].points.n, kernels::kLanes));
  }
}

}  // namespace voussoir::solver
