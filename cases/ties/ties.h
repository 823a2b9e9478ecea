// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cases/forward.h"
#include "cases/model.h"

/// Ends of ties: from points and plates of the case file to elements.
namespace voussoir::cases {

struct WallsPlan;

/// Sets model.ties to the ties of `c.ties`, of the house, of its floors' anchors, of its roof, of `c.wall_ties`, of the anchors of
/// `c.floors`, of `c.roofs`, of the meshes of the house, of its decks, and of those between walls, in this order, and sets model.tie_bill.
///
/// Without a plate an end holds the base if it lies on the base (within 1 mm), else the element that contains the end (within 1 mm; the
/// element in which it lies deepest, the lowest number of equals). With plates each end must lie in the plane of a face that faces away
/// from the other end (within 60 degrees), or on the base with the other end above. The plate presses on all faces in that plane that it
/// covers, on each by its share of the covered area, at the centroid of that share; at least half of the plate must lie on faces. The
/// plate's width is horizontal (along x if the plate is level), its height perpendicular. A node of a mesh holds the element whose face it
/// lies on; straps between nodes of one element have no effect and are left out, as are straps to nodes in openings.
///
/// \param walls  the plan of c.walls, c.floors and c.roofs; not used if there are none \pre the model is assembled \throw InputError with
/// the key at fault
void place_ties(const Case& c, const WallsPlan& walls, Model& model);

/// Number of separate ties, which come first in model.ties; the remaining ties belong to meshes.
std::size_t own_ties(const Model& model) noexcept;

/// The bars of one deck or mesh: model.ties from `first` to before `last`.
struct TieGroup {
  std::string name;  // "floor 1 deck", "roof deck", or the name of the mesh
  std::size_t first = 0, last = 0;
};

/// Decks and meshes of the model, in the order of their bars in model.ties.
std::vector<TieGroup> tie_groups(const Model& model);

}  // namespace voussoir::cases
