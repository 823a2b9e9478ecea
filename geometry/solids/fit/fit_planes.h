// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/solids/fit/fit_work.h"
#include "geometry/solids/mesh.h"

/// Fits stones that were drawn with gaps, overlaps and warped faces: one plane for each pair that touches.
namespace voussoir::geometry {

/// A drawn stone, before the fit.
struct FitStone {
  std::vector<Polyhedron> pieces;  // convex, global axes, m; pieces of one stone do not overlap
  double limit = 0.0;              // m, how far its surface may move; wider gaps stay open
  double snap = 0.0;               // m, common areas narrower than this are no contact
};

/// What became of a stone.
struct FittedStone {
  std::vector<Polyhedron> pieces;  // as drawn, to the bit, if nothing of it had to change; empty: nothing is left of it
  bool changed = false;
  double moved = 0.0;   // m, how far its surface moved: the farthest corner of either shape outside the other
  Vec3 where;           // that corner
  double volume = 0.0;  // m3, before
  double now = 0.0;     // m3, after
};

/// Cuts and fills stones so that they fit. The plane of a pair is the best fit of the faces of both that look at each other; faces that
/// hang together by contacts, as the bed of a course, share one where it passes all of them within half of their limits. Each stone becomes
/// the part of space under the planes of its pairs and of its other faces. Where planes of one face would cost a contact a tenth of its
/// area, the stone is cut between them into pieces. What overlaps after that is cut midway, each stone by half; what lies under `base_z` is
/// cut off. Stones whose contacts are exact to half a micrometre, and that overlap nothing, keep their bits. The outcome does not depend on
/// the order of the stones but by round-off. \throw ModelError with a stone as subject: it has too many faces, or FitWork's bound is reached
std::vector<FittedStone> fit_planes(std::span<const FitStone> stones, std::optional<double> base_z);

/// A solid as a convex polyhedron: each face, or what is nearly in the plane of a larger face, is replaced by the plane that fits it.
/// \param limit  m, greatest distance of the surface from the polyhedron
/// \param moved  m, that distance; 0: the solid is convex already \param stone  its number, for messages
/// \return nothing if the solid is not convex within the limit \throw ModelError as FitWork
std::optional<Polyhedron> nearly_convex(const Mesh& solid, double limit, double& moved, FitWork& work, std::int32_t stone);

}  // namespace voussoir::geometry
