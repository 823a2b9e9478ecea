// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace voussoir::io {

class Hdf5File;

struct SummaryOptions {
  std::string folder;  // of the run, or its run.h5
  bool json = false;   // one object for programs instead of a table for people
};

/// All that `voussoir summary --format json` says of a run, on one line. \throw FileError
std::string summary_json(const Hdf5File& run);

/// `voussoir summary`: what came out of a run, with all measures (measures.h), computed afresh from its frames; so also of a run that goes
/// on, was killed, or was made by an earlier version of the program. \throw FileError
int summary_command(const SummaryOptions& o);

}  // namespace voussoir::io
