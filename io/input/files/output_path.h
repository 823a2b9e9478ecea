// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

/// Checks of the name of an output file, made before the work whose result it will contain.
namespace voussoir::io {

/// \throw FileError if the file exists and `overwrite` is false
void refuse_to_replace(const std::string& path, bool overwrite);

/// \throw FileError if the file exists and `overwrite` is false, or if its folder does not exist. An empty path means no file, and is
/// accepted.
void check_output(const std::string& path, bool overwrite);

}  // namespace voussoir::io
