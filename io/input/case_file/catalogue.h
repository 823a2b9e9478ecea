// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

/// The ready cases, built into the program so that it does not depend on its place in the file system.
namespace voussoir::io {

/// One ready case.
struct CatalogueEntry {
  std::string name, title, text;  // text: the TOML
  std::string path;               // for messages: "catalogue/flat20n.toml", or the path in the user's folder
  std::string folder;             // start of relative paths in the case
  bool built_in = false;
};

/// The ready cases by name. The *.toml files of the folder named by the environment variable VOUSSOIR_CATALOGUE, if set, are added and
/// replace cases of the same name. A file that cannot be parsed is listed with its fault as title. \throw FileError if that folder or a
/// file in it cannot be read.
std::vector<CatalogueEntry> catalogue();

/// A built-in text that ready cases include: a ready case, or a part of cases ("parts/vault-roof.toml"). Nothing if the name is unknown.
std::optional<CatalogueEntry> built_in_part(const std::string& name);

}  // namespace voussoir::io
