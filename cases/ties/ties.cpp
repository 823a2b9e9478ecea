// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/ties/ties.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

#include "cases/case.h"
#include "cases/house/floors/house_decks.h"
#include "cases/house/floors/house_floors.h"
#include "cases/house/house_ties.h"
#include "cases/house/roofs/house_pitched.h"
#include "cases/names.h"
#include "cases/solids/outside.h"
#include "cases/ties/tie_names.h"
#include "cases/walls/spans/wall_floors.h"
#include "cases/walls/spans/wall_rods.h"
#include "cases/walls/spans/wall_roofs.h"
#include "geometry/nth.h"
#include "geometry/polygon.h"

namespace voussoir::cases {
namespace {

constexpr double kNear = 1e-3;      // m, tolerance from a point to the element that contains it, and from a face to a plate
constexpr double kShortest = 1e-2;  // m, least length of a tie
constexpr double kCovered = 0.5;    // least share of a plate's area on faces
constexpr double kNever = std::numeric_limits<double>::infinity();

std::string point_text(Vec3 p) { return "[" + text(p.x) + ", " + text(p.y) + ", " + text(p.z) + "]"; }

/// One end of a tie, from the case file.
struct End {
  std::string key;  // "tie[0].from"
  Vec3 point;
  Vec3 inwards;  // unit vector towards the other end
};

/// A place, in the axes of the file.
std::string place_text(const Model& model, Vec3 p) { return point_text(model.origin + p); }

[[noreturn]] void refuse_point(const Case& c, const Model& model, const End& end) {
  double least = kNever;
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const double d = distance_outside(model.assembly, i, end.point);
    if (d < least) least = d, nearest = i;
  }
  const std::string base = c.base ? ", nor on the base (z = " + text(model.origin.z + c.base->z) + " m)" : "";
  throw InputError(end.key, place_text(model, end.point) + " m lies in no element" + base + "; the nearest, " +
                                describe(model.blocks[nearest], nearest) + ", is " + text(std::round(least * 1e3) / 1e3) + " m away");
}

bool on_base(const Case& c, Vec3 point) { return c.base && std::abs(point.z - c.base->z) <= kNear; }

/// The element that contains the point; −1: none.
std::int32_t element_at(const Model& model, Vec3 point) {
  double least = kNear;
  std::int32_t found = -1;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const double d = distance_outside(model.assembly, i, point);
    if (d < least - 1e-9) least = d, found = static_cast<std::int32_t>(i);
  }
  return found;
}

std::vector<TieHold> hold_at_point(const Case& c, const Model& model, const End& end) {
  if (on_base(c, end.point)) return {{geometry::kBase, 1.0, end.point}};
  const std::int32_t found = element_at(model, end.point);
  if (found >= 0) return {{found, 1.0, end.point}};
  refuse_point(c, model, end);
}

/// The parts of a plate on the faces in one plane with the outward normal `n`.
std::vector<TieHold> covered(const Model& model, const End& end, const std::array<double, 2>& plate, Vec3 n) {
  const Vec3 across = std::abs(n.z) > 0.99 ? Vec3{1, 0, 0} : normalised(cross(Vec3{0, 0, 1}, n)), up = cross(n, across);
  const auto in_plane = [&](Vec3 x) { return geometry::Point2{dot(x - end.point, across), dot(x - end.point, up)}; };
  const geometry::Polygon shape = geometry::to_polygon({{-0.5 * plate[0], -0.5 * plate[1]}, {0.5 * plate[0], 0.5 * plate[1]}});
  const geometry::Assembly& a = model.assembly;
  std::vector<TieHold> holds;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    if (distance_outside(a, i, end.point) > plate[0] + plate[1]) continue;
    for (std::int32_t f = 0; f < a.elements[i].face_count; ++f) {
      const geometry::Face& face = nth(a.faces, a.elements[i].first_face + f);
      if (dot(face.normal, n) < 1.0 - 1e-6 || std::abs(dot(face.normal, end.point) - face.offset) > kNear) continue;
      geometry::Polygon corners;
      for (const std::int32_t v : nth(model.blocks[i].shape.faces, f)) corners.push_back(in_plane(nth(model.blocks[i].shape.vertices, v)));
      const geometry::Region region = geometry::region(geometry::intersection(shape, corners));
      if (region.area < 1e-6 * plate[0] * plate[1]) continue;
      holds.push_back({static_cast<std::int32_t>(i), region.area, end.point + region.centroid.s * across + region.centroid.t * up});
    }
  }
  return holds;
}

