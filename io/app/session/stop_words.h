// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cases/case.h"

/// Where a run is that has not come to its end.
namespace voussoir::io {

/// The stage of a run at a time [s]: "settling", "shaking", or the kind of its quasi-static analysis.
std::string stage_at(const cases::Case& c, double time);

/// "at 1.250 of 10 s, shaking"; "at -0.300 s, settling: the shaking of 10 s has not begun"; "at 12.500 s, pushover, of 300 s at most".
std::string place_in_run(const cases::Case& c, double time);

/// Lines of a run that a signal has stopped: where, that its figures are no results of a whole run, and how it goes on.
std::string stop_lines(const cases::Case& c, double time, int signal, const std::string& folder);

}  // namespace voussoir::io
