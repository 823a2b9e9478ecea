// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/forward.h"
#include "cases/model.h"
#include "cases/tables/blocks.h"

/// Free blocks of a case. Internal to cases/.
namespace voussoir::cases {

/// Appends the blocks of `c.blocks` and the motions of their supports to the model. \pre the materials are in the model
/// \throw InputError with the key at fault
void add_free_blocks(const Case& c, Model& model);

/// \param key  of the motion \throw InputError unless it says one kind of motion
void check_motion(const SupportMotion& motion, const std::string& key);

/// The motion of a support from its keys. \param key  of its file
SupportHistory support_history(const SupportMotion& motion, const std::string& key);

/// Assigns a free block to a part of a building: sets its tag, and PartKind::walling if the part is a wall ("left wall", "front gable,
/// storey 2"). \param part  empty: nothing changes
void set_part(const std::string& part, Block& block);

}  // namespace voussoir::cases
