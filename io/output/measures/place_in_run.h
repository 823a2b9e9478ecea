// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cases/forward.h"

/// Position of an unfinished run in its plan, in words.
namespace voussoir::io {

/// The stage of a run at a time [s]: "settling", "shaking", or the kind of its quasi-static analysis.
std::string stage_at(const cases::Case& c, double time);

/// Position in the run: "at 1.250 of 10 s, shaking"; "at -0.300 s, settling: the shaking of 10 s has not begun"; "at 12.500 s, pushover, of
/// 300 s at most".
std::string place_in_run(const cases::Case& c, double time);

}  // namespace voussoir::io
