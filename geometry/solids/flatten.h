// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/separation.h"
#include "geometry/solids/mesh.h"

/// Puts faces of stones that were meant to touch into one plane, and makes warped faces plane.
namespace voussoir::geometry {

/// A closed solid before it becomes a stone.
struct RoughSolid {
  Mesh mesh;
  double snap = 0.0;          // m, see StonesSpec::snap
  std::optional<double> gap;  // m, see StonesSpec::gap
};

/// Changes made to one solid.
struct Flattened {
  double moved = 0.0;           // m, displacement of its farthest moved vertex; 0: unchanged
  double warped = 0.0;          // m, greatest warp of a face before the changes
  std::vector<HalfSpace> beds;  // planes of faces that lie on a mortar bed
};

/// Makes contacting faces coplanar and warped faces plane.
///
/// Two faces of two solids are in contact where they look at each other and are no farther apart than the larger snap, over all of their
/// common area; a common strip narrower than the snap is ignored, unless the faces touch exactly. Faces at the distance of the gap (equal
/// for both solids) lie on a mortar bed, unless they touch something. All faces connected by contacts get one plane, the mean of both
/// sides; the plane of a bed is in its middle; faces within snap of `base_z` get the plane of the base. Each vertex then moves to the
/// intersection of its planes, by the shortest way. Faces with no contact stay in their planes, or, where a vertex has too many planes, get
/// the plane that fits their vertices. Contacts exact to half a micrometre, and solids without any other contacts, keep their bits.
/// \throw ModelError with the solid's index: a face is warped by more than snap; a vertex would move by more than twice the snap (and the
/// gap); faces that share vertices cannot all be made plane
std::vector<Flattened> flatten(std::span<RoughSolid> solids, std::optional<double> base_z);

}  // namespace voussoir::geometry
