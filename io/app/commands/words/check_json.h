// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/census.h"
#include "cases/forward.h"
#include "cases/model.h"

namespace voussoir::io {

struct CheckFigures {
  cases::Census census;
  double step = 0.0;                  // s
  std::optional<double> run_seconds;  // of wall-clock, of a run in which nothing breaks
  std::vector<std::string> faults, findings;
};

/// The output of `voussoir check --format json`.
std::string check_json(const cases::Case& c, const cases::Model& model, const CheckFigures& figures);

}  // namespace voussoir::io
