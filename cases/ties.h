// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "cases/model.h"

/// Where ties hold: from the points and plates of the case file to elements.
namespace voussoir::cases {

/// Sets model.ties, those of `c.ties`, of the house, of its floors' anchors, of its roof, of its meshes, and of its decks, in this order,
/// and model.tie_bill.
///
/// Without a plate an end holds the base if it lies on it (within 1 mm), else the element that has the point in it or on it (within 1 mm;
/// the one it lies deepest in, the lowest number of equals). With plates each end must lie in the plane of a face that looks away from the
/// other end (within 60 degrees), or on the base with the other end above. The plate presses on all faces in that plane that it covers,
/// each by its share of the area covered, at the centroid of that share; at least half of it must lie on faces. Its width is horizontal
/// (along x if the plate is level), its height across. A node of a mesh holds the element whose face it stands on; straps between nodes of
/// one element hold nothing and are left out, as are those to nodes in openings.
///
/// \pre the model is assembled \throw InputError with the key at fault
void place_ties(const Case& c, Model& model);

/// Number of ties by themselves: the first of model.ties; those behind them belong to meshes.
std::size_t own_ties(const Model& model) noexcept;

}  // namespace voussoir::cases
