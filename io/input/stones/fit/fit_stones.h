// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "cases/forward.h"
#include "io/input/stones/fit/stone_item.h"

/// Stones of a case with `stones.fit = "planes"`. Internal to io/input/stones/.
namespace voussoir::io {

/// Whether the stones of a case are fitted to planes. \throw cases::InputError if some tables of stones say so and others do not
bool fits_planes(const cases::Case& c);

/// Fits stones to planes of the pairs that touch: fills in their pieces, and what was done to each; adds a summary to the notes of their
/// tables. \return by item, why it is refused; empty: it is not
std::vector<std::string> fit_stones(cases::Case& c, std::span<StoneItem> items);

}  // namespace voussoir::io
