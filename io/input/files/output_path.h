// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

/// Checks of the name of an output file, made before the work of which it is to hold the result.
namespace voussoir::io {

/// \throw FileError if the file exists, unless it is to be replaced
void refuse_to_replace(const std::string& path, bool overwrite);

/// The same, and if the folder of the file is not there. An empty name: no file is wanted. \throw FileError
void check_output(const std::string& path, bool overwrite);

}  // namespace voussoir::io
