// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cases/model.h"

/// What the loads of a case act on.
namespace voussoir::cases {

/// Checks that every load names a free-standing block that can move. \throw InputError with the key at fault.
void check_loads(const Case& c);

/// What an element bears of a load.
struct LoadShare {
  std::int32_t element = 0;
  double part = 1.0;  // of the load's force and moment
  Vec3 point;         // m, where its part of the force acts
};

/// What load `index` acts on: a block, a stone, or each stone of a group, if it is free to move. A block in halves or a stone in pieces has
/// the load as a whole: at Load::at on the part that holds the point (of two the first), else shared by mass, each share at the centroid of
/// its part, so that the force goes through the centroid of the whole.
/// \throw InputError at load[index].block if nothing has that name, or all that has it is fixed, so that the load would do nothing
std::vector<LoadShare> load_shares(const Model& model, const Load& load, std::size_t index);

}  // namespace voussoir::cases
