// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/case.h"
#include "cases/census.h"
#include "cases/model.h"
#include "solver/run/simulation.h"

namespace voussoir::io {

/// What a run leaves on the disk [bytes].
struct DiskNeeds {
  double results = 0.0, checkpoints = 0.0;  // checkpoints: of those that are kept
};
/// About what a run needs. \param n  of its model
DiskNeeds disk_needs(const cases::Case& c, const cases::Census& n);

/// Refuses a run of more steps or rows than can end, before anything runs.
/// \throw cases::InputError for the key that causes it, with what is allowed
void refuse_endless(const cases::Case& c, const cases::Model& model, const solver::Simulation& sim);

}  // namespace voussoir::io
