// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/segments/touching.h"

namespace voussoir::geometry {

/// Fills joints and patches of `out` from the contacts (in their order), by the segment rule of `out`.
/// \throw std::logic_error if the segments of a side do not sum to the overlap (1e-9 relative): a fault of this layer, not of the model.
void make_joints(const Scene& scene, std::span<const Contact> contacts, Assembly& out);

}  // namespace voussoir::geometry
