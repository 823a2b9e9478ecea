// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cases/solids/stones.h"

/// Stones of files within a checkpoint, since the files may no longer exist when the run continues.
namespace voussoir::io {

/// All tables of stones in the form stored in a checkpoint.
struct PackedStones {
  std::vector<std::int32_t> numbers;  // tables; of each its stones; of each: fixed, groups, pieces; of each piece: vertices, faces, beds,
                                      // the beds, and of each face its corners' count and the corners
  std::vector<double> vertices;       // m, three per vertex, global axes
  std::vector<std::string> texts;     // by stone its name and its groups
};

using StoneTables = std::vector<std::vector<cases::Stone>>;

PackedStones packed_stones(const StoneTables& tables);

/// \return nothing if the arrays are inconsistent: some number is out of range, or data are left over
std::optional<StoneTables> unpacked_stones(const PackedStones& packed);

}  // namespace voussoir::io
