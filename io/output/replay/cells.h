// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "cases/model.h"

/// Elements as cells of VTK, for files that ParaView opens.
namespace voussoir::io {

inline constexpr std::uint8_t kTetrahedron = 10, kHexahedron = 12, kWedge = 13;  // VTK's numbers

/// Corners that a cell of a type has.
int corners_of(std::uint8_t type) noexcept;

/// A box or hexahedron is one cell; a prism over k corners is k - 2 wedges; any other polyhedron is tetrahedra from its first vertex, one
/// to each triangle of the faces that do not have it. So elements and cells are counted apart.
struct Cells {
  std::vector<std::int32_t> corners;  // 8 a cell, rows of all vertices in the order of the elements; -1 where a cell has no more
  std::vector<std::int32_t> element;  // of the cell
  std::vector<std::uint8_t> type;     // VTK's
};

Cells cells_of(const cases::Model& model);

}  // namespace voussoir::io