double area_of(const std::vector<TieHold>& holds) {
  double area = 0.0;
  for (const TieHold& h : holds) area += h.share;
  return area;
}

/// The hold of a plate: among the planes of faces through the point that face away from the other end (within 60 degrees), the plane in
/// which the plate covers most. (A point on the edge of a brick lies in the plane of the brick's joint, too.)
std::vector<TieHold> hold_by_plate(const Model& model, const End& end, const std::array<double, 2>& plate) {
  const geometry::Assembly& a = model.assembly;
  std::vector<TieHold> holds;
  double area = 0.0;
  std::vector<Vec3> seen;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    if (distance_outside(a, i, end.point) > plate[0] + plate[1]) continue;
    for (std::int32_t f = 0; f < a.elements[i].face_count; ++f) {
      const geometry::Face& face = nth(a.faces, a.elements[i].first_face + f);
      if (-dot(face.normal, end.inwards) < 0.5 - 1e-9 || std::abs(dot(face.normal, end.point) - face.offset) > kNear) continue;
      if (std::ranges::any_of(seen, [&](Vec3 n) { return dot(n, face.normal) > 1.0 - 1e-6; })) continue;
      seen.push_back(face.normal);
      std::vector<TieHold> found = covered(model, end, plate, face.normal);
      if (area_of(found) > area * (1.0 + 1e-9)) area = area_of(found), holds = std::move(found);
    }
  }
  if (holds.empty())
    throw InputError(end.key, place_text(model, end.point) +
                                  " m lies on no face that looks away from the other end, so its plate has nothing to press on");
  for (TieHold& h : holds) h.share /= area;
  if (area < (1.0 - 1e-6) * kCovered * plate[0] * plate[1])
    throw InputError(end.key, "only " + text(std::round(100.0 * area / (plate[0] * plate[1]))) + " % of the plate at " +
                                  place_text(model, end.point) + " m lies on faces of the model; wanted " + text(100.0 * kCovered) +
                                  " % or more");
  return holds;
}

Vec3 middle(const std::vector<TieHold>& holds) {
  Vec3 at;
  for (const TieHold& h : holds) at += h.share * h.point;
  return at;
}

/// Whether an end is on the base and its tie comes from above: such an end needs no plate.
bool anchored_in_base(const Case& c, const End& end) { return on_base(c, end.point) && end.inwards.z > 0.5; }

bool is_one_element(const TieBar& bar) {
  std::set<std::int32_t> elements;
  for (const auto& end : bar.ends)
    for (const TieHold& h : end) elements.insert(h.element);
  return elements.size() == 1;
}

/// Attaches a tie to elements. \param plates  whether each end has the tie's plate
TieBar place(const Case& c, const Model& model, const Tie& tie, const std::array<std::string, 2>& keys, const std::string& key,
             std::array<bool, 2> plates = {true, true}) {
  const double apart = norm(tie.to - tie.from);
  if (apart < kShortest)
    throw InputError(keys[1], "is " + text(apart) + " m from tie.from; a tie has a length of " + text(kShortest) + " m or more");
  const Vec3 along = normalised(tie.to - tie.from);
  TieBar bar;
  bar.name = tie.name;
  const std::array<End, 2> ends{End{keys[0], tie.from, along}, End{keys[1], tie.to, -along}};
  for (std::size_t k = 0; k < 2; ++k)
    bar.ends[k] = tie.plate && plates[k] && !anchored_in_base(c, ends[k]) ? hold_by_plate(model, ends[k], *tie.plate)
                                                                          : hold_at_point(c, model, ends[k]);
  if (is_one_element(bar)) throw InputError(key, "holds one element alone: both ends are on it");
  bar.length = norm(middle(bar.ends[1]) - middle(bar.ends[0]));
  bar.stiffness = tie.young * tie.area / bar.length;
  bar.yield = tie.yield ? *tie.yield * tie.area : kNever;
  // Stress over strain has the slope E_t beyond yield, so stress over plastic strain has the slope E E_t / (E − E_t).
  bar.hardening = tie.young * tie.hardening / (tie.young - tie.hardening) * tie.area / bar.length;
  bar.breaking = tie.elongation ? *tie.elongation * bar.length : kNever;
  bar.pretension = tie.pretension;
  bar.compression = tie.compression;
  return bar;
}

