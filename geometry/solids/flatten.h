// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/separation.h"
#include "geometry/solids/mesh.h"

/// Faces of stones that were meant to touch, put into one plane; warped faces made plane.
namespace voussoir::geometry {

/// A closed solid on its way to be a stone.
struct RoughSolid {
  Mesh mesh;
  double snap = 0.0;          // m, see StonesSpec::snap
  std::optional<double> gap;  // m, see StonesSpec::gap
};

/// What was done to one solid.
struct Flattened {
  double moved = 0.0;           // m, of its farthest vertex; 0: nothing
  double warped = 0.0;          // m, of its worst face before
  std::vector<HalfSpace> beds;  // planes of faces that stand on a bed of mortar
};

/// Two faces of two solids are in contact where they look at each other and are no farther apart than the larger snap, over all that they
/// share; a shared strip narrower than the snap is ignored, unless they touch exactly. Faces at the distance of the gap (both have the
/// same) stand on a bed of mortar, unless they touch something. All faces that hang together by contacts get one plane, the mean of both
/// sides; a bed has it in its middle; faces within snap of `base_z` get the base's. Then each vertex goes to where its planes meet, by the
/// shortest way. Faces with no contact stay in their planes, or, where a vertex has too many of them, in the plane that fits their
/// vertices. Contacts that are exact to half a micrometre, and solids without any other, keep their bits. \throw ModelError with the
/// solid's index: a face is warped by more than snap; a vertex would move by more than twice the snap (and the gap); faces that share
/// vertices cannot all be made plane
std::vector<Flattened> flatten(std::span<RoughSolid> solids, std::optional<double> base_z);

}  // namespace voussoir::geometry
