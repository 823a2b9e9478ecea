// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cases/forward.h"

/// What is told of a run that was stopped.
namespace voussoir::io {

/// Lines for a run stopped by a signal: its position, that its figures are not those of a complete run, and how to continue it.
std::string stop_lines(const cases::Case& c, double time, int signal, const std::string& folder);
/// The same as a message in JSON: where and when it stopped, and where it is saved.
std::string stop_json(const cases::Case& c, double time, int signal, const std::string& folder);

}  // namespace voussoir::io
