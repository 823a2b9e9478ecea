// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

/// The ready cases: built into the program, so that it works wherever it is moved to.
namespace voussoir::io {

/// One ready case.
struct CatalogueEntry {
  std::string name, title, text;  // text: the TOML
  std::string path;               // for messages: "catalogue/flat20n.toml", or the path of a file of the user's folder
  std::string folder;             // where relative files of the case start
  bool built_in = false;
};

/// The ready cases by name. The *.toml files of the folder named by the environment variable VOUSSOIR_CATALOGUE, if it is set, come on top
/// and replace cases of the same name. A file that cannot be parsed is listed, with its fault as title. \throw FileError if that folder or
/// a file of it cannot be read.
std::vector<CatalogueEntry> catalogue();

/// A built-in text that ready cases include: a ready case, or a part of cases ("parts/vault-roof.toml").
std::optional<CatalogueEntry> built_in_part(const std::string& name);

}  // namespace voussoir::io
