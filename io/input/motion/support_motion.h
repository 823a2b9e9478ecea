// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cases/model.h"

namespace voussoir::io {

/// Reads the histories of moving supports and of loads that the model still only names: CSV rows of t [s], x, y, z [m, N], t rising; lines
/// that start with '#' are comments, and one header line may stand first; units that it states in brackets must be these. Relative paths
/// start at `folder`. \throw FileError with the line
void load_support_motions(cases::Model& model, const std::string& folder);

}  // namespace voussoir::io
