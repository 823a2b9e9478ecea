// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "cases/model.h"
#include "cases/names.h"
#include "geometry/nth.h"
#include "solver/setup/laws/optional_laws.h"

namespace voussoir::solver {

namespace {

void set_up(World& w, const cases::Case& /*c*/) {
  Sides& s = w.sides;
  each_side(s, [&](std::size_t id) {
    const cases::JointLaw& law = joint_law_of(w, id);
    if (!law.maximum_closure) return;
    const double compliance =  // m/Pa; none of the base
        nth(w.faces, s.master_face[id]).compliance_n + nth(w.faces, s.slave_face[id]).compliance_n;
    own_laws(s, id).closing = {
        .most = *law.maximum_closure, .scale = *law.normal_stiffness * *law.maximum_closure, .blocks = 1.0 / compliance};
  });
}

std::vector<double> numbers(const World& w) {
  std::vector<double> all;
  if (std::ranges::none_of(w.sides.laws, [](const kernels::SideLaws& side) { return side.closing.on(); })) return all;
  for (const kernels::SideLaws& side : w.sides.laws) all.insert(all.end(), {side.closing.most, side.closing.scale, side.closing.blocks});
  return all;
}

std::vector<std::string> words(const cases::Case& /*c*/, const cases::Model& m) {
  std::vector<std::string> lines;
  for (const cases::NamedLaw* law : laws_in_use(m)) {
    if (const auto most = law->value.maximum_closure)
      lines.push_back(law->name + ": " + cases::text(*law->value.normal_stiffness) + " Pa/m without pressure, by " + cases::text(*most) +
                      " m at most");
  }
  return lines;
}

void example(cases::Case& /*c*/, cases::JointLaw& law) {
  law.tension = law.cohesion = 0.0;
  law.normal_stiffness = 1e9, law.shear_stiffness = 5e8, law.maximum_closure = 1e-4;
}

}  // namespace

OptionalLaw closing_law() {
  return {.name = "closing", .place = 2, .set_up = set_up, .numbers = numbers, .words = words, .example = example};
}

}  // namespace voussoir::solver
