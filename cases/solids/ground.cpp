// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/solids/ground.h"

#include <algorithm>
#include <cmath>

#include "cases/blocks.h"
#include "cases/case.h"
#include "cases/names.h"
#include "cases/solids/origin.h"
#include "geometry/nth.h"

namespace voussoir::cases {
namespace {

constexpr double kStiffer = 1e3;    // ratio to the stiffest material: makes ground rigid for anything that falls on it
constexpr double kRoundOff = 1e-9;  // m

std::string key_of(std::size_t part, const char* field = "") { return indexed_key("base.part", part, field); }

/// A rectangle in plan, m.
struct Rectangle {
  std::array<double, 2> x, y;
};

std::string from_to(std::array<double, 2> i) { return "[" + text(i[0]) + ", " + text(i[1]) + "] m"; }

int quarter_turns(const House& house) { return ((static_cast<int>(std::lround(house.turn / 90.0)) % 4) + 4) % 4; }

/// Transforms a rectangle from axes of the house to those of the case (1), or back (-1).
Rectangle turned(const House& house, Rectangle r, int way) {
  const auto shift = [&](double sign) {
    for (double& v : r.x) v += sign * house.origin[0];
    for (double& v : r.y) v += sign * house.origin[1];
  };
  if (way < 0) shift(-1.0);
  const int turns = way > 0 ? quarter_turns(house) : (4 - quarter_turns(house)) % 4;
  for (int i = 0; i < turns; ++i) r = {{-r.y[1], -r.y[0]}, r.x};
  if (way > 0) shift(1.0);
  return r;
}

/// A wall of the first storey in plan, axes of the house: ranges across and along, and whether it runs along x.
struct Strip {
  std::array<double, 2> across;
  double length = 0.0;
  bool along_x = false;
};

Strip strip_of(const House& house, std::size_t index, const std::string& wall) {
  const double b = house.bearing_wall, n = house.nonbearing_wall;
  const double x = house.inner_size[0] + 2 * n, y = house.inner_size[1] + 2 * b;
  if (wall == "front") return {{0.0, b}, x, true};
  if (wall == "rear") return {{y - b, y}, x, true};
  if (wall == "left") return {{0.0, n}, y, false};
  if (wall == "right") return {{x - n, x}, y, false};
  std::string allowed = "front, rear, left, right";
  std::vector<std::string> names{"front", "rear", "left", "right"};
  for (const InnerWall& inner : house.inner_walls) {
    const bool along_x = inner.along == PlanAxis::x;
    if (inner.name == wall) return {{inner.at, inner.at + inner.thickness}, along_x ? x : y, along_x};
    allowed += ", " + inner.name;
    names.push_back(inner.name);
  }
  throw InputError(key_of(index, "wall"), quoted(wall) + " is no wall of the house; " + did_you_mean(wall, names) + "allowed: " + allowed);
}

Rectangle under_wall(const House& house, std::size_t index, const BasePart& part) {
  const Strip s = strip_of(house, index, part.wall);
  const double from = part.from.value_or(0.0), to = part.to.value_or(s.length);
  if (!(to <= s.length + kRoundOff))
    throw InputError(key_of(index, "to"),
                     text(to) + " m is beyond the end of the " + part.wall + " wall; at most " + text(s.length) + " m");
  if (!(from >= 0.0 && from < to))
    throw InputError(key_of(index, "from"), text(from) + " m; allowed: 0 to below " + text(to) + " m, where the part ends");
  const std::array<double, 2> along{from, to};
  return s.along_x ? Rectangle{along, s.across} : Rectangle{s.across, along};
}

/// A rectangle in axes of the case as it stands in the case file.
Rectangle in_file(const Case& c, Rectangle r) {
  const Vec3 origin = c.origin.value_or(Vec3{});
  for (double& v : r.x) v += origin.x;
  for (double& v : r.y) v += origin.y;
  return r;
}

/// \param r  as it stands in the case file
void check_rectangle(std::size_t index, const Rectangle& r) {
  for (const auto& [name, side] : {std::pair{"x", r.x}, std::pair{"y", r.y}}) {
    if (!(std::abs(side[0]) <= kFarthest && std::abs(side[1]) <= kFarthest && side[0] < side[1]))
      throw InputError(key_of(index, name),
                       from_to(side) + " is no length; the first below the second, both within " + text(kFarthest) + " m");
  }
}

/// The rectangle of a part, in axes of the case.
Rectangle place_of(const Case& c, std::size_t index) {
  const BasePart& part = c.base->parts[index];
  const std::string key = key_of(index);
  const bool rectangle = part.x || part.y;
  if (rectangle == !part.wall.empty()) {
    throw InputError(key,
                     rectangle ? "lies in a rectangle and under a wall; give x and y, or wall" : "has no place; give x and y, or wall");
  }
  if (rectangle) {
    if (!part.x || !part.y) throw InputError(key_of(index, part.x ? "y" : "x"), "is missing; a rectangle needs both");
    if (part.from || part.to) throw InputError(key_of(index, part.from ? "from" : "to"), "goes with wall; x and y say where the part ends");
    check_rectangle(index, in_file(c, {*part.x, *part.y}));
    return {*part.x, *part.y};
  }
  if (!c.house) throw InputError(key_of(index, "wall"), quoted(part.wall) + ", but the case has no [house]; give x and y");
  return turned(*c.house, under_wall(*c.house, index, part), 1);
}

void check_apart(const Case& c, const std::vector<Rectangle>& all) {
  const auto overlap = [](std::array<double, 2> a, std::array<double, 2> b) {
    return std::min(a[1], b[1]) - std::max(a[0], b[0]) > kRoundOff;
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!overlap(all[i].x, all[j].x) || !overlap(all[i].y, all[j].y)) continue;
      const Rectangle a = in_file(c, all[i]), b = in_file(c, all[j]);
      throw InputError(key_of(i), "x " + from_to(a.x) + ", y " + from_to(a.y) + " overlaps " + key_of(j) + ", x " + from_to(b.x) + ", y " +
                                      from_to(b.y));
    }
  }
}

