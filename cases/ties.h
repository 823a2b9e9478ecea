// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cases/model.h"

/// Where ties hold: from the points and plates of the case file to elements.
namespace voussoir::cases {

/// The ties of `c.ties`, in order.
///
/// Without a plate an end holds the element that has the point in it or on it (within 1 mm; the one it lies deepest in, the lowest number
/// of equals), or the base. With plates each end must lie on a face that looks away from the other end. The plate presses on all faces in
/// that plane that it covers, each by its share of the area covered, at the centroid of that share; at least half of it must lie on faces.
/// Its width is horizontal (along x if the plate is level), its height across.
///
/// \pre the model is assembled \throw InputError with the key at fault
std::vector<TieBar> place_ties(const Case& c, const Model& model);

}  // namespace voussoir::cases
