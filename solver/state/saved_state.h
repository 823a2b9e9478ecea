// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "solver/state/field_table.h"

/// A state apart from the simulation it came from, and the way back.
namespace voussoir::solver {

/// Raised by every change that alters the numbers of a run ("Results change" in the changelog): a state is gone on with only by a program
/// that computes as the one that saved it.
inline constexpr std::int64_t kPhysicsVersion = 16;

/// The values of one field.
struct SavedField {
  FieldType type = FieldType::f64;
  std::uint64_t count = 0, columns = 1;
  std::vector<std::byte> bytes;  // count × columns values
};
/// By the names of the fields.
using SavedState = std::map<std::string, SavedField, std::less<>>;

/// Copies all fields. \pre between two steps, and the cracks so far have been taken: Simulation::cracks() is empty
SavedState save(Simulation& sim, RunState& plan);

/// Brings a simulation that was just built into a saved state: from here on it computes the same bits as the one that was saved.
/// \throw StateError naming the field if the state is not one of this model, or holds what the program cannot work with; the simulation is
/// of no use then
void restore(Simulation& sim, RunState& plan, const SavedState& from);

/// A hash over what the state rests on: everything that is built from the case before the first step. Equal bits, equal hash.
std::uint64_t model_hash(const World& w);

}  // namespace voussoir::solver
