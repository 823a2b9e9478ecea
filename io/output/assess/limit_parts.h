// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "solver/limit/limit.h"

namespace voussoir::io {

/// What moves in a mechanism, by parts of the building as people name them: a line a part, with the share of its mass that moves and the
/// mean motion of that. Empty for a model whose blocks have names of their own, where the parts of the mechanism tell as much.
std::string moving_parts(const solver::LimitState& s, const cases::Model& model, const solver::LimitContacts& c);

}  // namespace voussoir::io
