// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/model.h"

#include <algorithm>
#include <limits>

#include "cases/blocks.h"
#include "cases/case.h"
#include "cases/followed_points.h"
#include "cases/house/house.h"
#include "cases/house/house_ties.h"
#include "cases/loads/loads.h"
#include "cases/loose_model.h"
#include "cases/names.h"
#include "cases/numbering.h"
#include "cases/rules/contact_rules.h"
#include "cases/rules/joint_rules.h"
#include "cases/rules/scatter.h"
#include "cases/solids/cells.h"
#include "cases/solids/ground.h"
#include "cases/solids/origin.h"
#include "cases/solids/stone_blocks.h"
#include "cases/ties/ties.h"
#include "cases/walls/walls.h"
#include "geometry/nth.h"

namespace voussoir::cases {
namespace {

constexpr double kMostSegments = 2e8;  // on all faces, 24 bytes each before the run starts: a limit against typing errors
constexpr double kCellLengths = 3.0;   // bricks; times of a Flat20N with 2, 3 and 4 lengths are equal, with 1.5 and 6 longer

void check_material(const std::string& name, const Material& value) {
  const std::string key = "materials." + name;
  if (name == "base") throw InputError(key, "\"base\" is the ground under the model; give the material another name");
  if (!(value.density > 0.0)) throw InputError(key + ".density", text(value.density) + " kg/m3; must be above 0");
  if (!(value.young > 0.0)) throw InputError(key + ".young", text(value.young) + " Pa; must be above 0");
  if (!(value.poisson >= 0.0 && value.poisson < 0.5)) {
    throw InputError(key + ".poisson", text(value.poisson) + "; allowed: 0 to below 0.5");
  }
}

void check_law(const std::string& name, const JointLaw& value) {
  const std::string key = "joint_laws." + name;
  if (name == "dry") throw InputError(key, "\"dry\" is always there and means no bond; give the law another name");
  if (value.thickness > 0.0 && !(value.young > 0.0)) {
    throw InputError(key + ".young",
                     text(value.young) + " Pa; a joint with mortar (thickness = " + text(value.thickness) + " m) needs its modulus");
  }
}

void name_materials_and_laws(const Case& c, Model& model, Faults& faults) {
  for (const auto& named : c.materials) {
    faults.attempt([&] { check_material(named.first, named.second); });
    model.materials.push_back({named.first, named.second});
  }
  model.laws.push_back({"dry", {}});
  for (const auto& named : c.joint_laws) {
    faults.attempt([&] { check_law(named.first, named.second); });
    model.laws.push_back({named.first, named.second});
  }
}

void add_house(const Case& c, Model& model) {
  const bool on_fixed_block = std::any_of(c.blocks.begin(), c.blocks.end(), [](const BlockSpec& b) { return b.fixed; });
  if (!c.base && !on_fixed_block && c.stones.empty())
    throw InputError("base", "a house needs ground to stand on; add [base] with z = 0.0, or a fixed [[block]]");
  check_cells(c.house->halves, c.house->cells, "house");
  model.blocks = build_house(*c.house, model.materials);
  if (c.house->halves) {
    for (Block& block : model.blocks)
      if (block.kind == PartKind::brick && block.whole) set_halves(block);
  }
  divide_units(model.blocks, model.units);
  number_along_plan(model.blocks, kCellLengths * (c.house->brick[0] + c.house->mortar));
  const double z = c.base ? c.base->z : 0.0;
  if (z == 0.0) return;
  for (Block& block : model.blocks) {
    for (Vec3& v : block.shape.vertices) v.z += z;
  }
}

}  // namespace

WallSpans spans_of(const Case& c) { return {c.floors, c.roofs, c.vaults}; }

namespace {

/// The plan of walls and what spans between them; adds their materials under loads. \throw InputErrors with all that is at fault
WallsPlan planned_walls(const Case& c, Model& model) {
  if (c.walls.empty()) {
    if (!c.floors.empty()) throw InputError("floor[0].walls", "name sides of [[wall]], of which the case has none");
    if (!c.roofs.empty()) throw InputError("roof[0].walls", "name sides of [[wall]], of which the case has none");
    if (!c.vaults.empty()) throw InputError("vault[0].walls", "name sides of [[wall]], of which the case has none");
    return {};
  }
  Faults faults;
  WallsPlan plan;
  for (std::size_t i = 0; i < c.walls.size(); ++i)
    faults.attempt([&] { check_cells(false, c.walls[i].cells, indexed_key("wall", i, "")); });
  faults.attempt([&] { check_wall_materials(c.walls, spans_of(c), model.materials); });
  faults.attempt([&] { plan = plan_walls(c.walls, spans_of(c)); });
  const bool on_fixed_block = std::any_of(c.blocks.begin(), c.blocks.end(), [](const BlockSpec& b) { return b.fixed; });
  if (!c.base && !on_fixed_block && c.stones.empty())
    faults.add({"base", "a wall needs ground to stand on; add [base] with z = 0.0, or a fixed [[block]]"});
  faults.raise();
  for (NamedMaterial& loaded : loaded_wall_materials(c.walls, spans_of(c), plan, model.materials))
    model.materials.push_back(std::move(loaded));
  return plan;
}

void add_walls(const Case& c, const WallsPlan& plan, Model& model) {
  if (c.walls.empty()) return;
  std::vector<Block> blocks = blocks_of_walls(c.walls, spans_of(c), plan, model.materials);
  divide_units(blocks, model.units);
  number_along_plan(blocks, kCellLengths * c.walls[0].brick[0]);
  for (Block& block : blocks) {
    for (Vec3& v : block.shape.vertices) v.z += c.base ? c.base->z : 0.0;
    model.blocks.push_back(std::move(block));
  }
}

/// The key at fault when geometry refuses an element: that of a free block, else of the house.
std::string key_of(const Model& model, int element) {
  if (element < 0 || static_cast<std::size_t>(element) >= model.blocks.size()) return "";
  if (nth(model.blocks, element).house >= 0) return "house";
  const Block& block = nth(model.blocks, element);
  if (block.wall >= 0) return indexed_key("wall", static_cast<std::size_t>(block.wall), "");
  if (block.span >= 0) return indexed_key(block.kind == PartKind::floor_beam ? "floor" : "roof", static_cast<std::size_t>(block.span), "");
  if (block.vault >= 0) return indexed_key("vault", static_cast<std::size_t>(block.vault), "");
  if (block.ground >= 0) return indexed_key("base.part", static_cast<std::size_t>(block.ground), "");
  if (block.set >= 0) return indexed_key("stones", static_cast<std::size_t>(block.set), "file");
  return indexed_key("block", static_cast<std::size_t>(block.given), "");
}

/// Replaces block numbers in a message of geometry, as in "block 12: overlaps block 3 by 0.1 m", by names. A name may itself be "block 3".
std::string with_names(const Model& model, const geometry::ModelError& error) {
  std::string message = error.what();
  const auto number = [](int element) { return "block " + std::to_string(element); };
  const auto known = [&](int element) {
    const auto index = static_cast<std::size_t>(element);
    return describe(model.blocks.at(index), index);
  };
  if (error.other() >= 0) {  // the later first, while the message holds no names
    const std::size_t at = message.rfind(number(error.other()));
    message = at == std::string::npos ? known(error.other()) + ": " + message
                                      : message.replace(at, number(error.other()).size(), known(error.other()));
  }
  if (error.subject() >= 0) {
    const std::string first = number(error.subject());
    message = message.starts_with(first) ? known(error.subject()) + message.substr(first.size()) : known(error.subject()) + ": " + message;
  }
  return message;
}

/// A remedy for faults of stones from a file, and of what spans between walls.
std::string what_to_do(const Case& c, const Model& model, const geometry::ModelError& error) {
  const std::string message = error.what();
  const auto says = [&](const char* words) { return message.find(words) != std::string::npos; };
  const auto is = [&](int element, auto holds) {
    return element >= 0 && static_cast<std::size_t>(element) < model.blocks.size() && holds(nth(model.blocks, element));
  };
  const auto spans = [&](const Block& b) { return b.span >= 0 || (b.vault >= 0 && nth(c.vaults, b.vault).kind == VaultKind::barrel); };
  const auto stands = [](const Block& b) { return b.wall >= 0; };
  for (const auto& [over, wall] : {std::pair{error.subject(), error.other()}, std::pair{error.other(), error.subject()}})
    if (says("overlaps") && is(over, spans) && is(wall, stands))
      return "; give " + key_of(model, over) + " four " + quoted("corners") + " between which that wall does not stand";
  if (!is(std::max(error.subject(), error.other()), [](const Block& b) { return b.set >= 0; })) return "";
  if (says("overlaps")) return "; part them where they were drawn, or raise stones.snap if faces were meant to touch";
  if (says("touches nothing") || says("held by nothing"))
    return "; faces farther apart than stones.snap do not touch: move it, raise snap, give gap if there is mortar between, fix it "
           "(stones.supports), or give the case a [base]";
  if (says("below the base")) return "; stones.place moves the stones of a file, base.z the base";
  return "";
}

[[noreturn]] void refuse(const Case& c, const Model& model, const geometry::ModelError& error) {
  // The later of two blocks in the case is at fault.
  const int later = std::max(error.subject(), error.other());
  throw InputError(key_of(model, later), with_names(model, error) + what_to_do(c, model, error) + origin_note(model.origin, error.what()));
}

/// Approximate number of segments on the faces of a block: that of its bounding box.
double segments_on(const Block& block) {
  const auto [low, high] = geometry::bounds(block.shape);
  const Vec3 size = high - low;
  return 2.0 * (size.x * size.y + size.y * size.z + size.z * size.x) / (block.segment_size * block.segment_size);
}

void check_segments(const Case& c, const Model& model) {
  double all = 0.0, most = 0.0;
  int finest = -1;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const double n = segments_on(model.blocks[i]);
    all += n;
    if (n > most) most = n, finest = static_cast<int>(i);
  }
  if (all <= kMostSegments) return;
  const Block& block = nth(model.blocks, finest);
  const std::string size = text(block.segment_size) + " m" + (c.segment_size ? "" : " (a quarter of its shortest edge)");
  throw InputError(c.segment_size ? "segments.size" : key_of(model, finest),
                   "makes about " + text(std::round(all)) + " segments on the faces of the model (allowed: " + text(kMostSegments) + "); " +
                       describe(block, static_cast<std::size_t>(finest)) + " has " + text(std::round(most)) + " of " + size +
                       "; a larger segments.size makes fewer");
}

void assemble(const Case& c, int threads, Model& model) {
  std::vector<geometry::Part> parts;
  parts.reserve(model.blocks.size());
  for (const Block& block : model.blocks) parts.push_back({&block.shape, block.segment_size, block.fixed || block.free, block.ground >= 0});
  try {
    model.assembly = geometry::assemble(parts, c.base ? std::optional(c.base->z) : std::nullopt, c.segment_rule, threads);
  } catch (const geometry::ModelError& error) {
    refuse(c, model, error);
  }
}

/// Points at corners alone have three times the second moment of a rectangle: right for what turns about its edges, not for stresses.
void refuse_bonds_at_corners(const Case& c, const Model& model) {
  if (c.segment_rule != geometry::SegmentRule::corners) return;
  for (std::size_t i = 0; i < model.joint_law.size(); ++i) {
    const NamedLaw& law = nth(model.laws, model.joint_law[i]);
    if (law.never_breaks || (law.value.tension == 0.0 && law.value.cohesion == 0.0)) continue;
    const geometry::Joint& joint = model.assembly.joints[i];
    const Block* b = beyond(model, joint);
    throw InputError("segments.rule", "= \"corners\": is of joints without a bond, but that of " +
                                          describe(nth(model.blocks, joint.element_a), static_cast<std::size_t>(joint.element_a)) +
                                          " and " + (b == nullptr ? "the base" : describe(*b, static_cast<std::size_t>(joint.element_b))) +
                                          " has the law \"" + law.name +
                                          "\", with tension or cohesion; allowed with bonds: \"centres\", \"rim\"");
  }
}

void pick_laws(const JointRules& rules, const StoneLaws& stones, Model& model) {
  model.joint_law.reserve(model.assembly.joints.size());
  for (const geometry::Joint& joint : model.assembly.joints) {
    const Block& a = nth(model.blocks, joint.element_a);
    const Block* b = beyond(model, joint);
    const std::int32_t law = stones.law(a, b).value_or(rules.law(a, b));
    model.joint_law.push_back(b == nullptr ? law : stones.on_bed(law, a, joint.face_a, *b, joint.face_b));
  }
}

}  // namespace

