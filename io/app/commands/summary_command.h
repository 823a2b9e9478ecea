// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace voussoir::io {

class Hdf5File;

/// The output of `voussoir summary --format json` for a run, on one line. \throw FileError
std::string summary_json(const Hdf5File& run);

}  // namespace voussoir::io