std::vector<Rectangle> places_of(const Case& c) {
  std::vector<Rectangle> all;
  for (std::size_t i = 0; i < c.base->parts.size(); ++i) {
    const BasePart& part = c.base->parts[i];
    if (!(part.level > 0.0 && part.level <= 1e4))
      throw InputError(key_of(i, "level"),
                       text(part.level) + " m is out of range; allowed: above 0, at most 10000 m; base.z is the lowest ground");
    if (part.motion) check_motion(*part.motion, key_of(i, "motion"));
    all.push_back(place_of(c, i));
  }
  check_apart(c, all);
  return all;
}

bool has_parts(const Case& c) { return c.base && !c.base->parts.empty(); }

}  // namespace

std::optional<Case> with_ground(const Case& c) {
  if (!has_parts(c) || !c.house || !c.house->ground.empty()) return std::nullopt;
  if (c.house->copies != std::array{1, 1}) throw InputError("house.copies", "does not go with base.part; allowed: [1, 1]");
  Case with = c;
  const std::vector<Rectangle> places = places_of(c);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Rectangle r = turned(*c.house, places[i], -1);
    with.house->ground.push_back({r.x, r.y, c.base->parts[i].level, c.blocks.empty() && c.stones.empty()});
  }
  return with;
}

void add_ground_material(Model& model) {
  NamedMaterial ground{"base", {.density = 1.0, .young = 0.0, .poisson = 0.0}, -1, true};
  for (const NamedMaterial& m : model.materials) {
    ground.value.density = std::max(ground.value.density, m.value.density);
    ground.value.young = std::max(ground.value.young, kStiffer * m.value.young);
  }
  model.materials.push_back(ground);
}

void add_ground(const Case& c, Model& model) {
  if (!has_parts(c)) return;
  const std::vector<Rectangle> places = places_of(c);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const BasePart& part = c.base->parts[i];
    const auto& [x, y] = places[i];
    Block block;
    block.name = block.tag = "ground " + std::to_string(i);
    block.material = static_cast<std::int32_t>(model.materials.size()) - 1;
    block.shape = geometry::make_box({x[0], y[0], c.base->z}, {x[1], y[1], c.base->z + part.level});
    block.segment_size = std::max({x[1] - x[0], y[1] - y[0], part.level});  // unused, since ground has no points
    block.fixed = true;
    block.ground = static_cast<std::int32_t>(i);
    if (part.motion) {
      block.support_motion = static_cast<std::int32_t>(model.support_motions.size());
      model.support_motions.push_back(support_history(*part.motion, key_of(i, "motion.file")));
    }
    model.blocks.push_back(std::move(block));
  }
}

const Block* beyond(const Model& model, const geometry::Joint& joint) noexcept {
  if (joint.element_b == geometry::kBase) return nullptr;
  const Block& other = nth(model.blocks, joint.element_b);
  return other.ground < 0 ? &other : nullptr;
}

}  // namespace voussoir::cases
