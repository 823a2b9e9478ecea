// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "cases/house/house_plan.h"

/// Decks on beams and rafters as grids of bars. Internal to cases/.
namespace voussoir::cases {

/// A bar between neighbouring beams, a tenth of their height below their upper faces, from the middle of one element to the middle of
/// another.
struct DeckBar {
  std::array<Vec3, 2> ends;
  double stiffness = 0.0;          // N/m
  std::optional<double> strength;  // N; none: elastic
};

/// Bars and area of a deck.
///
/// Between the rows of nodes of two beams b apart, with nodes a apart along them, a cell has two diagonals of length d and stiffness G t
/// d^2 / (2 a b): under a shear angle each changes its length by (a b / d) of it, so both together store the energy of a panel G t of the
/// area a b. Diagonals yield at half the shear flow times d. Bars across the beams represent strips of the width a.
struct PlannedDeck {
  std::vector<DeckBar> bars;
  double area = 0.0;  // m2
};

/// Adds panels between neighbouring rows of nodes, one row per beam, all rows with the same number and places of nodes.
void add_panels(const std::vector<std::vector<Vec3>>& rows, const Deck& deck, PlannedDeck& planned);

/// Transforms a deck from axes of the house to those of the case, once for each copy. \param foot  m, height of the walls' foot
PlannedDeck in_all_copies(const PlannedDeck& one, const House& house, const HousePlan& plan, double foot);

/// The deck of `house.floors[index]` in all copies. \param foot  m, height of the walls' foot \throw InputError if the deck spans no beams
PlannedDeck house_deck(const House& house, std::size_t index, double foot);

/// The boards of a pitched roof in all copies. \param foot  m, height of the walls' foot \pre house.roof.deck \throw InputError if the
/// boards span no rafters
PlannedDeck roof_deck(const House& house, double foot);

}  // namespace voussoir::cases
