// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/vec3.h"

/// Rotation vectors (axis times angle, rad) and quaternions, by series: the functions of a library have other bits on other processors.
namespace voussoir::geometry {

/// The quaternion of a rotation vector of any length [rad].
Quaternion quaternion_of(Vec3 rotation) noexcept;

/// The rotation vector that takes `from` to `to` [rad], in space. Exact to round-off below 0.1 rad, to 1e-4 of itself below 1 rad.
Vec3 small_rotation(Quaternion from, Quaternion to) noexcept;

}  // namespace voussoir::geometry
