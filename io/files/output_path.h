// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

/// What can be said of the name of a file before the work whose result it is to hold.
namespace voussoir::io {

/// \throw FileError if the file exists, unless it is to be replaced
void refuse_to_replace(const std::string& path, bool overwrite);

/// The same, and if the folder of the file is not there. An empty name: no file is wanted. \throw FileError
void check_output(const std::string& path, bool overwrite);

}  // namespace voussoir::io
