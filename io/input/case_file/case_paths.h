// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "cases/forward.h"
#include "io/input/document/case_tree.h"

/// The paths to files and folders in a case: one list for the document and for the case read from it.
namespace voussoir::io {

using PathChange = std::function<void(std::string&)>;

/// Calls `change` with each path; names of built-in records are not paths.
void for_each_path(cases::Case& value, const PathChange& change);

/// Calls `change` with each path of a document. Values of a wrong type are skipped; the option tables refuse them.
void for_each_path(Node& document, const PathChange& change);

}  // namespace voussoir::io
