// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/house/floors/house_decks.h"

#include "cases/house/house_parts.h"
#include "cases/input_error.h"
#include "cases/names.h"

namespace voussoir::cases {
namespace {

/// Adds the panel between two rows of nodes.
void add_panel(const std::vector<Vec3>& low, const std::vector<Vec3>& high, const Deck& deck, PlannedDeck& planned) {
  for (std::size_t n = 0; n < low.size(); ++n) {
    const double b = norm(high[n] - low[n]);
    const double before = n == 0 ? 0.0 : norm(low[n] - low[n - 1]), after = n + 1 < low.size() ? norm(low[n + 1] - low[n]) : 0.0;
    const double width = 0.5 * (before + after);
    if (width > 0.0)
      planned.bars.push_back(
          {{low[n], high[n]}, deck.stiffness * width / b, deck.strength ? std::optional(*deck.strength * width) : std::nullopt});
    if (after == 0.0) continue;
    const double d = norm(high[n + 1] - low[n]), stiffness = deck.shear_stiffness * d * d / (2.0 * after * b);
    const std::optional<double> strength = deck.shear_strength ? std::optional(0.5 * *deck.shear_strength * d) : std::nullopt;
    planned.bars.push_back({{low[n], high[n + 1]}, stiffness, strength});
    planned.bars.push_back({{low[n + 1], high[n]}, stiffness, strength});
    planned.area += after * b;
  }
}

}  // namespace

void add_panels(const std::vector<std::vector<Vec3>>& rows, const Deck& deck, PlannedDeck& planned) {
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) add_panel(rows[i], rows[i + 1], deck, planned);
}

PlannedDeck in_all_copies(const PlannedDeck& one, const House& house, const HousePlan& plan, double foot) {
  PlannedDeck all;
  all.area = one.area * house.copies[0] * house.copies[1];
  for (int j = 0; j < house.copies[1]; ++j) {
    for (int i = 0; i < house.copies[0]; ++i) {
      for (DeckBar bar : one.bars) {
        for (Vec3& end : bar.ends) end = in_case(house, plan, i, j, end) + Vec3{0, 0, foot};
        all.bars.push_back(bar);
      }
    }
  }
  return all;
}

PlannedDeck house_deck(const House& house, std::size_t index, double foot) {
  const HousePlan plan = plan_house(house);
  const Floor& floor = house.floors[index];
  const FloorPlan& laid = plan.floors[index];
  const double bearing = metres(ticks(floor.bearing)), z = metres(laid.height.low) + 0.9 * metres(laid.height.length());
  std::vector<double> nodes;  // along the beams: middles of the elements between the walls
  for (const Interval part : cut_member(laid.length, ticks(floor.element))) {
    const double at = 0.5 * metres(part.low + part.high);
    if (at > metres(laid.length.low) + bearing && at < metres(laid.length.high) - bearing) nodes.push_back(at);
  }
  PlannedDeck one;
  for (const std::vector<Interval>& room : laid.rooms) {
    std::vector<std::vector<Vec3>> rows;
    for (const Interval beam : room) {
      const double across = 0.5 * metres(beam.low + beam.high);
      std::vector<Vec3>& row = rows.emplace_back();
      for (const double along : nodes) row.push_back(floor.along == PlanAxis::x ? Vec3{along, across, z} : Vec3{across, along, z});
    }
    add_panels(rows, *floor.deck, one);
  }
  if (one.bars.empty())
    throw InputError(indexed_key("house.floor", index, "deck"),
                     "spans nothing: no room has two beams, each with two elements between the walls");
  return in_all_copies(one, house, plan, foot);
}

}  // namespace voussoir::cases
