// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/measures/building.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "io/document/case_tree.h"
#include "io/files/errors.h"

namespace voussoir::io {
namespace {

constexpr double kPiece = 1.0;       // m along a wall's top, over which its displacement is averaged
constexpr double kSameLevel = 1e-3;  // m

/// /model/element as far as it matters here.
struct Elements {
  std::vector<std::string> tag;
  std::vector<std::int32_t> house;
  std::vector<std::uint8_t> fixed;
};

/// A number of the case, 0 if it is not given.
double case_number(const Hdf5File& run, std::string_view table, std::string_view key) {
  try {
    const Node document = parse_document(run.attribute_text("/case", "toml"));
    const Entry* entry = find_entry(*document.as<Node::Table>(), table);
    const auto* inside = entry == nullptr ? nullptr : entry->node.as<Node::Table>();
    const Entry* number = inside == nullptr ? nullptr : find_entry(*inside, key);
    if (number == nullptr) return 0.0;
    if (const auto* value = number->node.as<double>()) return *value;
    if (const auto* value = number->node.as<std::int64_t>()) return static_cast<double>(*value);
    throw FileError(run.path(), "/case: " + std::string(table) + "." + std::string(key) + " is no number");
  } catch (const SyntaxError& e) {
    throw FileError(run.path(), std::string("/case: ") + e.what());
  }
}

/// \throw FileError
bool has_table(const Hdf5File& run, std::string_view table) {
  try {
    return find_entry(*parse_document(run.attribute_text("/case", "toml")).as<Node::Table>(), table) != nullptr;
  } catch (const SyntaxError& e) {
    throw FileError(run.path(), std::string("/case: ") + e.what());
  }
}

std::vector<Box> boxes_of(const Hdf5File& run, std::size_t elements) {
  const auto first = run.read<std::int32_t>("/model/element/first_vertex");
  const auto vertex = run.read<double>("/model/vertex");
  if (first.size() != elements) throw FileError(run.path(), "/model/element does not fit together");
  std::vector<Box> boxes(elements, Box::empty());
  std::size_t e = 0;
  for (std::size_t v = 0; v < vertex.size() / 3; ++v) {
    while (e + 1 < elements && static_cast<std::int64_t>(v) >= first[e + 1]) ++e;
    const std::array at{vertex[3 * v], vertex[3 * v + 1], vertex[3 * v + 2]};
    boxes[e].include({at, at});
  }
  return boxes;
}

/// "front" of "front wall" and "front gable"; empty for what is neither.
std::string side_of(const std::string& tag, const std::string& what) {
  const std::size_t end = tag.size() > what.size() ? tag.size() - what.size() : 0;
  return end > 0 && tag.compare(end, what.size(), what) == 0 ? tag.substr(0, end) : "";
}

/// What each element is in a house. Results of early versions say it by tags alone, and there what is neither wall, lintel nor roof is a
/// block.
std::vector<cases::PartKind> kinds_of(const Hdf5File& run, const std::vector<std::string>& tags) {
  using enum cases::PartKind;
  std::vector<cases::PartKind> kinds;
  if (run.exists("/model/element/kind")) {
    for (const std::uint8_t k : run.read<std::uint8_t>("/model/element/kind")) kinds.push_back(static_cast<cases::PartKind>(k));
    return kinds;
  }
  for (const std::string& tag : tags) {
    const bool is_brick = !side_of(tag, " wall").empty() || !side_of(tag, " gable").empty();
    kinds.push_back(is_brick                         ? brick
                    : tag.starts_with("lintel ")     ? lintel
                    : tag.starts_with("roof beam ")  ? beam
                    : tag.starts_with("vault ring ") ? voussoir
                                                     : block);
  }
  return kinds;
}

/// House, place round it, side.
using WallKey = std::tuple<std::int32_t, std::ptrdiff_t, std::string>;
WallKey wall_key(std::int32_t house, const std::string& side) {
  constexpr std::array<std::string_view, 4> kRound{"front", "right", "rear", "left"};
  return {house, std::ranges::find(kRound, side) - kRound.begin(), side};
}

/// Which way is out of the house at a wall, by its place round the house that has been turned.
void orient(Wall& wall, std::ptrdiff_t place, int quarter_turns) {
  const std::ptrdiff_t quarter = (place + 3 + quarter_turns) % 4;  // 0: +x, where the right wall of a house not turned is; then +y, −x, −y
  wall.across = static_cast<std::size_t>(quarter % 2);
  wall.outward = quarter < 2 ? 1.0 : -1.0;
}

/// Walls with their boxes, house by house and round each; says of each brick which wall it is in.
void find_walls(const Elements& elements, int quarter_turns, Building& b) {
  std::set<std::int32_t> houses(elements.house.begin(), elements.house.end());
  houses.erase(-1);  // blocks of their own
  const bool several = houses.size() > 1;
  std::map<WallKey, std::int32_t> numbers;
  for (std::size_t e = 0; e < elements.tag.size(); ++e) {
    const std::string side = side_of(elements.tag[e], " wall");
    if (elements.house[e] >= 0 && !side.empty()) numbers.emplace(wall_key(elements.house[e], side), 0);
  }
  for (auto& [key, number] : numbers) {
    const auto& [house, place, side] = key;
    number = static_cast<std::int32_t>(b.walls.size());
    Wall& wall = b.walls.emplace_back();
    wall.name = side + " wall" + (several ? " of house " + std::to_string(house) : "");
    wall.house = house;
    wall.box = Box::empty();
    orient(wall, place, quarter_turns);
  }
  for (std::size_t e = 0; e < elements.tag.size(); ++e) {
    if (const auto wall = numbers.find(wall_key(elements.house[e], side_of(elements.tag[e], " wall"))); wall != numbers.end()) {
      b.wall[e] = wall->second;
      b.walls[static_cast<std::size_t>(wall->second)].box.include(b.box[e]);
    }
    if (const auto wall = numbers.find(wall_key(elements.house[e], side_of(elements.tag[e], " gable"))); wall != numbers.end()) {
      b.wall[e] = wall->second;
    }
  }
}

/// Lintels belong to the wall in whose box they lie.
void find_lintels(const Elements& elements, Building& b) {
  for (std::size_t e = 0; e < b.kind.size(); ++e) {
    if (b.kind[e] != cases::PartKind::lintel) continue;
    for (std::size_t w = 0; w < b.walls.size(); ++w) {
      const Box& box = b.walls[w].box;
      const auto inside = [&](std::size_t axis) { return b.box[e].centre(axis) > box.low[axis] && b.box[e].centre(axis) < box.high[axis]; };
      if (b.walls[w].house == elements.house[e] && inside(0) && inside(1)) b.wall[e] = static_cast<std::int32_t>(w);
    }
  }
}

void find_courses(const Elements& elements, Building& b) {
  for (Wall& w : b.walls) w.top.resize(static_cast<std::size_t>(std::max(1L, std::lround(w.length() / kPiece))));
  for (std::size_t e = 0; e < b.wall.size(); ++e) {
    if (b.wall[e] < 0 || !side_of(elements.tag[e], " gable").empty()) continue;
    Wall& w = b.walls[static_cast<std::size_t>(b.wall[e])];
    if (b.box[e].low[2] < w.box.low[2] + kSameLevel) w.foot.push_back(e);
    if (b.box[e].high[2] < w.box.high[2] - kSameLevel) continue;
    const std::size_t along = 1 - w.across;
    const double place = (b.box[e].centre(along) - w.box.low[along]) / w.length() * static_cast<double>(w.top.size());
    w.top[std::min(w.top.size() - 1, static_cast<std::size_t>(place))].push_back(e);
  }
}

/// The rectangle about the walls of a house less the walls themselves.
Room room_of(const std::vector<Wall>& walls, std::int32_t house, const Box& outer) {
  Room room{{outer.low[0], outer.low[1]}, {outer.high[0], outer.high[1]}, outer.low[2], outer.high[2]};
  for (const Wall& w : walls) {
    if (w.house != house) continue;
    double& low = room.low[w.across];
    double& high = room.high[w.across];
    w.outward < 0 ? low = std::max(low, w.box.high[w.across]) : high = std::min(high, w.box.low[w.across]);
  }
  return room;
}

void find_rooms(Building& b) {
  std::map<std::int32_t, Box> houses;
  for (const Wall& w : b.walls) houses.emplace(w.house, Box::empty()).first->second.include(w.box);
  for (const auto& [house, outer] : houses) {
    const Room room = room_of(b.walls, house, outer);
    if (room.high[0] > room.low[0] && room.high[1] > room.low[1]) b.rooms.push_back(room);
  }
}

}  // namespace

Box Box::empty() noexcept {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  return {{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
}

void Box::include(const Box& other) noexcept {
  for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], other.low[k]), high[k] = std::max(high[k], other.high[k]);
}

std::string part_of(const std::string& tag) {
  const std::size_t end = tag.find_last_not_of("0123456789 ");
  return end == std::string::npos ? tag : tag.substr(0, end + 1);
}

Building building_of(const Hdf5File& run) {
  Building b;
  b.base = case_number(run, "base", "z");
  b.has_base = has_table(run, "base");
  b.mass = run.read<double>("/model/element/mass");
  const std::size_t n = b.mass.size();
  const Elements elements{run.read_strings("/model/element/tag"), run.read<std::int32_t>("/model/element/house"),
                          run.read<std::uint8_t>("/model/element/fixed")};
  b.kind = kinds_of(run, elements.tag);
  if (elements.tag.size() != n || elements.house.size() != n || elements.fixed.size() != n || b.kind.size() != n)
    throw FileError(run.path(), "/model/element does not fit together");
  for (std::size_t e = 0; e < n; ++e) {
    if (elements.fixed[e] != 0) b.mass[e] = 0.0;  // no part of what may fall, as the solver has it
  }
  b.wall.assign(n, -1);
  b.box = boxes_of(run, n);
  find_walls(elements, static_cast<int>(std::lround(case_number(run, "house", "turn") / 90.0)), b);
  find_lintels(elements, b);
  find_rooms(b);
  find_courses(elements, b);
  const bool any_house = std::ranges::any_of(elements.house, [](std::int32_t h) { return h >= 0; });
  b.footprint = Box::empty();
  for (std::size_t e = 0; e < n; ++e)
    if (any_house ? elements.house[e] >= 0 : elements.fixed[e] == 0) b.footprint.include(b.box[e]);
  return b;
}

}  // namespace voussoir::io