std::int64_t anchors(const TieBar& bar) {
  return std::ranges::count_if(bar.ends, [](const auto& end) { return end.front().element != geometry::kBase; });
}

void add_ties(const Case& c, Model& model) {
  Faults faults;
  const auto add = [&](std::size_t i, const Tie& tie) {
    model.ties.push_back(place(c, model, tie, {indexed_key("tie", i, "from"), indexed_key("tie", i, "to")}, indexed_key("tie", i, "")));
    model.tie_bill.push_back({tie.name, 1, anchors(model.ties.back()), norm(tie.to - tie.from), 0.0});
  };
  for (std::size_t i = 0; i < c.ties.size(); ++i) faults.attempt([&] { add(i, c.ties[i]); });
  faults.raise();
}

/// \param list  "house.tie" \param ties  its entries
void add_rods(const Case& c, const std::vector<PlannedTie>& rods, const char* list, const std::vector<HouseTie>& ties, Model& model) {
  std::vector<TieBill> bills(ties.size());
  std::vector<bool> failed(ties.size(), false);  // each is told once
  Faults faults;
  for (const PlannedTie& planned : rods) {
    if (failed[planned.index]) continue;
    failed[planned.index] = !faults.attempt([&] {
      const std::string key = indexed_key(list, planned.index, "");
      TieBar bar = place(c, model, planned.tie, {key, key}, key);
      TieBill& bill = bills[planned.index];
      bill.name = ties[planned.index].bar.name;
      ++bill.ties, bill.anchors += anchors(bar), bill.length += norm(planned.tie.to - planned.tie.from);
      model.ties.push_back(std::move(bar));
    });
  }
  faults.raise();
  model.tie_bill.insert(model.tie_bill.end(), bills.begin(), bills.end());
}

/// \param list  "house.floor" \param names  of the floors
void add_beam_anchors(const Case& c, const std::vector<PlannedTie>& anchors, const char* list, const std::vector<std::string>& names,
                      Model& model) {
  std::vector<TieBill> bills(names.size());
  for (const PlannedTie& planned : anchors) {
    const std::string key = indexed_key(list, planned.index, "anchor");
    TieBar bar = place(c, model, planned.tie, {key, key}, key, {false, true});  // nailed to the beam, without a plate there
    TieBill& bill = bills[planned.index];
    bill.name = names[planned.index] + " anchors";
    ++bill.ties, bill.anchors += 2, bill.length += norm(planned.tie.to - planned.tie.from);
    model.ties.push_back(std::move(bar));
  }
  std::ranges::copy_if(bills, std::back_inserter(model.tie_bill), [](const TieBill& b) { return b.ties > 0; });
}

std::vector<std::string> floor_names(const House& house) {
  std::vector<std::string> names;
  for (const Floor& f : house.floors) names.push_back("floor " + std::to_string(f.storey));
  return names;
}

void add_roof_ties(const Case& c, double foot, Model& model) {
  TieBill bill{"roof ties"};
  for (const PlannedTie& planned : roof_ties(*c.house, foot)) {
    TieBar bar = place(c, model, planned.tie, {"house.roof.tie", "house.roof.tie"}, "house.roof.tie", {false, false});
    ++bill.ties, bill.anchors += 2, bill.length += norm(planned.tie.to - planned.tie.from);
    model.ties.push_back(std::move(bar));
  }
  if (bill.ties > 0) model.tie_bill.push_back(bill);
}

