// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cases/forward.h"
#include "solver/world/world.h"

namespace voussoir::io {

/// Warning about elements that weigh less than `analysis.tolerance` times the mean weight of an element: a state counts as one of rest
/// (kernels/THEORY.md (35)) though such an element falls. How many, the lightest by name, and the tolerance that would show it. Empty if
/// there are none, if weights do not matter (no gravity), or if the analysis does not look for states of rest.
std::string light_elements_warning(const solver::World& world, const cases::Case& c);

}  // namespace voussoir::io
