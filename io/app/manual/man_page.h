// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "io/app/manual/option_table.h"

/// Manual pages, for `man`: of the program, and of each command.
namespace voussoir::io {

/// A manual page with its file name: "voussoir.1", "voussoir-run.1".
struct ManPage {
  std::string file, text;
};

/// The page of the program, then those of its commands. Equal tables give equal bytes.
/// \param version  as printed by `voussoir --version`
std::vector<ManPage> man_pages(const OptionTable& table, const std::string& version);

}  // namespace voussoir::io
