// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cases/case.h"
#include "geometry/solids/mesh.h"

namespace voussoir::io {

/// A stone that is refused, and why.
struct StoneFault {
  std::size_t table = 0;
  std::string stone;
  std::string message;  // with the stone's name, the place and what to do
  geometry::Mesh mesh;  // as read, global axes, m
};

/// "(and 2 more stones are at fault: "b", "c")", with a blank before it; empty for one fault.
std::string other_faults(const std::vector<StoneFault>& faults);

/// The surface of a stone at fault, to be looked at: each face as thin plates of triangles; the box about it where it has too many faces.
std::vector<cases::StonePiece> plates_of(const geometry::Mesh& mesh);

}  // namespace voussoir::io
