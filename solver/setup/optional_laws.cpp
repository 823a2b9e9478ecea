// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/setup/laws/optional_laws.h"

#include <utility>

#include "cases/model.h"
#include "geometry/nth.h"

namespace voussoir::solver {

const cases::JointLaw& joint_law_of(const World& w, std::size_t side) {
  return nth(w.model.laws, nth(w.model.joint_law, w.sides.joint[side])).value;
}

double strength_factor_of(const World& w, std::size_t side) { return nth(w.model.joint_strength, w.sides.joint[side]); }

kernels::SideLaws& own_laws(Sides& s, std::size_t side) {
  if (s.laws.empty()) s.laws.resize(s.joint.size());
  return s.laws[side];
}

double* keep(Sides& s, LawState what, std::size_t count) {
  what.values.assign_zeros(count);
  return s.law_state.emplace_back(std::move(what)).values.data();
}

std::vector<const cases::NamedLaw*> laws_in_use(const cases::Model& m) {
  std::vector<bool> used(m.laws.size(), false);
  for (const std::int32_t law : m.joint_law) nth(used, law) = true;
  std::vector<const cases::NamedLaw*> laws;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (used[i]) laws.push_back(&m.laws[i]);
  }
  return laws;
}

}  // namespace voussoir::solver
