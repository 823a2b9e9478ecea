// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/model.h"

/// The free blocks of a case. Internal to cases/.
namespace voussoir::cases {

/// Appends the blocks of `c.blocks` and the motions of their supports to the model, whose materials are there.
/// \throw InputError with the key at fault.
void add_free_blocks(const Case& c, Model& model);

/// The motion of a support as its keys give it. \param key  of its file
SupportHistory support_history(const SupportMotion& motion, const std::string& key);

/// Makes a block that stands by itself a part of a building: its tag, and PartKind::walling if it is of a wall ("left wall",
/// "front gable, storey 2"). \param part  empty: nothing changes
void set_part(const std::string& part, Block& block);

}  // namespace voussoir::cases
