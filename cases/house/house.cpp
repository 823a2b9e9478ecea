// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/house/house.h"

#include <algorithm>
#include <utility>

#include "cases/house/floors/house_floors.h"
#include "cases/house/house_parts.h"
#include "cases/house/roofs/house_pitched.h"
#include "cases/house/roofs/house_vault.h"
#include "cases/input_error.h"
#include "cases/names.h"
#include "geometry/nth.h"

namespace voussoir::cases {
namespace {

/// Rotates exactly: coordinates are swapped and negated, never multiplied by a rounded cosine.
Vec3 turned(Vec3 v, int quarter_turns) noexcept {
  for (int i = 0; i < quarter_turns; ++i) v = {-v.y, v.x, v.z};
  return v;
}

std::vector<Block> placed_copies(const House& house, const HousePlan& plan, const HouseParts& parts) {
  std::vector<Block> all;
  all.reserve(parts.blocks.size() * static_cast<std::size_t>(house.copies[0]) * static_cast<std::size_t>(house.copies[1]));
  for (int j = 0; j < house.copies[1]; ++j) {
    for (int i = 0; i < house.copies[0]; ++i) {
      for (const Block& block : parts.blocks) {
        all.push_back(block);
        all.back().house = i + j * house.copies[0];
        for (Vec3& v : all.back().shape.vertices) v = in_case(house, plan, i, j, v);
      }
    }
  }
  return all;
}

/// Whether the roof is of timber: flat and pitched roofs are.
bool is_of_timber(const Roof& roof) noexcept { return roof.kind == RoofKind::flat || roof.kind == RoofKind::pitched; }

const std::string& bare_roof_material(const House& house) { return is_of_timber(house.roof) ? house.wood.material : house.material; }

std::string surcharged_name(const House& house) {
  return bare_roof_material(house) + " with roof surcharge " + text(house.roof.surcharge) + " kg/m2";
}

/// Index of the material of the roof's beams or voussoirs.
std::int32_t roof_material(const House& house, std::span<const NamedMaterial> materials, const HouseParts& parts) {
  if (house.roof.surcharge > 0.0) return find_material(materials, surcharged_name(house), "house.roof.surcharge");
  return is_of_timber(house.roof) ? parts.timber : parts.masonry;
}

std::string floor_name(const House& house, std::size_t index) {
  const Floor& floor = house.floors[index];
  return house.wood.material + " of floor " + std::to_string(floor.storey) + " with " + text(floor.load) + " kg/m2";
}

/// Index of the material of a floor's beams.
std::int32_t floor_material(const House& house, std::size_t index, std::span<const NamedMaterial> materials, const HouseParts& parts) {
  if (house.floors[index].load == 0.0) return parts.timber;
  return find_material(materials, floor_name(house, index), indexed_key("house.floor", index, "load"));
}

std::optional<NamedMaterial> surcharged_roof(const House& house, std::span<const NamedMaterial> materials) {
  const Roof& roof = house.roof;
  if (roof.surcharge == 0.0) return std::nullopt;
  if (!(roof.surcharge > 0.0 && roof.surcharge < 1e5))
    throw InputError("house.roof.surcharge", text(roof.surcharge) + " kg/m2 is out of range; allowed: 0 to 100000");
  if (!is_of_timber(roof) && roof.kind != RoofKind::vault)
    throw InputError("house.roof.surcharge", text(roof.surcharge) + " kg/m2, but there is no roof to carry it; allowed: 0");
  const char* key = is_of_timber(roof) ? "house.wood.material" : "house.material";
  const std::int32_t bare = find_material(materials, bare_roof_material(house), key);
  NamedMaterial loaded{surcharged_name(house), nth(materials, bare).value, bare};
  loaded.value.density += roof.kind == RoofKind::pitched ? rafter_surcharge(house, plan_house(house)) : surcharge_density(house);
  return loaded;
}

/// The material of a floor's beams, with the load of a strip as wide as the beam spacing added to their density.
std::optional<NamedMaterial> loaded_floor(const House& house, std::size_t index, std::span<const NamedMaterial> materials) {
  const Floor& floor = house.floors[index];
  if (floor.load == 0.0) return std::nullopt;
  const double added = floor_load_density(floor, indexed_key("house.floor", index, "load"));
  const std::int32_t bare = find_material(materials, house.wood.material, "house.wood.material");
  NamedMaterial loaded{floor_name(house, index), nth(materials, bare).value, bare};
  loaded.value.density += added;
  return loaded;
}

}  // namespace

std::vector<NamedMaterial> loaded_materials(const House& house, std::span<const NamedMaterial> materials) {
  std::vector<NamedMaterial> all;
  if (auto roof = surcharged_roof(house, materials)) all.push_back(*std::move(roof));
  for (std::size_t i = 0; i < house.floors.size(); ++i) {
    if (auto floor = loaded_floor(house, i, materials)) all.push_back(*std::move(floor));
  }
  return all;
}

Vec3 in_case(const House& house, const HousePlan& plan, int i, int j, Vec3 v) noexcept {
  return turned(v, plan.quarter_turns) + Vec3{house.origin[0] + i * house.spacing[0], house.origin[1] + j * house.spacing[1], 0.0};
}

HouseBox in_house(const HousePlan& plan, const WallPlan& wall, Interval along, Interval depth, Interval height) noexcept {
  const auto from_far_side = [&](Tick outer) { return Interval{outer - depth.high, outer - depth.low}; };
  if (!wall.outer()) {
    const Interval inside{wall.at + depth.low, wall.at + depth.high};
    return wall.along_x ? HouseBox{along, inside, height} : HouseBox{inside, along, height};
  }
  switch (wall.side) {
    case Side::front:
      return {along, depth, height};
    case Side::right:
      return {from_far_side(plan.outer[0]), along, height};
    case Side::rear:
      return {along, from_far_side(plan.outer[1]), height};
    case Side::left:
      break;
  }
  return {depth, along, height};
}

double segment_size_of(Tick a, Tick b, Tick c) noexcept { return metres(std::min({a, b, c})) / 4.0; }

Block box_block(const HouseBox& box, const Block& prototype) {
  Block block = prototype;
  block.shape = geometry::make_box({metres(box.x.low), metres(box.y.low), metres(box.z.low)},
                                   {metres(box.x.high), metres(box.y.high), metres(box.z.high)});
  return block;
}

bool has_timber(const House& house) noexcept {
  return is_of_timber(house.roof) || house.reinforcement || !house.floors.empty() ||
         std::any_of(house.openings.begin(), house.openings.end(), [](const Opening& o) { return o.lintel.has_value(); });
}

namespace {

/// Finds the materials of all parts.
void find_materials(const House& house, std::span<const NamedMaterial> materials, HouseParts& parts, Faults& faults) {
  const auto find = [&](std::int32_t& found, const std::string& name, const std::string& key) {
    faults.attempt([&] { found = find_material(materials, name, key); });
  };
  find(parts.masonry, house.material, "house.material");
  parts.through = parts.masonry;
  if (house.leaves && house.leaves->through && house.leaves->through->material)
    find(parts.through, *house.leaves->through->material, "house.leaves.through.material");
  for (std::size_t i = 0; i < house.openings.size(); ++i) {
    parts.arches.push_back(parts.masonry);
    const std::optional<Arch>& arch = house.openings[i].arch;
    if (arch && arch->material) find(parts.arches.back(), *arch->material, indexed_key("house.opening", i, "arch.material"));
  }
  if (has_timber(house)) find(parts.timber, house.wood.material, "house.wood.material");
  if (faults.any()) return;
  parts.roof = roof_material(house, materials, parts);
  for (std::size_t i = 0; i < house.floors.size(); ++i) parts.floors.push_back(floor_material(house, i, materials, parts));
}

void build_roof(const House& house, const HousePlan& plan, HouseParts& parts) {
  switch (house.roof.kind) {
    case RoofKind::flat:
      build_flat_roof(house, plan, parts);
      break;
    case RoofKind::vault:
      build_gables(house, plan, parts);
      build_vault(house, plan, parts);
      break;
    case RoofKind::gables:
      build_gables(house, plan, parts);
      break;
    case RoofKind::pitched:
      build_gables(house, plan, parts);
      build_pitched_roof(house, plan, parts);
      break;
    case RoofKind::none:
      break;
  }
}

}  // namespace

std::vector<Block> build_house(const House& house, std::span<const NamedMaterial> materials) {
  const HousePlan plan = plan_as_far_as_possible(house);
  Faults faults = plan.faults;
  HouseParts parts;
  find_materials(house, materials, parts, faults);
  if (!faults.any()) {
    build_walls(house, plan, parts);
    build_floors(house, plan, parts);
  }
  // Roof and reinforcement tell their faults beside those of the walls.
  if (house.reinforcement) faults.attempt([&] { build_reinforcement(house, plan, parts); });
  faults.attempt([&] { build_roof(house, plan, parts); });
  faults.raise();
  return placed_copies(house, plan, parts);
}

}  // namespace voussoir::cases
