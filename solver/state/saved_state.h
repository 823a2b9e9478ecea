// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "solver/state/field_table.h"

/// Saving a state apart from its simulation, and restoring it.
namespace voussoir::solver {

/// Increased by every change that alters the numbers of a run ("Results change" in the changelog): a run is only continued by a program
/// that computes the same numbers.
inline constexpr std::int64_t kPhysicsVersion = 24;

/// The values of one field.
struct SavedField {
  FieldType type = FieldType::f64;
  std::uint64_t count = 0, columns = 1;
  std::vector<std::byte> bytes;  // count × columns values
};
/// Saved fields by name.
using SavedState = std::map<std::string, SavedField, std::less<>>;

/// Copies all fields. \pre between two steps, with all cracks taken: Simulation::cracks() is empty
SavedState save(Simulation& sim, RunState& plan);

/// Restores a saved state in a newly built simulation, which then computes the same bits as the saved one would have.
/// \throw StateError naming the field if the state does not belong to this model, or has invalid values; the simulation is then unusable
void restore(Simulation& sim, RunState& plan, const SavedState& from);

/// A hash over all data built from the case before the first step, on which a state relies. Equal bits give an equal hash.
std::uint64_t model_hash(const World& w);

}  // namespace voussoir::solver
