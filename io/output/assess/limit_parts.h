// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "solver/limit/limit.h"

namespace voussoir::io {

/// The mechanism by walls, floors and roofs: a line for each part of the building of which something moves, with the share of its mass that
/// moves and the mean velocity of that share. Empty for a model in which most blocks are parts of their own, as an arch of single stones.
std::string moving_parts(const solver::LimitState& s, const cases::Model& model, const solver::LimitContacts& c);

}  // namespace voussoir::io
