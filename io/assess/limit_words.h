// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cases/model.h"
#include "solver/analysis/limit.h"

/// What `voussoir limit` says: a table in words, one object of JSON, and the mechanism element by element as CSV.
namespace voussoir::io {

struct LimitQuestion {
  std::string title, direction;  // of the case; of the live force, as the user gave it
  solver::LimitOptions options;
};

std::string limit_text(const LimitQuestion& asked, const cases::Model& model, const solver::LimitResult& found);
std::string limit_json(const LimitQuestion& asked, const cases::Model& model, const solver::LimitResult& found);
/// A row an element and rule of flow: velocity of its centroid, rate of turning, and the part it moves with (0: the ground).
std::string limit_csv(const LimitQuestion& asked, const cases::Model& model, const solver::LimitResult& found);

}  // namespace voussoir::io
