// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "solver/run/run.h"

namespace voussoir::io {

/// Warning about bonds that broke under the building's own weight: how many of how many, in which mode, and in which parts of
/// the building, those with the most first; empty if none broke.
/// \param world  at the beginning of the shaking \param state  with `settling` set
std::string settling_warning(const solver::World& world, const solver::RunState& state);

}  // namespace voussoir::io
