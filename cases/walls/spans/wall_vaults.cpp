// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/walls/spans/wall_vaults.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cases/house/house_parts.h"
#include "cases/names.h"
#include "cases/walls/spans/wall_bays.h"
#include "cases/walls/spans/wall_vault_courses.h"
#include "geometry/nth.h"

namespace voussoir::cases {
namespace {

/// A barrel vault over its bay.
struct LaidVault {
  LaidVault(const std::vector<WallSpec>& walls, const WallsPlan& plan, const WallVault& vault, std::size_t index)
      : axes(plan, plan.vaults[index]), ring(vault, index, axes.span(), metres(eaves(walls[plan.legs[axes.bay().faces[0].leg].wall]))) {
    for (const WallFace& face : axes.bay().faces) {
      const WallSpec& wall = walls[plan.legs[face.leg].wall];
      if (ring.foot() > wall.thickness + 1e-9)
        throw InputError(vault_key(index, "thickness"), text(vault.thickness) + " m makes feet of " +
                                                            text(std::round(ring.foot() * 1e4) * 1e-4) + " m, wider than the " +
                                                            plan.legs[face.leg].tag + ", " + text(wall.thickness) + " m");
    }
    element_length(vault.ring, ticks(axes.length()), vault_key(index, "ring"));
  }
  BayAxes axes;
  VaultProfile ring;
};

/// Refuses keys of other kinds of vault, and what holds no keystone.
void check_kind(const WallVault& vault, std::size_t index) {
  const bool barrel = vault.kind == VaultKind::barrel;
  const auto refuse = [&](const char* key, bool given, const char* why) {
    if (given) throw InputError(vault_key(index, key), why);
  };
  refuse("gables", !barrel && !vault.gables.empty(),
         "belong to barrel vaults; the walls under a cross vault rise to its soffit as they are");
  refuse("corners", !barrel && !vault.corners.empty(), "belong to barrel vaults; others fill the room between their walls");
  refuse("oculus", vault.oculus && (barrel || vault.kind == VaultKind::cross), "belongs to pavilion vaults and domes");
  if (!barrel && vault.voussoirs % 2 == 0)
    throw InputError(vault_key(index, "voussoirs"), std::to_string(vault.voussoirs) +
                                                        " voussoirs from wall to wall have none in the crown; "
                                                        "allowed: an odd number");
}

/// A vault over a whole room.
struct LaidRoom {
  LaidRoom(const std::vector<WallSpec>& walls, const WallsPlan& plan, const WallVault& vault, std::size_t index)
      : room(find_room(walls, plan, vault, index)), profile(vault, index, room.span(), room.seat) {
    check_feet(walls, plan, vault, index, room, profile.foot(), vault.kind == VaultKind::cross ? 0.2 * vault.ring : 0.0);
  }
  VaultRoom room;
  VaultProfile profile;
};

/// Raises the walls round a cross vault to its soffit.
void raise_round(const std::vector<WallSpec>& walls, const WallVault& vault, std::size_t index, WallsPlan& plan) {
  const LaidRoom laid(walls, plan, vault, index);
  for (std::size_t i = 0; i < 4; ++i) {
    const Spanning what{"vault", index};
    Bay bay = find_bay(walls, plan, what, {vault.walls[(i + 3) % 4], vault.walls[(i + 1) % 4]}, std::nullopt, {});
    reach_to_ends(plan, bay);
    const BayAxes axes(plan, bay);
    geometry::Polygon line = laid.profile.soffit();
    for (geometry::Point2& p : line) p.s *= 0.5 * axes.span() / laid.profile.half();
    raise_to(walls, vault.walls[i], indexed_key(vault_key(index, "walls"), i, ""), axes, line, what, plan);
  }
}

/// Mass of the surcharge over the volume of a vault [kg/m3].
double surcharge_over_volume(const std::vector<WallSpec>& walls, const WallsPlan& plan, const WallVault& vault, std::size_t index) {
  if (vault.kind == VaultKind::barrel) return vault.surcharge * LaidVault(walls, plan, vault, index).ring.face_over_area();
  const LaidRoom laid(walls, plan, vault, index);
  double outer = 0.0, volume = 0.0;
  for (const VaultStone& stone : vault_stones(plan, laid.room, laid.profile, vault))
    outer += stone.outer, volume += geometry::mass_properties(stone.shape).volume;
  return vault.surcharge * outer / volume;
}

/// The rings of a barrel vault. \param block  with what all voussoirs share
void add_rings(const LaidVault& laid, const WallVault& vault, Block block, std::vector<Block>& blocks) {
  const Tick length = ticks(laid.axes.length()), ring = ticks(vault.ring);
  block.segment_size = 0.25 * std::min({laid.ring.length(), vault.thickness, metres(std::min(ring, length))});
  int number = 0;
  for (const Interval x : cut_member({0, length}, ring)) {
    block.tag = vault.name + " ring " + std::to_string(number++);
    block.whole = x.length() == ring;
    for (int k = 0; k < vault.voussoirs; ++k) {
      std::vector<std::array<double, 2>> corners;
      for (const geometry::Point2 p : laid.ring.section(k)) corners.push_back({p.s, p.t});
      block.shape = laid.axes.in_case(geometry::make_prism(corners, metres(x.low), metres(x.high)));
      blocks.push_back(block);
    }
  }
}

/// Likewise the voussoirs of a vault over a whole room.
void add_stones(const LaidRoom& laid, const WallsPlan& plan, const WallVault& vault, Block block, std::vector<Block>& blocks) {
  block.segment_size = 0.25 * std::min({laid.profile.length(), vault.thickness, vault.ring});
  for (VaultStone& stone : vault_stones(plan, laid.room, laid.profile, vault)) {
    block.tag = vault.name + " " + stone.part;
    block.whole = stone.whole;
    block.shape = std::move(stone.shape);
    blocks.push_back(block);
  }
}

std::string surcharged_name(const WallVault& vault) {
  return vault.material + " of vault " + vault.name + " with " + text(vault.surcharge) + " kg/m2";
}

}  // namespace

void plan_wall_vaults(const std::vector<WallSpec>& walls, const std::vector<WallVault>& vaults, WallsPlan& plan) {
  Faults faults;
  plan.vaults.resize(vaults.size());
  for (std::size_t i = 0; i < vaults.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (vaults[k].name == vaults[i].name)
        faults.add({vault_key(i, "name"), quoted(vaults[i].name) + " is already the name of " + vault_key(k)});
    }
    const bool lies = faults.attempt([&] {
      check_kind(vaults[i], i);
      if (vaults[i].kind == VaultKind::cross) return raise_round(walls, vaults[i], i, plan);
      if (vaults[i].kind != VaultKind::barrel) return void(LaidRoom(walls, plan, vaults[i], i));
      plan.vaults[i] = find_bay(walls, plan, {"vault", i}, vaults[i].walls, std::nullopt, {});
      reach_to_ends(plan, plan.vaults[i]);
      if (!vaults[i].corners.empty()) bound(plan, {"vault", i}, vaults[i].corners, 0.0, plan.vaults[i]);
      check_level_pair(walls, plan, {"vault", i}, plan.vaults[i],
                       {"a barrel vault spans between two that are", "the feet of a barrel vault rest at one height"});
      LaidVault(walls, plan, vaults[i], i);
    });
    for (std::size_t g = 0; lies && g < vaults[i].gables.size(); ++g) {
      faults.attempt([&] {
        const LaidVault laid(walls, plan, vaults[i], i);
        raise_to(walls, vaults[i].gables[g], indexed_key(vault_key(i, "gables"), g, ""), laid.axes, laid.ring.soffit(), {"vault", i}, plan);
      });
    }
  }
  faults.raise();
}

