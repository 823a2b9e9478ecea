// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/polyhedron.h"

namespace voussoir::geometry {

/// Volume [m3], negative for a polyhedron whose faces are turned inside out.
double signed_volume(const Polyhedron& p);

}  // namespace voussoir::geometry
