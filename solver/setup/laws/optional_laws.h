// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "cases/forward.h"
#include "cases/tables/joint_laws.h"
#include "solver/world/world.h"

/// The optional laws of joints, those that few models have: set-up, checkpoints, `voussoir check` and tests go through one table. What they
/// compute is behind kernels/side_laws.h, their keys stand in io/input/case_file/case_table_joint_laws.cpp.
namespace voussoir::solver {

struct OptionalLaw {
  const char* name;
  int place;  // in the table, from 1 on: the order of set-up, and in checkpoints; a law that reads another stands behind it
  /// Writes its part of Sides::laws, and room for what it keeps, where the case asks for it. \pre sides have their views
  void (*set_up)(World& w, const cases::Case& c);
  /// Its constants, for the hash of a model; none where no joint has it.
  std::vector<double> (*numbers)(const World& w);
  /// What `voussoir check` says of it, a line each; none where no joint has it.
  std::vector<std::string> (*words)(const cases::Case& c, const cases::Model& m);
  /// Gives it to a joint law of a case, with figures of weak mortar: tests go through the table.
  void (*example)(cases::Case& c, cases::JointLaw& law);
};

/// By their place. CMake lists them: NAME.cpp beside this header has `OptionalLaw NAME_law()`.
std::span<const OptionalLaw> optional_laws();

// ---- for these sources

/// The law of a side that is in use, as the case gives it, and the factor on its strength.
const cases::JointLaw& joint_law_of(const World& w, std::size_t side);
double strength_factor_of(const World& w, std::size_t side);
/// Its optional laws, to be written.
kernels::SideLaws& own_laws(Sides& s, std::size_t side);
/// Room for what a law keeps, zero at first. It stays where it is.
double* keep(Sides& s, LawState what, std::size_t count);
/// Calls `use` with the number of each side that is in use.
template <typename Use>
void each_side(const Sides& s, const Use& use) {
  for (std::size_t id = 0; id < s.joint.size(); ++id) {
    if (s.joint[id] >= 0) use(id);
  }
}
/// The laws that some joint has, with their names.
std::vector<const cases::NamedLaw*> laws_in_use(const cases::Model& m);

}  // namespace voussoir::solver
