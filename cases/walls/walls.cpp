// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/walls/walls.h"

#include <algorithm>
#include <cmath>

#include "cases/house/house_parts.h"
#include "cases/house/house_thickness.h"
#include "cases/house/house_wall.h"
#include "cases/house/walls/arches.h"
#include "cases/house/walls/brick_cells.h"
#include "cases/names.h"
#include "cases/walls/spans/wall_floors.h"
#include "cases/walls/spans/wall_roofs.h"
#include "cases/walls/spans/wall_vaults.h"
#include "cases/walls/wall_layout.h"
#include "cases/walls/wall_plan.h"
#include "cases/walls/wall_storeys.h"

namespace voussoir::cases {
namespace {

constexpr double kLost = 1e-4;  // share of volume: less is not told

std::string loaded_name(const WallSpec& wall) { return wall.material + " under " + text(wall.load) + " kg/m on " + wall.name; }

const Courses& courses_of(const WallsPlan& plan, std::size_t wall) { return plan.courses[plan.group[wall]]; }

/// Materials of a wall, indices into Model::materials.
struct WallMaterials {
  std::int32_t bricks = 0, top = 0;
  std::vector<std::int32_t> lintels, arches;  // by opening; of those without one that of the wall
};

/// \param faults  keeps names that are not known
WallMaterials materials_of(const WallSpec& wall, std::size_t index, std::span<const NamedMaterial> materials, Faults& faults) {
  WallMaterials found;
  faults.attempt([&] { found.bricks = find_material(materials, wall.material, wall_key(index, "material")); });
  for (std::size_t i = 0; i < wall.openings.size(); ++i) {
    const auto find = [&](std::vector<std::int32_t>& of, const auto& part, const char* field) {
      of.push_back(found.bricks);
      if (!part || !part->material) return;
      faults.attempt([&] { of.back() = find_material(materials, *part->material, indexed_key(wall_key(index, "opening"), i, field)); });
    };
    find(found.lintels, wall.openings[i].lintel, "lintel.material");
    find(found.arches, wall.openings[i].arch, "arch.material");
  }
  return found;
}

/// Cells of a brick over a quadrangle in plan, along the wall, across it, upright.
CellCounts cells_of(const WallSpec& wall, const WallsPlan& plan, const Leg& leg, const PlanBrick& brick) {
  const auto& [a, b, c, d] = brick.corners;
  const double along = 0.5 * (norm(b - a) + norm(c - d)), area = 0.5 * norm(cross(c - a, d - b)), height = metres(brick.height.length());
  const HousePlan& bricks = plan.bricks[leg.wall];
  const Tick thickness = ticks(wall.thickness), widths = wall.bond == WallBond::through ? 1 : widths_through(bricks, thickness);
  const double width = metres(thickness) / static_cast<double>(widths);
  return cells_of_piece(*wall.cells, {brick.length, width, height}, {along, area / along, height}, brick.whole);
}

void add_bricks(const WallSpec& wall, const WallsPlan& plan, const Leg& leg, std::size_t course, const WallMaterials& materials,
                std::vector<Block>& blocks) {
  const Interval height = courses_of(plan, leg.wall)[course];
  const HousePlan& bricks = plan.bricks[leg.wall];
  Block block;
  block.kind = PartKind::walling;
  block.tag = part_tag(plan, leg, height);
  block.wall = static_cast<std::int32_t>(leg.wall);
  block.material = height.high == leg.eaves ? materials.top : materials.bricks;
  block.segment_size = segment_size_of(bricks.brick_length, bricks.brick_width, bricks.brick_height);
  for (const PlanBrick& b : lay_wall_course(wall, plan, leg, static_cast<int>(course))) {
    block.shape = b.shape ? *b.shape : upright(b.corners, b.height);
    block.whole = b.whole;
    block.cells = wall.cells && !b.shape ? cells_of(wall, plan, leg, b) : CellCounts{1, 1, 1};
    blocks.push_back(block);
  }
}

void add_lintels(const WallSpec& wall, const Leg& leg, const WallMaterials& materials, std::vector<Block>& blocks) {
  for (const LegHole& h : leg.holes) {
    if (h.kind != HoleKind::lintel) continue;
    Block block;
    block.kind = PartKind::lintel;
    block.tag = leg.tag.substr(0, leg.tag.rfind(' ')) + " lintel";
    block.wall = static_cast<std::int32_t>(leg.wall);
    block.material = materials.lintels[h.opening];
    block.segment_size = segment_size_of(ticks(h.high - h.low), ticks(wall.thickness), h.height.length());
    block.shape =
        upright({leg.at(h.low, -leg.half), leg.at(h.high, -leg.half), leg.at(h.high, leg.half), leg.at(h.low, leg.half)}, h.height);
    blocks.push_back(block);
  }
}

void add_arches(const WallSpec& wall, const WallsPlan& plan, const Leg& leg, const WallMaterials& materials, std::vector<Block>& blocks) {
  const HousePlan& bricks = plan.bricks[leg.wall];
  const Tick thickness = ticks(wall.thickness), rows = rows_through(bricks, thickness);
  for (const LegHole& h : leg.holes) {
    if (h.kind != HoleKind::arch) continue;
    const Arch& arch = *wall.openings[h.opening].arch;
    const Interval span{ticks(h.low + arch.springer), ticks(h.high - arch.springer)};
    Block block;
    block.kind = PartKind::arch_stone;
    block.tag = part_tag(plan, leg, h.height);
    block.wall = static_cast<std::int32_t>(leg.wall);
    block.material = materials.arches[h.opening];
    block.segment_size = segment_size_of(bricks.brick_length, bricks.brick_width, bricks.brick_height);
    for (const geometry::Polygon& section : arch_sections(arch, bricks, span, h.height, wall_key(leg.wall, "opening"))) {
      for (Tick row = 0; row < rows; ++row) {
        block.shape = across(leg, section, metres(row * thickness / rows) - leg.half, metres((row + 1) * thickness / rows) - leg.half);
        blocks.push_back(block);
      }
    }
  }
}

}  // namespace

void check_wall_materials(const std::vector<WallSpec>& walls, const WallSpans& spans, std::span<const NamedMaterial> materials) {
  Faults faults;
  for (std::size_t i = 0; i < walls.size(); ++i) materials_of(walls[i], i, materials, faults);
  faults.attempt([&] { loaded_floor_materials(spans.floors, materials); });
  for (std::size_t i = 0; i < spans.roofs.size(); ++i)
    faults.attempt([&] { find_material(materials, spans.roofs[i].material, indexed_key("roof", i, "material")); });
  for (std::size_t i = 0; i < spans.vaults.size(); ++i)
    faults.attempt([&] { find_material(materials, spans.vaults[i].material, indexed_key("vault", i, "material")); });
  faults.raise();
}

std::vector<Block> blocks_of_walls(const std::vector<WallSpec>& walls, const WallSpans& spans, const WallsPlan& plan,
                                   std::span<const NamedMaterial> materials) {
  Faults faults;
  std::vector<WallMaterials> of_wall;
  for (std::size_t i = 0; i < walls.size(); ++i) of_wall.push_back(materials_of(walls[i], i, materials, faults));
  faults.raise();
  for (std::size_t i = 0; i < walls.size(); ++i) {
    of_wall[i].top = walls[i].load > 0.0 ? find_material(materials, loaded_name(walls[i]), wall_key(i, "load")) : of_wall[i].bricks;
  }
  std::vector<Block> blocks;
  for (const Leg& leg : plan.legs) {
    const Courses& courses = courses_of(plan, leg.wall);
    for (std::size_t c = 0; c < courses.size(); ++c) {
      if (leg.height.overlaps(courses[c])) add_bricks(walls[leg.wall], plan, leg, c, of_wall[leg.wall], blocks);
    }
    add_lintels(walls[leg.wall], leg, of_wall[leg.wall], blocks);
    add_arches(walls[leg.wall], plan, leg, of_wall[leg.wall], blocks);
  }
  std::int32_t members = 0;
  add_floor_beams(plan, spans.floors, materials, members, blocks);
  add_rafters(walls, plan, spans.roofs, materials, members, blocks);
  add_vaults(walls, plan, spans.vaults, materials, blocks);
  return blocks;
}

std::vector<NamedMaterial> loaded_wall_materials(const std::vector<WallSpec>& walls, const WallSpans& spans, const WallsPlan& plan,
                                                 std::span<const NamedMaterial> materials) {
  std::vector<NamedMaterial> all = loaded_floor_materials(spans.floors, materials);
  for (NamedMaterial& m : loaded_roof_materials(walls, plan, spans.roofs, materials)) all.push_back(std::move(m));
  for (NamedMaterial& m : loaded_vault_materials(walls, plan, spans.vaults, materials)) all.push_back(std::move(m));
  for (std::size_t i = 0; i < walls.size(); ++i) {
    if (walls[i].load == 0.0) continue;
    const std::int32_t bare = find_material(materials, walls[i].material, wall_key(i, "material"));
    const Tick top = ticks(walls[i].base + walls[i].height);
    const auto course = std::ranges::find(courses_of(plan, i), top, &Interval::high);
    NamedMaterial loaded{loaded_name(walls[i]), materials[static_cast<std::size_t>(bare)].value, bare};
    loaded.value.density += walls[i].load / (walls[i].thickness * metres(course->length()));
    all.push_back(std::move(loaded));
  }
  return all;
}

std::vector<AdaptedBricks> adapted_bricks(const std::vector<WallSpec>& walls, const WallSpans& spans) {
  const WallsPlan plan = plan_walls(walls, spans);
  std::vector<AdaptedBricks> all;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const auto& [length, width, height] = walls[i].brick;
    AdaptedBricks a{walls[i].name, length, length, width, height, height};
    const Tick thickness = ticks(walls[i].thickness);
    if (walls[i].bond != WallBond::through) a.width = metres(thickness) / static_cast<double>(widths_through(plan.bricks[i], thickness));
    for (const Leg& leg : plan.legs) {
      if (leg.wall != i) continue;
      const auto [least, most] = brick_stretch(walls[i], plan, leg);
      a.shortest = std::min(a.shortest, least * length), a.longest = std::max(a.longest, most * length);
      a.lost = std::max(a.lost, lost_in_bends(walls[i], plan, leg));
      for (const Interval course : courses_of(plan, i)) {
        if (!leg.height.overlaps(course)) continue;
        a.lowest = std::min(a.lowest, metres(course.length())), a.highest = std::max(a.highest, metres(course.length()));
      }
    }
    const double most =
        std::max({length - a.shortest, a.longest - length, std::abs(a.width - width), height - a.lowest, a.highest - height});
    if (most > kPlanTolerance || a.lost > kLost) all.push_back(a);
  }
  return all;
}

