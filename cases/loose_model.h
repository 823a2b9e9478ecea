// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/forward.h"
#include "cases/model.h"

namespace voussoir::cases {

/// The elements of a case without joints, whatever overlaps or does not touch. For viewing a model that build_model refuses.
/// \throw InputError if an element cannot be built
Model build_loose_model(const Case& c);

}  // namespace voussoir::cases
