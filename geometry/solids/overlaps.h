// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/polyhedron.h"

/// Separates stones that were drawn slightly overlapping.
namespace voussoir::geometry {

/// A convex piece of a solid, in global axes, m.
struct DrawnPiece {
  Polyhedron shape;
  std::int32_t solid = 0;  // pieces of one solid are not separated from each other
  double snap = 0.0;       // m, see StonesSpec::snap
};

/// Separates pieces that overlap by more than find_contacts allows, and by no more than the larger of their snaps: one of the two is cut
/// along a face of the other, or both halfway along a common direction of two edges. Of all cuts no deeper than the snap the one that costs
/// the fewest contacts with third pieces is taken, then the shallowest. Where the strip that both would share after the cut is narrower
/// than the snap and both lie against something else, a gap of some micrometres is left, so that the strip makes no joint. Parts of a piece
/// under `base_z` by no more than its snap are cut off. Cutting makes convex pieces smaller, so no new overlap results; pieces without
/// overlaps keep their bits. Pieces that cannot be separated in this way are left as they are.
/// \return by piece, the depth of its deepest cut [m]; 0: none
std::vector<double> part_overlaps(std::span<DrawnPiece> pieces, std::optional<double> base_z);

/// The centre of the intersection of two convex bodies [m]; if they share no volume, that of the intersection of their bounding boxes.
Vec3 middle_of_overlap(const Polyhedron& a, const Polyhedron& b);

}  // namespace voussoir::geometry
