// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/house/roofs/house_pitched.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cases/house/floors/house_decks.h"
#include "cases/house/house_parts.h"
#include "cases/input_error.h"
#include "cases/names.h"
#include "geometry/prism.h"

namespace voussoir::cases {
namespace {

using geometry::Point2;
using geometry::Polygon;

constexpr double kSteepest = 60.0, kFlattest = 5.0;  // degrees
constexpr double kSeat = 0.5;                        // greatest depth of the seat, as a share of a rafter's depth

void check_roof(const Roof& roof, double length, const std::string& key) {
  if (!(roof.pitch >= kFlattest && roof.pitch <= kSteepest))
    throw InputError(key + ".pitch",
                     text(roof.pitch) + " degrees is out of range; allowed: " + text(kFlattest) + " to " + text(kSteepest));
  const Tick width = positive_length(roof.beam[0], key + ".beam"), spacing = positive_length(roof.spacing, key + ".spacing");
  positive_length(roof.beam[1], key + ".beam");
  if (2 * width > ticks(length))
    throw InputError(key + ".beam", text(roof.beam[0]) + " m leaves no room for two pairs of rafters; at most " +
                                        text(metres(ticks(length) / 2)) + " m");
  if (spacing < width)
    throw InputError(key + ".spacing", text(roof.spacing) + " m is less than the width of a rafter, " + text(roof.beam[0]) + " m");
}

/// Ranges of the rafters along x: flush with both ends of the roof, at most `spacing` apart, unless they would overlap.
std::vector<std::array<double, 2>> rafters_along(const Roof& roof, double length) {
  const double width = roof.beam[0];
  const double wanted = std::ceil((length - width) / roof.spacing - 1e-6), most = std::floor((length - width) / width + 1e-6);
  const double bays = std::max(1.0, std::min(wanted, most));
  std::vector<std::array<double, 2>> all;
  for (int i = 0; i <= static_cast<int>(bays); ++i) {
    const double low = (length - width) * i / bays;
    all.push_back({low, low + width});
  }
  return all;
}

/// The part of a section between two plumb planes.
Polygon between(const Polygon& section, double low, double high) {
  Polygon part = section, scratch;
  geometry::clip(part, {-1.0, 0.0}, -low, scratch);
  geometry::clip(part, {1.0, 0.0}, high, scratch);
  for (Point2& p : part) {
    for (const double at : {low, high})
      if (std::abs(p.s - at) < 1e-9) p.s = at;
  }
  const auto same = [](Point2 a, Point2 b) { return std::hypot(a.s - b.s, a.t - b.t) < 1e-9; };
  part.erase(std::unique(part.begin(), part.end(), same), part.end());
  while (part.size() > 1 && same(part.front(), part.back())) part.pop_back();
  return part;
}

std::vector<std::array<double, 2>> corners_of(const Polygon& section, double depth_of_house, bool rear) {
  std::vector<std::array<double, 2>> corners;
  for (const Point2 p : section) corners.push_back({rear ? depth_of_house - p.s : p.s, p.t});
  if (rear) std::ranges::reverse(corners);
  return corners;
}

/// A point of a pair of rafters.
Vec3 on_rafter(const RafterProfile& p, double x, double y, double z, bool rear) { return {x, rear ? p.across() - y : y, z}; }

}  // namespace

RafterProfile rafter_profile(const Roof& roof, const RafterSeat& seat, const std::string& key) {
  check_roof(roof, seat.length, key);
  const double pitch = roof.pitch * std::numbers::pi / 180.0;
  RafterProfile p;
  p.slope = std::tan(pitch), p.depth = roof.beam[1] / std::cos(pitch);
  p.inner = seat.inner, p.ridge = seat.ridge, p.seat = seat.height;
  p.foot = p.inner - std::min(seat.most, kSeat * p.depth / p.slope);
  const double low = p.underside(p.foot) + p.depth, ridge = p.underside(p.ridge);
  p.section = {{p.foot, p.seat}, {p.inner, p.seat}, {p.ridge, ridge}, {p.ridge, ridge + p.depth}, {p.foot, low}};
  p.upper = (p.ridge - p.foot) / std::cos(pitch);
  const Tick span = ticks(p.ridge - p.inner), element = element_length(roof.element * std::cos(pitch), span, key + ".element");
  p.cuts = {p.foot};
  for (const Interval part : cut_member({0, span}, element)) p.cuts.push_back(p.inner + metres(part.high));
  p.cuts.back() = p.ridge;
  p.x = rafters_along(roof, seat.length);
  return p;
}

RafterProfile rafter_profile(const House& house, const HousePlan& plan) {
  if (!plan.wall(Side::front).built || !plan.wall(Side::rear).built)
    throw InputError("house.roof.kind", "rafters rest on the front and the rear wall; house.walls leaves one of them out");
  const Tick wall = plan.wall(Side::front).thickness;
  return rafter_profile(house.roof,
                        {metres(wall), 0.5 * metres(plan.outer[1]), metres(plan.height), metres(std::min(wall, plan.brick_length)),
                         metres(plan.outer[0])},
                        "house.roof");
}

Polygon pitched_gable(const RafterProfile& p, const HousePlan& plan) {
  return {{p.inner, p.seat}, {p.ridge, p.underside(p.ridge)}, {metres(plan.outer[1]) - p.inner, p.seat}};
}

double rafter_surcharge(const RafterProfile& p, const Roof& roof, double length) {
  const double strip = length / static_cast<double>(p.x.size());
  return roof.surcharge * strip * p.upper / (roof.beam[0] * geometry::region(p.section).area);
}

double rafter_surcharge(const House& house, const HousePlan& plan) {
  return rafter_surcharge(rafter_profile(house, plan), house.roof, metres(plan.outer[0]));
}

std::vector<RafterElement> rafter_elements(const RafterProfile& p) {
  std::vector<RafterElement> all;
  for (std::size_t i = 0; i < p.x.size(); ++i) {
    for (const bool rear : {false, true}) {
      for (std::size_t k = 0; k + 1 < p.cuts.size(); ++k) {
        const Polygon part = between(p.section, p.cuts[k], p.cuts[k + 1]);
        all.push_back({static_cast<int>(2 * i + (rear ? 1 : 0)),
                       geometry::make_prism(corners_of(part, p.across(), rear), p.x[i][0], p.x[i][1]), k > 0 && part.size() == 4});
      }
    }
  }
  return all;
}

void build_pitched_roof(const House& house, const HousePlan& plan, HouseParts& parts) {
  const RafterProfile p = rafter_profile(house, plan);
  Block prototype;
  prototype.kind = PartKind::beam;
  prototype.material = parts.roof;
  const Tick element = std::min(ticks(house.roof.element), ticks(p.upper));
  prototype.segment_size = segment_size_of(ticks(house.roof.beam[0]), ticks(house.roof.beam[1]), element);
  for (RafterElement& e : rafter_elements(p)) {
    prototype.tag = "rafter " + std::to_string(e.rafter);
    prototype.member = parts.members + e.rafter;
    prototype.whole = e.whole;
    parts.blocks.push_back(prototype);
    parts.blocks.back().shape = std::move(e.shape);
  }
  parts.members += static_cast<std::int32_t>(2 * p.x.size());
}

std::vector<std::array<Vec3, 2>> rafter_tie_ends(const RafterProfile& p) {
  std::vector<std::array<Vec3, 2>> all;
  for (const auto& [low, high] : p.x) {
    const double x = 0.5 * (low + high), z = p.seat + 0.25 * p.depth;
    all.push_back({on_rafter(p, x, p.inner, z, false), on_rafter(p, x, p.inner, z, true)});
  }
  return all;
}

std::vector<PlannedTie> roof_ties(const House& house, double foot) {
  std::vector<PlannedTie> all;
  if (house.roof.kind != RoofKind::pitched || !house.roof.tie) return all;
  const HousePlan plan = plan_house(house);
  const RafterProfile p = rafter_profile(house, plan);
  for (int j = 0; j < house.copies[1]; ++j) {
    for (int i = 0; i < house.copies[0]; ++i) {
      for (const auto& [from, to] : rafter_tie_ends(p)) {
        Tie tie = *house.roof.tie;
        tie.from = in_case(house, plan, i, j, from) + Vec3{0, 0, foot};
        tie.to = in_case(house, plan, i, j, to) + Vec3{0, 0, foot};
        tie.name = "roof tie " + std::to_string(all.size() + 1);
        all.push_back({tie, 0});
      }
    }
  }
  return all;
}

PlannedDeck rafter_deck(const RafterProfile& p, const Deck& deck, const std::string& key) {
  PlannedDeck one;
  for (const bool rear : {false, true}) {
    std::vector<std::vector<Vec3>> rows;
    for (const auto& [low, high] : p.x) {
      std::vector<Vec3>& row = rows.emplace_back();
      for (std::size_t k = 0; k + 1 < p.cuts.size(); ++k) {
        const double y = 0.5 * (p.cuts[k] + p.cuts[k + 1]);
        row.push_back(on_rafter(p, 0.5 * (low + high), y, p.underside(y) + 0.9 * p.depth, rear));
      }
    }
    add_panels(rows, deck, one);
  }
  if (one.bars.empty()) throw InputError(key, "spans nothing: a rafter has less than two elements");
  return one;
}

PlannedDeck roof_deck(const House& house, double foot) {
  const HousePlan plan = plan_house(house);
  return in_all_copies(rafter_deck(rafter_profile(house, plan), *house.roof.deck, "house.roof.deck"), house, plan, foot);
}

}  // namespace voussoir::cases
