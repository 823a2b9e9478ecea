// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "io/input/case_file/case_file.h"
#include "io/input/document/case_tree.h"

/// Finds the text of a case by name, and merges it with the files that it includes into one document.
namespace voussoir::io {

/// A case and its includes as one tree.
struct Document {
  Node root;
  std::vector<std::string> files;  // by Source::file, for messages; the first is the case itself
};

/// Finds a case by a name of the catalogue, else by path, as load_case. Relative paths start at `folder`; "": the working folder.
/// \throw FileError, CaseFileError as load_case.
CaseText find_case(const std::string& name, const std::string& folder = "");

/// Parses a case. Its key `include`, a string or an array of strings, names files (relative to the including case) or ready cases, which
/// are read first, in order. A later table is merged into an earlier one of the same path key by key; any other value, also an array of
/// tables, replaces the earlier one. A source of motion replaces sources of other kinds (motion_keys.h).
/// \throw FileError, CaseFileError for a file that cannot be read or parsed, or for circular includes.
Document read_document(const CaseText& text);

}  // namespace voussoir::io
