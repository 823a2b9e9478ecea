// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/walls/spans/wall_roofs.h"

#include <algorithm>
#include <cmath>

#include "cases/house/house_parts.h"
#include "cases/house/roofs/house_pitched.h"
#include "cases/names.h"
#include "cases/walls/spans/wall_bays.h"
#include "cases/walls/wall_tops.h"
#include "geometry/nth.h"

namespace voussoir::cases {
namespace {

constexpr double kSquare = 1e-6;  // rad
constexpr double kFar = 1e5;      // m, beyond any wall

std::string roof_key(std::size_t roof, const char* field = "") { return Spanning{"roof", roof}.key(field); }

/// Sets the range of u to that from end to end of both sides, with what other walls fill of it.
void reach_to_ends(const WallsPlan& plan, Bay& bay) {
  double low = -kFar, high = kFar;
  for (const WallFace& face : bay.faces) {
    const Leg& leg = plan.legs[face.leg];
    const Station *first = leg.end(LegEnd::low), *last = leg.end(LegEnd::high);
    const double from = first == nullptr ? 0.0 : first->low(face.d), to = last == nullptr ? leg.length() : last->high(face.d);
    const double one = dot(leg.at(from, face.d) - bay.from, bay.across), other = dot(leg.at(to, face.d) - bay.from, bay.across);
    low = std::max(low, std::min(one, other)), high = std::min(high, std::max(one, other));
  }
  bay.low = low, bay.high = high;
}

/// A roof over a bay, laid out: rafters in axes of their own, x along the ridge, y from the first wall to the second.
class LaidRoof {
 public:
  LaidRoof(const std::vector<WallSpec>& walls, const WallsPlan& plan, const WallRoof& roof, std::size_t index)
      : bay_(plan.roofs[index]), length_(bay_.high - bay_.low) {
    const double one = v_of(plan, bay_, bay_.faces[0], 0.0), other = v_of(plan, bay_, bay_.faces[1], 0.0);
    from_ = one;
    double most = kFar;
    for (const WallFace& face : bay_.faces) {
      const WallSpec& wall = walls[plan.legs[face.leg].wall];
      if (roof.rafters.bearing && *roof.rafters.bearing > wall.thickness + 1e-9)
        throw InputError(roof_key(index, "bearing"), text(*roof.rafters.bearing) + " m is more than the thickness of the " +
                                                       plan.legs[face.leg].tag + "; at most " + text(wall.thickness) + " m");
      most = std::min({most, wall.thickness, wall.brick[0]});
    }
    if (roof.rafters.bearing) most = *roof.rafters.bearing;
    const double seat = metres(eaves(walls[plan.legs[bay_.faces[0].leg].wall]));
    profile_ = rafter_profile(roof.rafters, {0.0, 0.5 * (other - one), seat, most, length_}, roof_key(index));
    mirrored_ = cross(bay_.across, bay_.along).z < 0.0;
  }

  [[nodiscard]] const RafterProfile& profile() const noexcept { return profile_; }
  [[nodiscard]] double length() const noexcept { return length_; }

  [[nodiscard]] Vec3 in_case(Vec3 p) const noexcept {
    const Vec3 plan = bay_.at(bay_.low + p.x, from_ + p.y);
    return {plan.x, plan.y, p.z};
  }

  /// Elements in axes of the case, their cells in the usual order.
  [[nodiscard]] std::vector<RafterElement> elements() const {
    std::vector<RafterElement> all = rafter_elements(profile_);
    for (RafterElement& e : all) {
      if (mirrored_) e.shape = geometry::mirrored(e.shape, {1.0, 0.0, 0.0}, {0.5 * length_, 0.0, 0.0});
      for (Vec3& v : e.shape.vertices) v = in_case(mirrored_ ? Vec3{length_ - v.x, v.y, v.z} : v);
    }
    return all;
  }

