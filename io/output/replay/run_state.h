// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "io/input/files/hdf5_file.h"

/// Is a run at its end, does it go on, or has it been left?
namespace voussoir::io {

enum class RunEnd : std::uint8_t {
  finished,
  lost,     // to a numerical failure
  goes_on,  // a process holds the folder
  left,     // none does: it was stopped or killed
  unknown   // not finished when the file was written, and no lock of a run lies beside it: a copy
};

/// "finished", "lost", "goes on", "stopped", "unknown".
const char* name_of(RunEnd end) noexcept;

struct RunState {
  RunEnd end = RunEnd::finished;
  std::string words;  // what to know of rows that may come yet; empty of a run that is finished or lost
};

/// \throw FileError
RunState run_state(const Hdf5File& run);

/// Says on standard error, once for each file, that a run is not at its end. \throw FileError
void note_state(const Hdf5File& run);

}  // namespace voussoir::io
