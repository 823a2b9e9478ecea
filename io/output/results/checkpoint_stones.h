// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cases/solids/stones.h"

/// The stones of files within a checkpoint: the files may be gone when the run goes on.
namespace voussoir::io {

/// All tables of stones, as a checkpoint holds them.
struct PackedStones {
  std::vector<std::int32_t> numbers;  // tables; of each its stones; of each: fixed, groups, pieces; of each piece: vertices, faces, beds,
                                      // the beds, and of each face its corners' count and the corners
  std::vector<double> vertices;       // three each, m, global axes
  std::vector<std::string> texts;     // of each stone its name and its groups
};

using StoneTables = std::vector<std::vector<cases::Stone>>;

PackedStones packed_stones(const StoneTables& tables);

/// \return nothing if they do not fit together: some number is out of its range, or something is left
std::optional<StoneTables> unpacked_stones(const PackedStones& packed);

}  // namespace voussoir::io
