// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "io/input/case_file/case_file.h"

namespace CLI {
class App;
}

/// Options that select and change a case, and the case that results.
namespace voussoir::io {

/// Words of the command line, not yet interpreted.
struct CaseWords {
  std::string name;                                            // CASE
  std::vector<std::string> set;                                // --set key=value
  std::vector<std::string> motion;                             // --motion axis=file
  std::string direction, record, scale, duration, dt, frames;  // short names of keys of the case
  int threads = 0;                                             // -j; once the program has begun to work, never 0
};

/// Adds CASE, --set and -j.
void add_case(CLI::App& command, CaseWords& w);

/// Adds short names of keys of the case: --direction, --record, ... Their values become overrides, so the resolved case contains them.
void add_short_keys(CLI::App& command, CaseWords& w);

/// What of a case stands elsewhere, or is computed.
enum class Fill : std::uint8_t {
  all,     // its stones, and damping.frequency = "auto"
  stones,  // of use where nothing is damped
  none     // `use` reads the stones itself, and also shows refused ones
};

/// Reads the case, its stones and its record, prints its notes and warnings, and calls `use`. Reports input faults thrown by `use` with
/// file, line and key. \param fill  what of the case is found before \return the exit code
/// \throw cases::InputError, FileError of the case itself
int with_case(const CaseWords& w, const std::function<int(const LoadedCase&)>& use, Fill fill = Fill::all);

}  // namespace voussoir::io
