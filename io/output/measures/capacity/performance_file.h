// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "io/output/measures/capacity/performance.h"
#include "io/output/measures/measures_file.h"

/// Names of what a demand gives, common to run.h5, `voussoir summary`, `voussoir assess` and the report page.
namespace voussoir::io {

std::vector<Figure> figures_of(const Performance& p);
/// Lines of text for the user, each with a line end.
std::string performance_text(const Performance& p);
/// As an object, without figures that are NaN.
std::string performance_json(const Performance& p);

}  // namespace voussoir::io
