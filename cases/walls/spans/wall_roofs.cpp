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

constexpr double kFar = 1e5;  // m, beyond any wall

std::string roof_key(std::size_t roof, const char* field = "") { return Spanning{"roof", roof}.key(field); }

/// A roof over a bay, laid out: rafters in axes of their own, x along the ridge, y from the first wall to the second.
class LaidRoof {
 public:
  LaidRoof(const std::vector<WallSpec>& walls, const WallsPlan& plan, const WallRoof& roof, std::size_t index)
      : axes_(plan, plan.roofs[index]) {
    const Bay& bay = axes_.bay();
    double most = kFar;
    for (const WallFace& face : bay.faces) {
      const WallSpec& wall = walls[plan.legs[face.leg].wall];
      if (roof.rafters.bearing && *roof.rafters.bearing > wall.thickness + 1e-9)
        throw InputError(roof_key(index, "bearing"), text(*roof.rafters.bearing) + " m is more than the thickness of the " +
                                                         plan.legs[face.leg].tag + "; at most " + text(wall.thickness) + " m");
      most = std::min({most, wall.thickness, wall.brick[0]});
    }
    if (roof.rafters.bearing) most = *roof.rafters.bearing;
    const double seat = metres(eaves(walls[plan.legs[bay.faces[0].leg].wall]));
    profile_ = rafter_profile(roof.rafters, {0.0, 0.5 * axes_.span(), seat, most, axes_.length()}, roof_key(index));
  }

  [[nodiscard]] const RafterProfile& profile() const noexcept { return profile_; }
  [[nodiscard]] const BayAxes& axes() const noexcept { return axes_; }

  /// Elements in axes of the case, their cells in the usual order.
  [[nodiscard]] std::vector<RafterElement> elements() const {
    std::vector<RafterElement> all = rafter_elements(profile_);
    for (RafterElement& e : all) e.shape = axes_.in_case(std::move(e.shape));
    return all;
  }

 private:
  BayAxes axes_;
  RafterProfile profile_;
};

/// The underside of the rafters, from wall to wall.
geometry::Polygon underside_of(const RafterProfile& p) { return {{0.0, p.seat}, {p.ridge, p.underside(p.ridge)}, {p.across(), p.seat}}; }

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
      check_level_pair(walls, plan, {"roof", i}, plan.roofs[i],
                       {"a ridge lies midway between two that are", "rafters of a pair rest at one height"});
      LaidRoof(walls, plan, roofs[i], i);
    });
    for (std::size_t g = 0; lies && g < roofs[i].gables.size(); ++g)
      faults.attempt([&] {
        const LaidRoof laid(walls, plan, roofs[i], i);
        raise_to(walls, roofs[i].gables[g], indexed_key(roof_key(i, "gables"), g, ""), laid.axes(), underside_of(laid.profile()),
                 {"roof", i}, plan);
      });
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
    all.back().value.density += rafter_surcharge(laid.profile(), roofs[i].rafters, laid.axes().length());
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
    block.segment_size =
        segment_size_of(ticks(roof.rafters.beam[0]), ticks(roof.rafters.beam[1]), std::min(ticks(roof.rafters.element), ticks(p.upper)));
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
      tie.from = laid.axes().in_case(from) + Vec3{0, 0, foot}, tie.to = laid.axes().in_case(to) + Vec3{0, 0, foot};
      tie.name = roofs[i].name + " tie " + std::to_string(++number);
      all.push_back({tie, i});
    }
  }
  return all;
}

PlannedDeck wall_roof_deck(const std::vector<WallSpec>& walls, const WallsPlan& plan, const std::vector<WallRoof>& roofs, std::size_t index,
                           double foot) {
  const LaidRoof laid(walls, plan, roofs[index], index);
  PlannedDeck deck = rafter_deck(laid.profile(), *roofs[index].rafters.deck, roof_key(index, "deck"));
  for (DeckBar& bar : deck.bars) {
    for (Vec3& end : bar.ends) end = laid.axes().in_case(end) + Vec3{0, 0, foot};
  }
  return deck;
}

}  // namespace voussoir::cases
