// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "cases/forward.h"

/// Elements as cells of VTK, for files that ParaView opens.
namespace voussoir::io {

inline constexpr std::uint8_t kTetrahedron = 10, kHexahedron = 12, kWedge = 13;  // cell types of VTK

/// Number of corners of a cell type.
int corners_of(std::uint8_t type) noexcept;

/// VTK cells of the elements. A box or hexahedron is one cell; a prism over k corners is k - 2 wedges; any other polyhedron is tetrahedra
/// from its first vertex, one to each triangle of the faces without that vertex. Hence there may be more cells than elements.
struct Cells {
  std::vector<std::int32_t> corners;  // 8 per cell, rows of all vertices in the order of the elements; -1 beyond the corners of a cell
  std::vector<std::int32_t> element;  // by cell
  std::vector<std::uint8_t> type;     // cell type of VTK
};

Cells cells_of(const cases::Model& model);

}  // namespace voussoir::io