 private:
  const Bay& bay_;
  double length_ = 0.0, from_ = 0.0;  // m; from_: v of the first wall's face
  RafterProfile profile_;
  bool mirrored_ = false;
};

void check_sides(const std::vector<WallSpec>& walls, const WallsPlan& plan, std::size_t index) {
  const Bay& bay = plan.roofs[index];
  const Leg &a = plan.legs[bay.faces[0].leg], &b = plan.legs[bay.faces[1].leg];
  if (std::abs(cross(a.facets[0].along, b.facets[0].along).z) > kSquare)
    throw InputError(roof_key(index, "walls"), "are not parallel: the " + a.tag + " and the " + b.tag + "; a ridge lies midway between two that are");
  if (eaves(walls[a.wall]) != eaves(walls[b.wall]))
    throw InputError(roof_key(index, "walls"), "have tops at " + metres_text(eaves(walls[a.wall])) + " and " +
                                                 metres_text(eaves(walls[b.wall])) + " m above the base: the " + a.tag + " and the " + b.tag +
                                                 "; rafters of a pair rest at one height");
}

/// Raises a side to the underside of the rafters.
void add_gable(const std::vector<WallSpec>& walls, const WallRoof& roof, std::size_t index, std::size_t gable, WallsPlan& plan) {
  const std::string key = indexed_key(roof_key(index, "gables"), gable, "");
  const std::size_t found = find_side(walls, plan, roof.gables[gable], key);
  const Bay& bay = plan.roofs[index];
  const LaidRoof laid(walls, plan, roof, index);
  const RafterProfile& p = laid.profile();
  Leg& leg = plan.legs[found];
  const Facet& f = leg.facets[0];
  if (leg.facets.size() > 1 || std::abs(cross(f.along, bay.along).z) > kSquare)
    throw InputError(key, "the " + leg.tag + " is not square to the ridge of the roof; gables are");
  if (eaves(walls[leg.wall]) != ticks(p.seat))
    throw InputError(key, "the " + leg.tag + " ends at " + metres_text(eaves(walls[leg.wall])) + " m above the base, and the rafters rest at " +
                              text(p.seat) + " m; a gable begins at that height");
  const double u = dot(leg.at(0.5 * leg.length(), 0.0) - bay.from, bay.across);
  if (u + leg.half < bay.low - kPlanTolerance || u - leg.half > bay.high + kPlanTolerance)
    throw InputError(key, "the " + leg.tag + " does not stand under the roof");
  const auto place = [&](double y) { return dot(laid.in_case({u - bay.low, y, 0.0}) - f.from, f.along); };
  geometry::Polygon top{{place(0.0), p.seat}, {place(p.ridge), p.underside(p.ridge)}, {place(p.across()), p.seat}};
  if (top.front().s > top.back().s) std::ranges::reverse(top);
  const Station *first = leg.end(LegEnd::low), *last = leg.end(LegEnd::high);
  if (top.front().s < (first == nullptr ? 0.0 : first->low.at) - kPlanTolerance ||
      top.back().s > (last == nullptr ? leg.length() : last->high.at) + kPlanTolerance)
    throw InputError(key, "the " + leg.tag + " does not reach from the " + plan.legs[bay.faces[0].leg].tag + " to the " +
                              plan.legs[bay.faces[1].leg].tag + "; a gable does");
  top.insert(top.begin(), {-kFar, p.seat}), top.push_back({kFar, p.seat});
  raise(walls[leg.wall], top, key, leg);
}

std::string surcharged_name(const WallRoof& roof) {
  return roof.material + " of roof " + roof.name + " with " + text(roof.rafters.surcharge) + " kg/m2";
}

}  // namespace

void plan_wall_roofs(const std::vector<WallSpec>& walls, const std::vector<WallRoof>& roofs, WallsPlan& plan) {
  Faults faults;
  plan.roofs.resize(roofs.size());
  for (std::size_t i = 0; i < roofs.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (roofs[k].name == roofs[i].name)
        faults.add({roof_key(i, "name"), quoted(roofs[i].name) + " is already the name of " + roof_key(k)});
    }
    const bool lies = faults.attempt([&] {
      plan.roofs[i] = find_bay(walls, plan, {"roof", i}, roofs[i].walls, std::nullopt, roofs[i].corners);
      if (roofs[i].corners.empty()) reach_to_ends(plan, plan.roofs[i]);
      check_sides(walls, plan, i);
      LaidRoof(walls, plan, roofs[i], i);
    });
    for (std::size_t g = 0; lies && g < roofs[i].gables.size(); ++g) faults.attempt([&] { add_gable(walls, roofs[i], i, g, plan); });
  }
  faults.raise();
}