namespace {

void size_segments(const Case& c, Model& model) {
  if (!c.segment_size) return;
  if (!(*c.segment_size > 0.0)) throw InputError("segments.size", text(*c.segment_size) + " m; must be above 0");
  for (Block& block : model.blocks) {
    if (block.ground < 0) block.segment_size = *c.segment_size;
  }
}

/// A model that is not yet assembled, with what ties between walls are placed by.
struct LaidModel {
  Model model;
  WallsPlan walls;
};

/// The model with materials, laws and blocks; tells the faults of all of them, and of the names of laws, at once.
LaidModel model_of_blocks(const Case& c) {
  LaidModel laid;
  Model& model = laid.model;
  Faults faults;
  model.origin = c.origin.value_or(Vec3{});
  name_materials_and_laws(c, model, faults);
  if (!c.house && c.walls.empty() && c.blocks.empty() && c.stones.empty())
    throw InputError("", "describes nothing to simulate; give [house], [[wall]], [[block]] or [[stones]], or some of them");
  faults.attempt([&] {
    if (!c.house) return;
    for (NamedMaterial& loaded : loaded_materials(*c.house, model.materials)) model.materials.push_back(std::move(loaded));
  });
  const bool planned = faults.attempt([&] { laid.walls = planned_walls(c, model); });
  if (c.base && !c.base->parts.empty()) add_ground_material(model);
  faults.attempt([&] { model.contact_friction = contact_friction(c.contact, model.materials); });
  faults.attempt([&] { check_loads(c); });
  if (c.house) faults.attempt([&] { add_house(c, model); });
  if (c.house) faults.attempt([&] { check_house_ties(*c.house); });
  if (planned) faults.attempt([&] { add_walls(c, laid.walls, model); });
  faults.attempt([&] { add_free_blocks(c, model); });
  faults.attempt([&] { add_stone_blocks(c, model); });
  if (!faults.any()) add_ground(c, model);
  faults.attempt([&] { size_segments(c, model); });
  faults.attempt([&] { JointRules(c, model); });
  faults.raise();
  for (std::size_t i = 0; i < c.loads.size(); ++i) {
    model.load_history.push_back(c.loads[i].history ? static_cast<std::int32_t>(model.support_motions.size()) : -1);
    if (c.loads[i].history)
      model.support_motions.push_back({{}, {}, false, *c.loads[i].history, "load[" + std::to_string(i) + "].history"});
    model.load_path.push_back(c.loads[i].path ? static_cast<std::int32_t>(model.support_motions.size()) : -1);
    if (c.loads[i].path) model.support_motions.push_back({{}, {}, false, *c.loads[i].path, "load[" + std::to_string(i) + "].path"});
  }
  check_segments(c, model);
  return laid;
}

}  // namespace

