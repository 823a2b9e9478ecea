// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace voussoir::geometry {

/// Rule for the positions of contact points on a face.
enum class SegmentRule : std::uint8_t {
  centres,  // at the centroids of equal cells, as in the paper
  rim,      // at points up to the rim of the common area of two faces, with weights that give its area, first and second moments exactly
  corners   // at the corners of the common area alone, with weights that give its area and first moments exactly
};

/// How joints resist a twist about their normals: with G I_p, as faces that stay plane, or with Saint-Venant's constant (torsion.h).
enum class Torsion : std::uint8_t { paper, solid };

}  // namespace voussoir::geometry
