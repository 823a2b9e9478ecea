// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "io/input/case_file/case_file.h"
#include "io/input/document/case_tree.h"

/// From a name to one document: finds the text of a case, and lays it over what it includes.
namespace voussoir::io {

/// A case and all that it includes, as one tree.
struct Document {
  Node root;
  std::vector<std::string> files;  // by Source::file, for messages; the case itself is the first
};

/// A name of the catalogue, else a path, as load_case says. Relative paths start at `folder`, "" for where the program was started.
/// \throw FileError, CaseFileError as load_case.
CaseText find_case(const std::string& name, const std::string& folder = "");

/// Parses a case. Its key `include`, a string or an array of strings, names files (relative to the case that includes them) or ready cases;
/// they are read first, in their order. A later table is merged into an earlier one of the same path key by key; any other value, an array
/// of tables too, replaces the earlier one. A source of motion takes the place of another kind (motion_keys.h).
/// \throw FileError, CaseFileError for a file that cannot be read or parsed, or includes that go in a circle.
Document read_document(const CaseText& text);

}  // namespace voussoir::io
