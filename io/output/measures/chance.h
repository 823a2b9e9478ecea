// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "io/output/measures/measures.h"

/// What of a run is left to chance. Once parts have come loose and fall, a difference in the last digit grows until it is seen; some
/// figures outlive that, others do not. tests/verification/ensemble.md has the runs by which they were told apart.
namespace voussoir::io {

/// Whether something came loose and fell, so that figures are left to chance. A run in which nothing falls has none.
bool has_chance(const Measures& m);

/// Names of the figures that are left to chance, as in `voussoir summary --format json`; "walls" stands for their drifts and what has
/// fallen.
std::span<const std::string_view> figures_of_chance();

/// A sentence for a reader of the figures: since when, what holds, what does not. \pre has_chance(m)
std::string words_of_chance(const Measures& m);

}  // namespace voussoir::io