/// Adds the bars of a deck. \param number  TieBar::mesh of the deck, counted after the meshes
void add_deck(const PlannedDeck& planned, const std::string& name, std::size_t number, Model& model) {
  TieBill bill{name};
  bill.area = planned.area;
  for (const DeckBar& bar : planned.bars) {
    TieBar tie;
    tie.name = bill.name + " " + std::to_string(++bill.ties);
    for (std::size_t k = 0; k < 2; ++k) {
      const std::int32_t element = element_at(model, bar.ends[k]);
      if (element < 0) throw std::logic_error("a bar of the " + name + " ends at " + place_text(model, bar.ends[k]) + " m, in no element");
      tie.ends[k] = {{element, 1.0, bar.ends[k]}};
    }
    tie.length = norm(bar.ends[1] - bar.ends[0]);
    tie.stiffness = bar.stiffness;
    tie.yield = bar.strength.value_or(kNever);
    tie.breaking = kNever;
    tie.compression = true;
    tie.mesh = static_cast<std::int32_t>(number);
    model.ties.push_back(std::move(tie));
  }
  model.tie_bill.push_back(bill);
}

void add_decks(const Case& c, double foot, Model& model) {
  const House& house = *c.house;
  for (std::size_t i = 0; i < house.floors.size(); ++i) {
    const std::string name = "floor " + std::to_string(house.floors[i].storey) + " deck";
    if (house.floors[i].deck) add_deck(house_deck(house, i, foot), name, house.meshes.size() + i, model);
  }
  const bool boards = house.roof.kind == RoofKind::pitched && house.roof.deck;
  if (boards) add_deck(roof_deck(house, foot), "roof deck", house.meshes.size() + house.floors.size(), model);
}

/// Adds a bar between two nodes, if they are on two different elements.
void add_bar(const PlannedMesh& mesh, const std::vector<std::int32_t>& element, std::array<std::int32_t, 2> nodes, TieBar bar,
             Model& model) {
  for (std::size_t k = 0; k < 2; ++k) {
    const auto node = static_cast<std::size_t>(nodes[k]);
    if (element[node] < 0) return;
    bar.ends[k] = {{element[node], 1.0, mesh.nodes[node]}};
  }
  if (bar.ends[0][0].element != bar.ends[1][0].element) model.ties.push_back(std::move(bar));
}

TieBar strap_of(const HouseMesh& mesh, double width, double length) {
  TieBar bar;
  bar.length = length, bar.stiffness = mesh.stiffness * width / length;
  bar.yield = mesh.strength ? *mesh.strength * width : kNever;
  bar.breaking = mesh.elongation ? *mesh.elongation * length : kNever;
  return bar;
}

TieBar connector_of(const MeshConnectors& connectors, double length) {
  TieBar bar;
  bar.length = length, bar.stiffness = connectors.young * connectors.area / length, bar.compression = true;
  bar.yield = connectors.yield ? *connectors.yield * connectors.area : kNever;
  bar.breaking = connectors.elongation ? *connectors.elongation * length : kNever;
  return bar;
}

void add_mesh(const Case& c, std::size_t index, double foot, Model& model) {
  const HouseMesh& mesh = c.house->meshes[index];
  const PlannedMesh planned = house_mesh(*c.house, index, foot);
  std::vector<std::int32_t> element;
  for (const Vec3 node : planned.nodes) element.push_back(element_at(model, node));
  TieBill bill{mesh.name};
  bill.area = planned.cell * static_cast<double>(std::ranges::count_if(element, [](std::int32_t e) { return e >= 0; }));
  const auto apart = [&](std::array<std::int32_t, 2> nodes) { return norm(nth(planned.nodes, nodes[1]) - nth(planned.nodes, nodes[0])); };
  const std::size_t before = model.ties.size();
  for (const PlannedMesh::Strap& s : planned.straps) add_bar(planned, element, s.nodes, strap_of(mesh, s.width, apart(s.nodes)), model);
  for (const auto& nodes : planned.connectors) {
    if (nth(element, nodes[0]) < 0 || nth(element, nodes[1]) < 0) continue;
    add_bar(planned, element, nodes, connector_of(*mesh.connectors, apart(nodes)), model);
    bill.length += apart(nodes), bill.anchors += 2;
  }
  for (std::size_t i = before; i < model.ties.size(); ++i) {
    model.ties[i].mesh = static_cast<std::int32_t>(index);
    model.ties[i].name = mesh.name + " " + std::to_string(i - before + 1);
  }
  bill.ties = static_cast<std::int64_t>(model.ties.size() - before);
  if (bill.ties == 0)
    throw InputError(indexed_key("house.mesh", index, ""), "holds no two elements: its nodes are too far apart, or stand in openings");
  model.tie_bill.push_back(bill);
}

