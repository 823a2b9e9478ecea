// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "cases/forward.h"
#include "geometry/vec3.h"

namespace voussoir::cases {

/// Point of action of a force along `direction`: `from`, if inside an element, else on the first element that the line from there hits.
struct LoadedPlace {
  std::int32_t element = -1;  // −1: no element is hit
  Vec3 at;
};
LoadedPlace place_of_load(const Model& model, Vec3 from, Vec3 direction);

}  // namespace voussoir::cases
