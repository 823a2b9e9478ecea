// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

/// Measures of two runs side by side, as text and as JSON.
namespace voussoir::io {

/// A table: measure, its value in A and in B, B - A. Times that never came are "never", undefined values "-"; their difference is "-", too.
/// Walls are matched by name; only their differing lines are included. \param a,  b summary_json of the runs
std::string measures_beside(const std::string& a, const std::string& b);

/// The comparison as a JSON array of {"name", "a", "b", "difference"}, in SI units and with the names of `voussoir summary --format json`;
/// measures of a wall are named "front wall: peak_drift". `difference` is null where undefined.
std::string measures_beside_json(const std::string& a, const std::string& b);

}  // namespace voussoir::io
