// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/case.h"

namespace voussoir::cases {

/// Gravity in the axes of the base [m/s2], which stay level: a tilted base turns it (base.tilt).
Vec3 gravity_on_base(const Case& c) noexcept;

}  // namespace voussoir::cases
