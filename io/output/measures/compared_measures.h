// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

/// The measures of two runs side by side, for people and for programs.
namespace voussoir::io {

/// A table: measure, its value in A and in B, B - A. Times that never came are "never", values that do not exist "-"; their difference is
/// "-", too. Walls are matched by their names; of them only lines in which A and B are shown otherwise. \param a, b  summary_json of the
/// runs
std::string measures_beside(const std::string& a, const std::string& b);

/// The same as a JSON array of {"name", "a", "b", "difference"}, in SI units and under the names of `voussoir summary --format json`; a
/// wall's are "front wall: peak_drift". `difference` is null where there is none.
std::string measures_beside_json(const std::string& a, const std::string& b);

}  // namespace voussoir::io
