// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/case.h"
#include "cases/model.h"

/// Names of ties. Internal to cases/.
namespace voussoir::cases {

/// Refuses ties of one name. \throw InputError with the key that gives the later one its name
void check_tie_names(const Case& c, const Model& model);

}  // namespace voussoir::cases
