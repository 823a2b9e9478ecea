// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/case.h"
#include "cases/model.h"
#include "solver/run/simulation.h"

namespace voussoir::io {

/// Refuses a run of more steps or rows than can end, before anything runs.
/// \throw cases::InputError for the key that causes it, with what is allowed
void refuse_endless(const cases::Case& c, const cases::Model& model, const solver::Simulation& sim);

}  // namespace voussoir::io
