// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cases/model.h"

/// What the loads of a case act on.
namespace voussoir::cases {

/// Checks that every load names a free-standing block that can move. \throw InputError with the key at fault.
void check_loads(const Case& c);

/// The elements that load `index` acts on: those that have the name of its block or group and are free to move.
/// \throw InputError at load[index].block if nothing has that name, or all that has it is fixed, so that the load would do nothing
std::vector<std::int32_t> loaded_elements(const Model& model, const Load& load, std::size_t index);

}  // namespace voussoir::cases
