// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/forward.h"
#include "cases/model.h"

namespace voussoir::cases {

/// Refuses points of output.history that are farther from every element than that element is long, as points of another house may be.
/// Distances are to the element's bounding box, along the axes.
/// \throw InputError with the key of the point, the nearest element and its distance
void check_followed_points(const Case& c, const Model& model);

}  // namespace voussoir::cases