Model build_loose_model(const Case& c) {
  if (const std::optional<Case> grounded = with_ground(c)) return build_loose_model(*grounded);
  Model model = model_of_blocks(c).model;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const Block& block = model.blocks[i];
    const geometry::Part alone{&block.shape, block.segment_size, true};
    try {
      geometry::Assembly one = geometry::assemble({&alone, 1}, std::nullopt, c.segment_rule);
      one.elements[0].first_face = static_cast<std::int32_t>(model.assembly.faces.size());
      model.assembly.elements.push_back(one.elements[0]);
      model.assembly.faces.insert(model.assembly.faces.end(), one.faces.begin(), one.faces.end());
    } catch (const geometry::ModelError& error) {
      throw InputError(key_of(model, static_cast<int>(i)), describe(block, i) + ": " + error.what());
    }
  }
  return model;
}

Model build_model(const Case& c, int threads) {
  if (const std::optional<Case> grounded = with_ground(c)) return build_model(*grounded, threads);
  LaidModel laid = model_of_blocks(c);
  Model& model = laid.model;
  const JointRules rules(c, model);
  assemble(c, threads, model);
  pick_laws(rules, StoneLaws(c, model, rules.default_law()), model);
  refuse_bonds_at_corners(c, model);
  model.joint_strength = strength_factors(c.scatter, model);
  Faults faults;
  if (!faults.attempt([&] { place_ties(c, laid.walls, model); })) {
    faults.attempt([&] { check_followed_points(c, model); });
    faults.raise();
  }
  return std::move(laid.model);
}

