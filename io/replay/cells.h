// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "cases/model.h"

/// Elements as cells of VTK, for files that ParaView opens.
namespace voussoir::io {

inline constexpr std::uint8_t kHexahedron = 12, kWedge = 13;  // VTK's numbers

/// A box or hexahedron is one cell; a prism over k corners is k - 2 wedges, so elements and cells are counted apart.
struct Cells {
  std::vector<std::int32_t> corners;  // 8 a cell, rows of all vertices in the order of the elements; -1 where a wedge has no more
  std::vector<std::int32_t> element;  // of the cell
  std::vector<std::uint8_t> type;     // VTK's
};

/// \throw std::invalid_argument for an element that is neither hexahedron nor prism
Cells cells_of(const cases::Model& model);

}  // namespace voussoir::io
