// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cases/census.h"
#include "cases/model.h"

namespace voussoir::io {

/// The bill of blocks as a table. \param all  every line; otherwise those with most volume, and the rest in one
std::string bill_words(const cases::Census& n, const cases::Model& m, bool all);

}  // namespace voussoir::io