std::vector<NamedMaterial> loaded_vault_materials(const std::vector<WallSpec>& walls, const WallsPlan& plan,
                                                  const std::vector<WallVault>& vaults, std::span<const NamedMaterial> materials) {
  std::vector<NamedMaterial> all;
  for (std::size_t i = 0; i < vaults.size(); ++i) {
    if (vaults[i].surcharge == 0.0) continue;
    const std::int32_t bare = find_material(materials, vaults[i].material, vault_key(i, "material"));
    all.push_back({surcharged_name(vaults[i]), nth(materials, bare).value, bare});
    all.back().value.density += surcharge_over_volume(walls, plan, vaults[i], i);
  }
  return all;
}

void add_vaults(const std::vector<WallSpec>& walls, const WallsPlan& plan, const std::vector<WallVault>& vaults,
                std::span<const NamedMaterial> materials, std::vector<Block>& blocks) {
  for (std::size_t i = 0; i < vaults.size(); ++i) {
    const WallVault& vault = vaults[i];
    Block block;
    block.kind = PartKind::voussoir;
    block.vault = static_cast<std::int32_t>(i);
    block.material = vault.surcharge > 0.0 ? find_material(materials, surcharged_name(vault), vault_key(i, "surcharge"))
                                           : find_material(materials, vault.material, vault_key(i, "material"));
    if (vault.kind == VaultKind::barrel)
      add_rings(LaidVault(walls, plan, vault, i), vault, block, blocks);
    else
      add_stones(LaidRoom(walls, plan, vault, i), plan, vault, block, blocks);
  }
}

}  // namespace voussoir::cases