void forget_joints(Model& model) noexcept {
  geometry::Assembly& a = model.assembly;
  a.joints = std::vector<geometry::Joint>();
  a.patches = std::vector<geometry::FreePatch>();
  a.segments.reset(), a.axes.reset();
}

std::int32_t nearest_element(const Model& model, Vec3 point) noexcept {
  // Points often lie midway between two bricks; without a tolerance round-off would decide.
  constexpr double kTie = 1e-9;  // m
  double least = std::numeric_limits<double>::infinity();
  std::int32_t nearest = 0;
  for (std::size_t i = 0; i < model.assembly.elements.size(); ++i) {
    const double distance = norm(model.assembly.elements[i].mass.centroid - point);
    if (distance >= least - kTie) continue;
    least = distance;
    nearest = static_cast<std::int32_t>(i);
  }
  return nearest;
}

const char* name(PartKind kind) noexcept {
  switch (kind) {
    case PartKind::brick:
      return "brick";
    case PartKind::lintel:
      return "lintel";
    case PartKind::beam:
      return "roof beam";
    case PartKind::voussoir:
      return "voussoir";
    case PartKind::column:
      return "column";
    case PartKind::ring_beam:
      return "ring beam";
    case PartKind::floor_beam:
      return "floor beam";
    case PartKind::walling:
      return "walling";
    case PartKind::arch_stone:
      return "arch stone";
    case PartKind::block:
      break;
  }
  return "block";
}

std::string describe(const Block& block, std::size_t element) {
  const std::string number = "element " + std::to_string(element);
  if (block.ground >= 0 || block.wall >= 0 || block.span >= 0 || block.vault >= 0) return block.tag + " (" + number + ")";
  if (block.house < 0) return (block.set < 0 ? "block " : "stone ") + quoted(block.name) + " (" + number + ")";
  return block.tag + " (" + number + (block.house > 0 ? ", house " + std::to_string(block.house) : "") + ")";
}

}  // namespace voussoir::cases
