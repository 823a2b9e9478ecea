// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/model.h"

namespace voussoir::cases {

/// Refuses points of output.history that belong to no element of the model, as those of another house may: farther from every element than
/// that element is long. Distances are to the box about an element, along the axes.
/// \throw InputError with the key of the point, the nearest element and how far it is
void check_followed_points(const Case& c, const Model& model);

}  // namespace voussoir::cases