void add_roof_ties_between_walls(const Case& c, const WallsPlan& plan, double foot, Model& model) {
  std::vector<TieBill> bills(c.roofs.size());
  for (const PlannedTie& planned : wall_roof_ties(c.walls, plan, c.roofs, foot)) {
    const std::string key = indexed_key("roof", planned.index, "tie");
    TieBar bar = place(c, model, planned.tie, {key, key}, key, {false, false});
    TieBill& bill = bills[planned.index];
    bill.name = c.roofs[planned.index].name + " ties";
    ++bill.ties, bill.anchors += 2, bill.length += norm(planned.tie.to - planned.tie.from);
    model.ties.push_back(std::move(bar));
  }
  std::ranges::copy_if(bills, std::back_inserter(model.tie_bill), [](const TieBill& b) { return b.ties > 0; });
}

void add_decks_between_walls(const Case& c, const WallsPlan& plan, double foot, Model& model) {
  const std::size_t before = c.house ? c.house->meshes.size() + c.house->floors.size() + 1 : 0;  // numbers of meshes and decks
  for (std::size_t i = 0; i < c.floors.size(); ++i) {
    if (c.floors[i].beams.deck) add_deck(wall_floor_deck(plan, c.floors, i, foot), c.floors[i].name + " deck", before + i, model);
  }
  for (std::size_t i = 0; i < c.roofs.size(); ++i) {
    if (c.roofs[i].rafters.deck)
      add_deck(wall_roof_deck(c.walls, plan, c.roofs, i, foot), c.roofs[i].name + " deck", before + c.floors.size() + i, model);
  }
}

}  // namespace

void place_ties(const Case& c, const WallsPlan& walls, Model& model) {
  const double foot = c.base ? c.base->z : 0.0;
  Faults faults;
  faults.attempt([&] { add_ties(c, model); });
  if (c.house) {
    faults.attempt([&] { add_rods(c, house_ties(*c.house, foot), "house.tie", c.house->ties, model); });
    faults.attempt([&] { add_beam_anchors(c, beam_anchors(*c.house, foot), "house.floor", floor_names(*c.house), model); });
    faults.attempt([&] { add_roof_ties(c, foot, model); });
  }
  faults.attempt([&] { add_rods(c, wall_rods(c.walls, walls, c.wall_ties, foot), "wall_tie", c.wall_ties, model); });
  std::vector<std::string> floors;
  for (const WallFloor& f : c.floors) floors.push_back(f.name);
  faults.attempt([&] { add_beam_anchors(c, wall_beam_anchors(c.walls, walls, c.floors, foot), "floor", floors, model); });
  faults.attempt([&] { add_roof_ties_between_walls(c, walls, foot, model); });
  if (c.house) {
    for (std::size_t i = 0; i < c.house->meshes.size(); ++i) faults.attempt([&] { add_mesh(c, i, foot, model); });
    add_decks(c, foot, model);
  }
  faults.raise();
  add_decks_between_walls(c, walls, foot, model);
  check_tie_names(c, model);
}

std::size_t own_ties(const Model& model) noexcept {
  return static_cast<std::size_t>(std::ranges::count_if(model.ties, [](const TieBar& t) { return t.mesh < 0; }));
}

std::vector<TieGroup> tie_groups(const Model& model) {
  std::vector<TieGroup> groups;
  for (std::size_t i = own_ties(model); i < model.ties.size(); ++i) {
    const TieBar& bar = model.ties[i];
    if (groups.empty() || model.ties[i - 1].mesh != bar.mesh)
      groups.push_back({bar.name.substr(0, bar.name.rfind(' ')), i, i});  // bars are numbered behind the name
    groups.back().last = i + 1;
  }
  return groups;
}

}  // namespace voussoir::cases
