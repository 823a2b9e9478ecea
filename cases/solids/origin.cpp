// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/solids/origin.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "cases/case.h"
#include "cases/names.h"

namespace voussoir::cases {
namespace {

constexpr double kNear = 100.0;  // m: nearer than this, single precision has 4 micrometres, and coordinates stay those of the file
constexpr std::size_t x = 0, y = 1, z = 2;

/// Calls use(coordinate, axis, key) for all coordinates that a block is made of.
template <class Spec, class Use>
void each_of_block(Spec& block, const std::string& key, Use use) {
  const auto point = [&](auto& v, const char* field) { use(v.x, x, key + field), use(v.y, y, key + field), use(v.z, z, key + field); };
  if (block.box) {
    for (auto& corner : *block.box) point(corner, "box");
  }
  for (auto& v : block.vertices) point(v, "vertices");
  for (auto& corner : block.polygon) use(corner[0], y, key + "polygon"), use(corner[1], z, key + "polygon");
  if (block.extrude) {
    for (auto& end : *block.extrude) use(end, x, key + "extrude");
  }
}

/// The same of all that the model is made of, stones that have been read included.
template <class C, class Use>
void each_of_model(C& c, Use use) {
  if (c.house) use(c.house->origin[0], x, "house.origin"), use(c.house->origin[1], y, "house.origin");
  if (c.base) use(c.base->z, z, "base.z");
  for (std::size_t i = 0; i < c.walls.size(); ++i) {
    for (auto& p : c.walls[i].points) use(p[0], x, indexed_key("wall", i, "points")), use(p[1], y, indexed_key("wall", i, "points"));
  }
  const auto plan = [&](auto& list, const char* name) {
    for (std::size_t i = 0; i < list.size(); ++i) {
      const std::string key = indexed_key(name, i, "corners");
      for (auto& p : list[i].corners) use(p[0], x, key), use(p[1], y, key);
    }
  };
  plan(c.floors, "floor"), plan(c.roofs, "roof"), plan(c.vaults, "vault");
  for (std::size_t i = 0; i < c.blocks.size(); ++i) each_of_block(c.blocks[i], indexed_key("block", i, "") + ".", use);
  for (std::size_t t = 0; t < c.stones.size(); ++t) {
    const std::string key = indexed_key("stones", t, "file");
    for (auto& stone : c.stones[t].stones) {
      for (auto& piece : stone.pieces) {
        for (auto& v : piece.shape.vertices) use(v.x, x, key), use(v.y, y, key), use(v.z, z, key);
      }
    }
  }
}

template <class Use>
void each_of_point(Vec3& v, Use use) {
  use(v.x, x), use(v.y, y), use(v.z, z);
}

/// Calls use(coordinate, axis) for all coordinates of a case that are places in the file's axes. Those of [[stones]] that move the stones
/// of a file act before.
template <class Use>
void each_coordinate(Case& c, Use use) {
  each_of_model(c, [&](double& v, std::size_t axis, const std::string&) { use(v, axis); });
  for (BlockSpec& b : c.blocks) {
    if (b.rotate) each_of_point(b.rotate->about, use);
    if (b.motion && b.motion->about) each_of_point(*b.motion->about, use);
  }
  for (StonesSpec& s : c.stones) {
    use(s.supports.level, z);
    if (s.motion && s.motion->about) each_of_point(*s.motion->about, use);
  }
  for (Load& load : c.loads) {
    if (load.at) each_of_point(*load.at, use);
  }
  for (Tie& tie : c.ties) each_of_point(tie.from, use), each_of_point(tie.to, use);
  for (HistoryPoint& h : c.output.history) each_of_point(h.point, use);
  for (Cut& cut : c.output.cuts) {
    each_of_point(cut.point, use);
    if (cut.box) each_of_point((*cut.box)[0], use), each_of_point((*cut.box)[1], use);
  }
  if (c.analysis.control) each_of_point(*c.analysis.control, use);
  if (!c.base) return;
  for (BasePart& part : c.base->parts) {
    if (part.x) use((*part.x)[0], x), use((*part.x)[1], x);
    if (part.y) use((*part.y)[0], y), use((*part.y)[1], y);
    if (part.motion && part.motion->about) each_of_point(*part.motion->about, use);
  }
}

void shift(Case& c, Vec3 by) {
  const std::array<double, 3> to{by.x, by.y, by.z};
  each_coordinate(c, [&](double& v, std::size_t axis) { v -= to[axis]; });
}

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();

