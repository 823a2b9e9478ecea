// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/building/building.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "cases/names.h"
#include "geometry/nth.h"
#include "io/input/document/case_tree.h"
#include "io/input/files/errors.h"
#include "io/output/replay/frame_reader.h"

namespace voussoir::io {
namespace {

constexpr double kPiece = 1.0;             // m, length of a piece of a wall's top, over which displacement is averaged
constexpr double kMostPieces = 1e5;        // of a wall: a damaged file may have any length
constexpr double kSameLevel = 1e-3;        // m
constexpr double kUpperThird = 1.0 / 3.0;  // of a gable's height: its uppermost course is a brick that may be loose
constexpr double kOnBorder = 1e-6;  // of a piece: a centre so near to its end counts in both that meet there, not in one by round-off

/// Required parts of /model/element.
struct Elements {
  std::vector<std::string> tag;
  std::vector<std::int32_t> house;
  std::vector<std::uint8_t> fixed;
};

/// A finite number of the case, 0 if not given. \throw FileError
double case_number(const Hdf5File& run, std::string_view table, std::string_view key) {
  try {
    const Node document = parse_document(run.attribute_text("/case", "toml"));
    const Entry* entry = find_entry(*document.as<Node::Table>(), table);
    const auto* inside = entry == nullptr ? nullptr : entry->node.as<Node::Table>();
    const Entry* number = inside == nullptr ? nullptr : find_entry(*inside, key);
    if (number == nullptr) return 0.0;
    if (const auto* value = number->node.as<double>(); value != nullptr && std::isfinite(*value)) return *value;
    if (const auto* value = number->node.as<std::int64_t>()) return static_cast<double>(*value);
    throw FileError(run.path(), "/case: " + std::string(table) + "." + std::string(key) + " is no finite number");
  } catch (const SyntaxError& e) {
    throw FileError(run.path(), std::string("/case: ") + e.what());
  }
}

/// Quarters by which the case turns its house. \throw FileError
int quarter_turns_of(const Hdf5File& run) {
  const double turn = case_number(run, "house", "turn");
  for (int quarters = 0; quarters < 4; ++quarters)
    if (turn == 90.0 * quarters) return quarters;
  throw FileError(run.path(), "/case: house.turn = " + cases::text(turn) + " degrees; allowed: 0, 90, 180, 270");
}

/// Whether the case has a table. \throw FileError
bool has_table(const Hdf5File& run, std::string_view table) {
  try {
    return find_entry(*parse_document(run.attribute_text("/case", "toml")).as<Node::Table>(), table) != nullptr;
  } catch (const SyntaxError& e) {
    throw FileError(run.path(), std::string("/case: ") + e.what());
  }
}

/// Parts of a brick's tag: "front wall", "left gable", "middle wall, storey 2"; "shed 1 walling", a side along no axis.
struct WallTag {
  std::string side;  // empty: not a brick of a wall
  bool gable = false, walling = false;
  int storey = 1;
  std::string storey_name;  // ", storey 2"; empty: the house has one storey
};

WallTag wall_tag(std::string tag) {
  WallTag found;
  const std::size_t storey = tag.rfind(", storey ");
  if (storey != std::string::npos) {
    found.storey_name = tag.substr(storey);
    found.storey = std::max(1, std::atoi(tag.c_str() + storey + std::string_view(", storey ").size()));
    tag.resize(storey);
  }
  for (const std::string_view what : {" wall", " gable", " walling"}) {
    if (tag.size() <= what.size() || !tag.ends_with(what)) continue;
    found.side = tag.substr(0, tag.size() - what.size());
    found.gable = what == " gable", found.walling = what == " walling";
  }
  return found;
}

/// The kind of each element. Early results have tags only; there an element that is neither wall, lintel nor roof is a block.
std::vector<cases::PartKind> kinds_of(const Hdf5File& run, const std::vector<std::string>& tags) {
  using enum cases::PartKind;
  std::vector<cases::PartKind> kinds;
  if (run.exists("/model/element/kind")) {
    for (const std::uint8_t k : run.read<std::uint8_t>("/model/element/kind")) kinds.push_back(static_cast<cases::PartKind>(k));
    return kinds;
  }
  for (const std::string& tag : tags) {
    kinds.push_back(!wall_tag(tag).side.empty()      ? brick
                    : tag.starts_with("lintel ")     ? lintel
                    : tag.starts_with("roof beam ")  ? beam
                    : tag.starts_with("vault ring ") ? voussoir
                                                     : block);
  }
  return kinds;
}

/// House, storey, position in the order round the house (4: an inner wall), side.
using WallKey = std::tuple<std::int32_t, int, std::ptrdiff_t, std::string>;
WallKey wall_key(std::int32_t house, const WallTag& tag) {
  constexpr std::array<std::string_view, 4> kRound{"front", "right", "rear", "left"};
  return {house, tag.storey, std::ranges::find(kRound, tag.side) - kRound.begin(), tag.side};
}

/// Sets the outward direction of a wall from its position round the rotated house.
void orient(Wall& wall, std::ptrdiff_t place, int quarter_turns) {
  const std::ptrdiff_t quarter = (place + 3 + quarter_turns) % 4;  // 0: +x, the right wall of a house that is not rotated; then +y, −x, −y
  wall.across = static_cast<std::size_t>(quarter % 2);
  wall.outward = quarter < 2 ? 1.0 : -1.0;
}

/// Sets the direction of an inner wall, or of one of free blocks: across it is its shorter side. Outward is away from the centre of the
/// model; for an inner wall, along the axis.
void orient_by_box(Wall& wall, const Box& all) {
  wall.across = wall.axes.turned() || wall.box.size(0) >= wall.box.size(1) ? 1 : 0;
  const double middle = wall.through({all.centre(0), all.centre(1), 0.0});
  wall.outward = !wall.inner && wall.box.centre(wall.across) < middle ? -1.0 : 1.0;
}

ElementVertices::Faces faces_of(const Hdf5File& run, std::size_t elements) {
  ElementVertices::Faces faces{run.read<double>("/model/face/normal"), run.read<std::int32_t>("/model/face/element")};
  const auto of_none = [&](std::int32_t e) { return e < 0 || static_cast<std::size_t>(e) >= elements; };
  if (faces.normal.size() != 3 * faces.element.size() || std::ranges::any_of(faces.element, of_none))
    throw FileError(run.path(), "/model/face does not fit together");
  return faces;
}

/// The axes of straight walls that run neither along x nor along y, by name. Bricks of curved walls belong to no wall: their tags are
/// emptied.
std::map<std::string, WallAxes> turned_walls(const Hdf5File& run, const ElementVertices& vertices, std::vector<WallTag>& tags) {
  std::map<std::string, std::vector<std::size_t>> walling;
  for (std::size_t e = 0; e < tags.size(); ++e)
    if (tags[e].walling) walling[tags[e].side].push_back(e);
  std::map<std::string, WallAxes> turned;
  if (walling.empty()) return turned;
  const ElementVertices::Faces faces = faces_of(run, tags.size());
  for (const auto& [side, elements] : walling) {
    if (const std::optional<WallAxes> axes = vertices.axes_along(elements, faces); axes)
      turned.emplace(side, *axes);
    else
      for (const std::size_t e : elements) tags[e] = WallTag{};
  }
  return turned;
}

/// Whether the element is a brick of a house, or a free block whose `part` is a wall.
bool may_be_of_wall(const Elements& elements, const Building& b, std::size_t e) {
  return elements.house[e] >= 0 || b.kind[e] == cases::PartKind::walling || b.kind[e] == cases::PartKind::arch_stone;
}

/// Finds walls with their boxes, house by house, storey by storey, in order round each; sets the wall of each brick.
void find_walls(const Hdf5File& run, const Elements& elements, Building& b) {
  const int quarter_turns = quarter_turns_of(run);
  std::set<std::int32_t> houses(elements.house.begin(), elements.house.end());
  houses.erase(-1);  // free blocks
  const bool several = houses.size() > 1;
  std::map<WallKey, std::int32_t> numbers;
  std::vector<WallTag> tags;
  for (std::size_t e = 0; e < elements.tag.size(); ++e)
    tags.push_back(may_be_of_wall(elements, b, e) ? wall_tag(elements.tag[e]) : WallTag{});
  const std::map<std::string, WallAxes> turned = turned_walls(run, b.vertices, tags);
  for (std::size_t e = 0; e < tags.size(); ++e) {
    if (!tags[e].side.empty() && !tags[e].gable) numbers.emplace(wall_key(elements.house[e], tags[e]), 0);
  }
  for (auto& [key, number] : numbers) {
    number = static_cast<std::int32_t>(b.walls.size());
    Wall& wall = b.walls.emplace_back();
    wall.house = std::get<0>(key), wall.storey = std::get<1>(key);
    wall.inner = wall.house >= 0 ? std::get<2>(key) == 4 : std::get<3>(key).starts_with("inner");
    if (const auto axes = turned.find(std::get<3>(key)); axes != turned.end()) wall.axes = axes->second;
    wall.box = Box::empty();
  }
  Box all = Box::empty();
  for (std::size_t e = 0; e < elements.tag.size(); ++e) {
    const auto found = tags[e].side.empty() ? numbers.end() : numbers.find(wall_key(elements.house[e], tags[e]));
    if (found == numbers.end()) continue;
    b.wall[e] = found->second;
    if (tags[e].gable) continue;
    Wall& wall = nth(b.walls, found->second);
    wall.box.include(b.box_in(wall, e)), all.include(b.box[e]);
    wall.name = tags[e].side + (tags[e].walling ? " walling" : " wall") + tags[e].storey_name +
                (several ? " of house " + std::to_string(wall.house) : "");
  }
  for (const auto& [key, number] : numbers) {
    Wall& wall = nth(b.walls, number);
    wall.inner || wall.house < 0 ? orient_by_box(wall, all) : orient(wall, std::get<2>(key), quarter_turns);
  }
}

/// Assigns lintels to the wall whose box contains them.
void find_lintels(const Elements& elements, Building& b) {
  for (std::size_t e = 0; e < b.kind.size(); ++e) {
    if (b.kind[e] != cases::PartKind::lintel) continue;
    for (std::size_t w = 0; w < b.walls.size(); ++w) {
      const Box &box = b.walls[w].box, own = b.box_in(b.walls[w], e);
      const auto inside = [&](std::size_t axis) { return own.centre(axis) > box.low[axis] && own.centre(axis) < box.high[axis]; };
      if (b.walls[w].house == elements.house[e] && inside(0) && inside(1) && inside(2)) b.wall[e] = static_cast<std::int32_t>(w);
    }
  }
}

void find_courses(const Elements& elements, Building& b) {
  for (Wall& w : b.walls) w.top.resize(static_cast<std::size_t>(std::lround(std::clamp(w.length() / kPiece, 1.0, kMostPieces))));
  for (std::size_t e = 0; e < b.wall.size(); ++e) {
    if (b.wall[e] < 0 || wall_tag(elements.tag[e]).gable) continue;
    Wall& w = nth(b.walls, b.wall[e]);
    if (b.box[e].low[2] < w.box.low[2] + kSameLevel) w.foot.push_back(e);
    if (b.box[e].high[2] < w.box.high[2] - kSameLevel) continue;
    const std::size_t along = 1 - w.across;
    const double place = (b.box_in(w, e).centre(along) - w.box.low[along]) / w.length() * static_cast<double>(w.top.size());
    const auto piece = [&](double x) { return static_cast<std::size_t>(std::clamp(x, 0.0, static_cast<double>(w.top.size() - 1))); };
    const std::size_t first = piece(place - kOnBorder), last = piece(place + kOnBorder);
    w.top[first].push_back(e);
    if (last != first) w.top[last].push_back(e);
  }
}

/// The name of a wall's gable: "left wall, storey 2" has "left gable, storey 2", as has "left walling, storey 2".
std::string gable_name(std::string wall) {
  for (const std::string_view what : {" walling", " wall"}) {
    if (const std::size_t at = wall.rfind(what); at != std::string::npos) return wall.replace(at, what.size(), " gable");
  }
  return wall;
}

/// Assigns lintels in gables to their walls.
void find_gable_lintels(const Elements& elements, Building& b) {
  for (std::size_t e = 0; e < b.kind.size(); ++e) {
    if (b.kind[e] != cases::PartKind::lintel || b.wall[e] >= 0) continue;
    for (const Gable& gable : b.gables) {
      const Box own = b.box_in(gable.part, e);
      const auto inside = [&](std::size_t k) { return own.centre(k) > gable.part.box.low[k] && own.centre(k) < gable.part.box.high[k]; };
      if (gable.part.house == elements.house[e] && inside(0) && inside(1) && inside(2)) b.wall[e] = gable.wall, b.gable[e] = 1;
    }
  }
}

/// Finds gables as parts of their own, with their lowest course and their upper third.
void find_gables(const Elements& elements, Building& b) {
  std::map<std::int32_t, std::vector<std::size_t>> of_wall;
  for (std::size_t e = 0; e < b.wall.size(); ++e) {
    b.gable[e] = b.wall[e] >= 0 && may_be_of_wall(elements, b, e) && wall_tag(elements.tag[e]).gable ? 1 : 0;
    if (b.gable[e] != 0) of_wall[b.wall[e]].push_back(e);
  }
  for (const auto& [wall, bricks] : of_wall) {
    Gable& gable = b.gables.emplace_back(Gable{wall, nth(b.walls, wall)});
    Wall& part = gable.part;
    part.name = gable_name(part.name), part.box = Box::empty(), part.foot.clear(), part.top.assign(1, {});
    for (const std::size_t e : bricks) part.box.include(b.box_in(part, e));
    for (const std::size_t e : bricks) {
      if (b.box[e].low[2] < part.box.low[2] + kSameLevel) part.foot.push_back(e);
      if (b.box[e].centre(2) >= part.box.high[2] - kUpperThird * part.height()) part.top.front().push_back(e);
    }
  }
}

/// The rectangle enclosed by the walls of a storey.
Room inside_of(const std::vector<const Wall*>& walls, const Box& outer, int storey) {
  Room room{{outer.low[0], outer.low[1]}, {outer.high[0], outer.high[1]}, outer.low[2], outer.high[2], storey, true};
  for (const Wall* w : walls) {
    if (w->inner) continue;
    double& low = room.low[w->across];
    double& high = room.high[w->across];
    w->outward < 0 ? low = std::max(low, w->box.high[w->across]) : high = std::min(high, w->box.low[w->across]);
  }
  return room;
}

/// Divides rooms by an inner wall that runs through them.
std::vector<Room> parted(const std::vector<Room>& rooms, const Wall& wall) {
  std::vector<Room> all;
  for (const Room& room : rooms) {
    const std::size_t k = wall.across;
    Room before = room, behind = room;
    before.high[k] = std::min(room.high[k], wall.box.low[k]), behind.low[k] = std::max(room.low[k], wall.box.high[k]);
    for (const Room& part : {before, behind})
      if (part.high[k] > part.low[k]) all.push_back(part);
  }
  return all;
}

/// \param any_plan  whether there are walls of [[wall]], whose rooms need not be rectangles
void find_rooms(Building& b, bool any_plan) {
  std::map<std::pair<std::int32_t, int>, std::vector<const Wall*>> storeys;
  for (const Wall& w : b.walls) {
    if (w.house >= 0 || !any_plan) storeys[{w.house, w.storey}].push_back(&w);
  }
  for (const auto& [key, walls] : storeys) {
    Box outer = Box::empty();
    for (const Wall* w : walls) outer.include(w->box);
    const Room whole = inside_of(walls, outer, key.second);
    if (whole.high[0] <= whole.low[0] || whole.high[1] <= whole.low[1]) continue;
    std::vector<Room> rooms{whole};
    for (const Wall* w : walls)
      if (w->inner) rooms = parted(rooms, *w);
    const bool top = !storeys.contains({key.first, key.second + 1});
    for (Room& room : rooms) room.top = top, b.rooms.push_back(room);
  }
}

/// The highest storey whose rooms end at or below the top of an element.
int storeys_under(const Building& b, std::size_t e) {
  int most = 0;
  for (const Room& r : b.rooms) {
    if (r.ceiling < b.box[e].high[2] + kSameLevel) most = std::max(most, r.storey);
  }
  return most;
}

/// Finds the number of storeys under each element of a floor or a roof. A floor of a house has it in its tag, "floor 2 beam 7"; one between
/// walls of any plan has a name of the user's, so heights tell.
void find_covers(const Elements& elements, Building& b) {
  for (std::size_t e = 0; e < b.kind.size(); ++e) {
    if (b.is_roof(e)) b.covers[e] = Building::kAll;
    if (b.kind[e] != cases::PartKind::floor_beam) continue;
    if (elements.house[e] < 0)
      b.covers[e] = storeys_under(b, e);
    else
      std::sscanf(elements.tag[e].c_str(), "floor %d", &b.covers[e]);
  }
}

/// From which heights count in the solver in a model without a base.
double lowest(const std::vector<Box>& boxes) {
  double low = std::numeric_limits<double>::infinity();
  for (const Box& b : boxes) low = std::min(low, b.low[2]);
  return std::isfinite(low) ? low : 0.0;
}

}  // namespace

std::string part_of(const std::string& tag) {
  if (tag.find(", storey ") != std::string::npos) return tag;
  const std::size_t end = tag.find_last_not_of("0123456789 ");
  return end == std::string::npos ? tag : tag.substr(0, end + 1);
}

Building building_of(const Hdf5File& run) {
  Building b;
  b.has_base = has_table(run, "base");
  b.mass = run.read<double>("/model/element/mass");
  const std::size_t n = b.mass.size();
  const Elements elements{run.read_strings("/model/element/tag"), run.read<std::int32_t>("/model/element/house"),
                          run.read<std::uint8_t>("/model/element/fixed")};
  b.kind = kinds_of(run, elements.tag);
  if (elements.tag.size() != n || elements.house.size() != n || elements.fixed.size() != n || b.kind.size() != n)
    throw FileError(run.path(), "/model/element does not fit together");
  for (std::size_t e = 0; e < n; ++e) {
    if (elements.fixed[e] != 0) b.mass[e] = 0.0;  // excluded from mass that may fall, as in the solver
  }
  b.wall.assign(n, -1);
  b.covers.assign(n, 0);
  b.gable.assign(n, 0);
  b.vertices = ElementVertices(run, n);
  for (std::size_t e = 0; e < n; ++e) b.box.push_back(b.vertices.box(e));
  b.datum = (b.has_base ? case_number(run, "base", "z") : 0.0) - origin_of_run(run).z;
  b.base = b.has_base ? b.datum : lowest(b.box);
  find_walls(run, elements, b);
  find_lintels(elements, b);
  find_rooms(b, has_table(run, "wall"));
  find_covers(elements, b);
  find_courses(elements, b);
  find_gables(elements, b);
  find_gable_lintels(elements, b);
  const bool any_house = std::ranges::any_of(elements.house, [](std::int32_t h) { return h >= 0; });
  b.footprint = Box::empty();
  for (std::size_t e = 0; e < n; ++e)
    if (any_house ? elements.house[e] >= 0 : elements.fixed[e] == 0) b.footprint.include(b.box[e]);
  return b;
}

}  // namespace voussoir::io
