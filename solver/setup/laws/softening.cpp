// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "cases/input_error.h"
#include "cases/model.h"
#include "cases/names.h"
#include "geometry/message.h"
#include "geometry/nth.h"
#include "solver/setup/laws/optional_laws.h"

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

bool softens(const cases::JointLaw& law) { return law.fracture_energy_tension > 0.0 || law.fracture_energy_shear > 0.0; }

/// A fracture energy of which nothing is left after the elastic energy at the limit is refused, with the least that all sides of the law
/// could have.
void refuse_snap_back(const World& w, const char* key, double cases::JointLaw::*energy,
                      Budget (*budget)(const cases::JointLaw&, const kernels::Side&, double)) {
  std::vector<double> least(w.model.laws.size(), 0.0);
  each_side(w.sides, [&](std::size_t id) {
    const Budget b = budget(joint_law_of(w, id), w.sides.side(static_cast<std::int64_t>(id)), strength_factor_of(w, id));
    if (!b.softens()) return;
    double& of_law = nth(least, nth(w.model.joint_law, w.sides.joint[id]));
    of_law = std::max(of_law, b.stored() / strength_factor_of(w, id));
  });
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

constexpr const char* kWear = "segment_wear";  // by segment of the sides that soften

void set_up(World& w, const cases::Case& /*c*/) {
  Sides& s = w.sides;
  const auto room = [&](std::size_t id) { return static_cast<std::size_t>(round_up(s.parts[id].points.n, kernels::kLanes)); };
  std::size_t segments = 0;
  each_side(s, [&](std::size_t id) { segments += softens(joint_law_of(w, id)) ? room(id) : 0; });
  if (segments == 0) return;
  refuse_snap_back(w, "fracture_energy_tension", &cases::JointLaw::fracture_energy_tension, tension_of);
  refuse_snap_back(w, "fracture_energy_shear", &cases::JointLaw::fracture_energy_shear, shear_of);
  double* wear = keep(s, {.name = kWear, .unit = "-", .shape = "segment of a side that softens", .values = {}}, segments);
  each_side(s, [&](std::size_t id) {
    const cases::JointLaw& law = joint_law_of(w, id);
    if (!softens(law)) return;
    own_laws(s, id).soft = {softening_of(law, s.side(static_cast<std::int64_t>(id)), strength_factor_of(w, id)), wear};
    wear += room(id);
  });
}

std::vector<double> numbers(const World& w) {
  std::vector<double> all;
  if (w.sides.state_of_law(kWear) == nullptr) return all;
  for (const kernels::SideLaws& side : w.sides.laws) {
    const kernels::Softening& a = side.soft.law;
    all.insert(all.end(), {a.opening, a.slip, a.dilatancy, a.linear ? 1.0 : 0.0});
  }
  return all;
}

std::vector<std::string> words(const cases::Case& /*c*/, const cases::Model& m) {
  std::vector<std::string> lines;
  for (const cases::NamedLaw* law : laws_in_use(m)) {
    const cases::JointLaw& l = law->value;
    if (!softens(l)) continue;
    std::string text = law->name + ":";
    if (l.fracture_energy_tension > 0.0) text += " " + cases::text(l.fracture_energy_tension) + " J/m2 in tension,";
    if (l.fracture_energy_shear > 0.0) text += " " + cases::text(l.fracture_energy_shear) + " J/m2 in shear,";
    text += l.softening == cases::SofteningCurve::linear ? " linear" : " exponential";
    if (l.dilatancy > 0.0) text += ", dilatancy " + cases::text(l.dilatancy) + " degrees";
    lines.push_back(text);
  }
  return lines;
}

void example(cases::Case& /*c*/, cases::JointLaw& law) {
  law.fracture_energy_tension = 0.2, law.fracture_energy_shear = 0.4, law.dilatancy = 10.0;
}

}  // namespace

OptionalLaw softening_law() {
  return {.name = "softening", .place = 1, .set_up = set_up, .numbers = numbers, .words = words, .example = example};
}

}  // namespace voussoir::solver
