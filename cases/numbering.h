// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cases/model.h"

namespace voussoir::cases {

/// Sorts the blocks of houses into the order of element numbers: house by house, then cell by cell of the plan along a Morton curve, from
/// the bottom up in each cell. Touching elements are then close in memory; numbered course by course round the house, a step of an intact
/// house takes up to a tenth longer (perf/LOG.md).
/// \param cell  edge of the cells [m]
void number_along_plan(std::vector<Block>& blocks, double cell);

}  // namespace voussoir::cases
