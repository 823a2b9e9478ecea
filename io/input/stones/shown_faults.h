// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cases/solids/stones.h"
#include "geometry/solids/mesh.h"

namespace voussoir::io {

/// A refused stone, and the reason.
struct StoneFault {
  std::size_t table = 0;
  std::string stone;
  std::string message;  // with the stone's name, the place and the remedy
  geometry::Mesh mesh;  // as read, global axes, m
};

/// A clause for a message: " (and 2 more stones are at fault: "b", "c")"; empty for one fault.
std::string other_faults(const std::vector<StoneFault>& faults);

/// The surface of a faulty stone, for display: each face as thin plates of triangles; its bounding box if it has too many faces.
std::vector<cases::StonePiece> plates_of(const geometry::Mesh& mesh);

}  // namespace voussoir::io
