// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "cases/case.h"
#include "io/input/document/case_tree.h"

/// The paths to files and folders that a case names: one list for the document and for the case that was read from it.
namespace voussoir::io {

using PathChange = std::function<void(std::string&)>;

/// Calls `change` with each path; names of built-in records are none.
void for_each_path(cases::Case& value, const PathChange& change);

/// The same of a document. What has another type than a path's is left to the option tables, which refuse it.
void for_each_path(Node& document, const PathChange& change);

}  // namespace voussoir::io
