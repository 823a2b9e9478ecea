// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/polyhedron.h"

/// Stones drawn a little into each other, parted.
namespace voussoir::geometry {

/// A convex piece of a solid, in global axes, m.
struct DrawnPiece {
  Polyhedron shape;
  std::int32_t solid = 0;  // pieces of one solid are not parted
  double snap = 0.0;       // m, see StonesSpec::snap
};

/// Parts pieces that are in each other by more than find_contacts allows, and by no more than the larger of their snaps: one of them is cut
/// along a face of the other, or both halfway along a common direction of two edges. Of all cuts no deeper than the snap the one that costs
/// the fewest contacts with third pieces is taken, then the shallowest. Where the strip that they would then share is narrower than the
/// snap and both lie against something else, a gap of some micrometres is left, so that it makes no joint. What reaches under `base_z` by
/// no more than its snap is cut off. Cutting makes convex pieces smaller, so no new overlap comes of it; pieces without overlaps keep their
/// bits. What cannot be parted so is left as it is. \return by piece, how deep the deepest cut was, m; 0: none
std::vector<double> part_overlaps(std::span<DrawnPiece> pieces, std::optional<double> base_z);

/// The middle of what two convex bodies share; of the boxes about them, if they share no volume.
Vec3 middle_of_overlap(const Polyhedron& a, const Polyhedron& b);

}  // namespace voussoir::geometry
