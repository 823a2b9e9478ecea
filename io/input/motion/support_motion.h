// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cases/forward.h"

namespace voussoir::io {

/// Reads the histories of moving supports and of loads that the model names as files: CSV rows of t [s], ascending, and x, y, z [m, N];
/// lines that start with '#' are comments, one header line is allowed, and units that it states in brackets must be these. Relative paths
/// start at `folder`. \throw FileError with the line
void load_support_motions(cases::Model& model, const std::string& folder);

}  // namespace voussoir::io
