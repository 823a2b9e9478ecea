// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/model.h"

namespace voussoir::cases {

/// The same elements with no joints: each by itself, whatever it overlaps or does not touch. To look at a model that build_model refuses.
/// \throw InputError for what keeps an element from being built
Model build_loose_model(const Case& c);

}  // namespace voussoir::cases