std::vector<InputError> wall_overhangs(const std::vector<WallSpec>& walls, const WallSpans& spans) {
  std::vector<InputError> found;
  if (std::ranges::all_of(walls, [](const WallSpec& w) { return w.base == 0.0; })) return found;
  const WallsPlan plan = plan_walls(walls, spans);
  for (const Leg& leg : plan.legs) {
    for (const bool left : {false, true}) {
      const double by = overhang(plan, leg, left);
      if (by < 0.1 * walls[leg.wall].brick[1]) continue;
      found.emplace_back(wall_key(leg.wall, "thickness"),
                         "the " + leg.tag + " reaches " + text(std::round(by * 1e4) * 1e-4) +
                             " m beyond the wall on which it stands, on its " + (left ? "left" : "right") +
                             "; less than a tenth of a brick's width may overhang: move the upper wall, or thicken the lower one");
    }
  }
  return found;
}

std::vector<InputError> wall_heads_without_lintel(const std::vector<WallSpec>& walls) {
  std::vector<InputError> found;
  for (std::size_t w = 0; w < walls.size(); ++w) {
    for (std::size_t i = 0; i < walls[w].openings.size(); ++i) {
      const WallOpening& o = walls[w].openings[i];
      if (o.lintel || o.arch || 2.0 * o.width <= walls[w].brick[0] || ticks(o.sill + o.height) >= ticks(walls[w].height)) continue;
      found.emplace_back(indexed_key(wall_key(w, "opening"), i, ""), "the opening in the wall " + quoted(walls[w].name) + ", " +
                                                                         text(o.width) +
                                                                         " m wide, has masonry above it and nothing that carries it; give "
                                                                         "it a lintel or an arch");
    }
  }
  return found;
}

}  // namespace voussoir::cases
