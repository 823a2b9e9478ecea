// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/world.h"

/// Stages 2 and 3b of the step: which free patches may touch which elements, and the forces of those that do.
namespace voussoir::solver {

/// True if some element may have moved more than half the skin since the last search.
/// Call once a step: it also counts down to the search that retired sides ask for.
bool search_due(World& w);

/// Broad phase on the uniform grid, then patch against element by separating planes; rebuilds candidates, slots and gather lists.
void search_contacts(World& w);

/// Lists for every element the slots that push it. search_contacts does it; so must whoever adds slots in between.
void build_gather(World& w);

/// Forces of all active patches, gathered by every element in a fixed order.
void contact_forces(World& w);

/// Turns a side that has come apart into free patches of its two elements. Points that touch keep their partner, slip and closure.
void retire_side(World& w, std::int32_t side);

/// Blocks that still hold a side, by colour. Call after sides have retired.
void list_live_blocks(World& w);

}  // namespace voussoir::solver
