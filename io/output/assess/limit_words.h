// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cases/model.h"
#include "solver/limit/limit.h"
#include "solver/limit/load_path.h"

/// What `voussoir limit` says: a table in words, one object of JSON, and the mechanism element by element as CSV.
namespace voussoir::io {

struct LimitQuestion {
  std::string title, live;  // of the case; what the multiplier multiplies, in words
  solver::LimitOptions options;
};

/// \param path  of which `found` is the weakest place; null: the load does not move
std::string limit_text(const LimitQuestion& asked, const cases::Model& model, const solver::LimitResult& found,
                       const solver::LoadPath* path = nullptr);
std::string limit_json(const LimitQuestion& asked, const cases::Model& model, const solver::LimitResult& found,
                       const solver::LoadPath* path = nullptr);
/// A row an element and rule of flow: velocity of its centroid, rate of turning, and the part it moves with (0: the ground).
std::string limit_csv(const LimitQuestion& asked, const cases::Model& model, const solver::LimitResult& found);

}  // namespace voussoir::io
