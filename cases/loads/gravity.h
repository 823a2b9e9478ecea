// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/forward.h"
#include "geometry/vec3.h"

namespace voussoir::cases {

/// Gravity in axes of the base [m/s2]. The axes stay level; a tilted base (base.tilt) rotates gravity instead.
Vec3 gravity_on_base(const Case& c) noexcept;

}  // namespace voussoir::cases