  void add(double v) { low = std::min(low, v), high = std::max(high, v); }
};
using Ranges = std::array<Range, 3>;

void add(Ranges& ranges, Vec3 v) { ranges[x].add(v.x), ranges[y].add(v.y), ranges[z].add(v.z); }

/// Adds the corners of the box around a block, turned as the block is. Round-off here does not matter: the origin is a whole number of
/// metres.
void add_turned(const BlockSpec& block, Ranges& ranges) {
  Ranges own;
  each_of_block(block, "", [&](double v, std::size_t axis, const std::string&) { own[axis].add(v); });
  const bool turns = block.rotate && norm(block.rotate->axis) > 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const auto end = [&](std::size_t axis) { return (corner >> axis & 1) != 0 ? own[axis].high : own[axis].low; };
    const geometry::Polyhedron at{{{end(x), end(y), end(z)}}, {}};
    const Rotation r = turns ? *block.rotate : Rotation{};
    add(ranges, turns ? geometry::rotated(at, r.axis, r.angle * std::numbers::pi / 180.0, r.about).vertices[0] : at.vertices[0]);
  }
}

void add_house(const Case& c, Ranges& ranges) {
  const House& house = *c.house;
  const double foot = c.base ? c.base->z : 0.0;
  for (const int last : {0, 1}) {
    add(ranges, {house.origin[0] + last * (house.copies[0] - 1) * house.spacing[0],
                 house.origin[1] + last * (house.copies[1] - 1) * house.spacing[1], foot});
  }
}

double origin_of(const Range& r) {
  if (!(r.low <= r.high)) return 0.0;
  const double away = std::max({r.low, -r.high, 0.0});  // from zero to the model
  return away < std::max(kNear, r.high - r.low) ? 0.0 : std::floor(r.low + 0.5);
}

}  // namespace

void check_reach(const Case& c) {
  each_of_model(c, [](double v, std::size_t axis, const std::string& key) {
    if (std::abs(v) <= kFarthest) return;
    throw InputError(key, std::string(1, "xyz"[axis]) + " = " + text(v) + " m is too far from the origin of the axes; allowed: -" +
                              text(kFarthest) + " to " + text(kFarthest) + " m");
  });
}

Vec3 suitable_origin(const Case& c, std::span<const geometry::Box3> stones) {
  Ranges ranges;
  if (c.house) add_house(c, ranges);
  if (c.base) ranges[z].add(c.base->z);
  for (const WallSpec& wall : c.walls) {
    for (const auto& p : wall.points) ranges[x].add(p[0]), ranges[y].add(p[1]);
    ranges[z].add(c.base ? c.base->z : 0.0);
  }
  for (const BlockSpec& block : c.blocks) add_turned(block, ranges);
  for (const StonesSpec& spec : c.stones) {
    for (const Stone& stone : spec.stones) {
      for (const StonePiece& piece : stone.pieces) {
        for (const Vec3& v : piece.shape.vertices) add(ranges, v);
      }
    }
  }
  for (const geometry::Box3& box : stones) add(ranges, box.low), add(ranges, box.high);
  return {origin_of(ranges[x]), origin_of(ranges[y]), origin_of(ranges[z])};
}

void move_origin(Case& c, Vec3 origin) {
  shift(c, origin);
  c.origin = origin;
}

std::string origin_note(Vec3 origin, const std::string& message) {
  const bool says_place = message.find(" at (") != std::string::npos || message.find("about (") != std::string::npos ||
                          message.find("from (") != std::string::npos || message.find("at z = ") != std::string::npos;
  if (origin == Vec3{} || !says_place) return "";
  return "; places count from the model's origin (" + text(origin.x) + ", " + text(origin.y) + ", " + text(origin.z) + ") m";
}

Case as_in_file(Case c) {
  const Vec3 origin = c.origin.value_or(Vec3{});
  if (!(origin == Vec3{})) shift(c, -origin);
  c.origin.reset();
  return c;
}

}  // namespace voussoir::cases