std::vector<NamedMaterial> loaded_roof_materials(const std::vector<WallSpec>& walls, const WallsPlan& plan,
                                                 const std::vector<WallRoof>& roofs, std::span<const NamedMaterial> materials) {
  std::vector<NamedMaterial> all;
  for (std::size_t i = 0; i < roofs.size(); ++i) {
    if (roofs[i].rafters.surcharge == 0.0) continue;
    if (!(roofs[i].rafters.surcharge > 0.0 && roofs[i].rafters.surcharge < 1e5))
      throw InputError(roof_key(i, "surcharge"), text(roofs[i].rafters.surcharge) + " kg/m2 is out of range; allowed: 0 to 100000");
    const std::int32_t bare = find_material(materials, roofs[i].material, roof_key(i, "material"));
    const LaidRoof laid(walls, plan, roofs[i], i);
    all.push_back({surcharged_name(roofs[i]), nth(materials, bare).value, bare});
    all.back().value.density += rafter_surcharge(laid.profile(), roofs[i].rafters, laid.length());
  }
  return all;
}

void add_rafters(const std::vector<WallSpec>& walls, const WallsPlan& plan, const std::vector<WallRoof>& roofs,
                 std::span<const NamedMaterial> materials, std::int32_t& members, std::vector<Block>& blocks) {
  for (std::size_t i = 0; i < roofs.size(); ++i) {
    const WallRoof& roof = roofs[i];
    const LaidRoof laid(walls, plan, roof, i);
    const RafterProfile& p = laid.profile();
    Block block;
    block.kind = PartKind::beam;
    block.span = static_cast<std::int32_t>(i);
    block.material = roof.rafters.surcharge > 0.0 ? find_material(materials, surcharged_name(roof), roof_key(i, "surcharge"))
                                                  : find_material(materials, roof.material, roof_key(i, "material"));
    block.segment_size = segment_size_of(ticks(roof.rafters.beam[0]), ticks(roof.rafters.beam[1]),
                                         std::min(ticks(roof.rafters.element), ticks(p.upper)));
    for (RafterElement& e : laid.elements()) {
      block.tag = roof.name + " rafter " + std::to_string(e.rafter);
      block.member = members + e.rafter;
      block.whole = e.whole;
      block.shape = std::move(e.shape);
      blocks.push_back(block);
    }
    members += static_cast<std::int32_t>(2 * p.x.size());
  }
}

std::vector<PlannedTie> wall_roof_ties(const std::vector<WallSpec>& walls, const WallsPlan& plan, const std::vector<WallRoof>& roofs,
                                       double foot) {
  std::vector<PlannedTie> all;
  for (std::size_t i = 0; i < roofs.size(); ++i) {
    if (!roofs[i].rafters.tie) continue;
    const LaidRoof laid(walls, plan, roofs[i], i);
    int number = 0;
    for (const auto& [from, to] : rafter_tie_ends(laid.profile())) {
      Tie tie = *roofs[i].rafters.tie;
      tie.from = laid.in_case(from) + Vec3{0, 0, foot}, tie.to = laid.in_case(to) + Vec3{0, 0, foot};
      tie.name = roofs[i].name + " tie " + std::to_string(++number);
      all.push_back({tie, i});
    }
  }
  return all;
}

PlannedDeck wall_roof_deck(const std::vector<WallSpec>& walls, const WallsPlan& plan, const std::vector<WallRoof>& roofs,
                           std::size_t index, double foot) {
  const LaidRoof laid(walls, plan, roofs[index], index);
  PlannedDeck deck = rafter_deck(laid.profile(), *roofs[index].rafters.deck, roof_key(index, "deck"));
  for (DeckBar& bar : deck.bars) {
    for (Vec3& end : bar.ends) end = laid.in_case(end) + Vec3{0, 0, foot};
  }
  return deck;
}

}  // namespace voussoir::cases
