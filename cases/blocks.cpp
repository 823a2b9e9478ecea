// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/blocks.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numbers>
#include <span>

#include "cases/case.h"
#include "cases/input_error.h"
#include "cases/names.h"
#include "cases/solids/cells.h"
#include "cases/solids/stone_blocks.h"
#include "geometry/nth.h"
#include "geometry/prism.h"

namespace voussoir::cases {
namespace {

using geometry::Polyhedron;

Polyhedron polyhedron_of(const BlockSpec& spec, const std::string& key) {
  if (spec.faces.empty()) {
    if (spec.vertices.size() == 8) return geometry::make_hexahedron(std::span<const Vec3, 8>(spec.vertices));
    throw InputError(key + ".vertices", "are " + std::to_string(spec.vertices.size()) + "; without faces they are the 8 of a hexahedron");
  }
  Polyhedron shape{spec.vertices, {}};
  for (const std::vector<int>& loop : spec.faces) shape.faces.emplace_back(loop.begin(), loop.end());
  geometry::validate(shape);  // before reordering: its messages count faces and vertices as in the case
  return geometry::in_prism_order(shape);
}

Polyhedron shape_as_given(const BlockSpec& spec, const std::string& key) {
  const bool prism = !spec.polygon.empty() || spec.extrude.has_value();
  const int shapes = (spec.box ? 1 : 0) + (spec.vertices.empty() ? 0 : 1) + (prism ? 1 : 0);
  if (shapes != 1) {
    throw InputError(key, (shapes == 0 ? "has no shape" : "has more than one shape") +
                              std::string("; give exactly one of: box, vertices, polygon with extrude"));
  }
  if (spec.box) {
    const auto& [a, b] = *spec.box;  // two opposite corners in any order
    return geometry::make_box({std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
                              {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)});
  }
  if (!spec.vertices.empty()) return polyhedron_of(spec, key);
  if (spec.polygon.empty()) throw InputError(key + ".polygon", "is missing; extrude needs a polygon of three corners or more");
  if (!spec.extrude) throw InputError(key + ".extrude", "is missing; a polygon needs extrude = [x0, x1]");
  return geometry::make_prism(spec.polygon, (*spec.extrude)[0], (*spec.extrude)[1]);
}

Polyhedron turned(const Polyhedron& shape, const Rotation& r) {
  return geometry::rotated(shape, r.axis, r.angle * std::numbers::pi / 180.0, r.about);
}

Polyhedron shape_of(const BlockSpec& spec, const std::string& key) {
  try {
    Polyhedron shape = shape_as_given(spec, key);
    geometry::validate(shape);
    if (!spec.rotate) return shape;
    if (norm(spec.rotate->axis) == 0.0) throw InputError(key + ".rotate.axis", "has no direction; give a vector other than [0, 0, 0]");
    return spec.halves || spec.cells ? shape : turned(shape, *spec.rotate);  // cells are cut before the turn
  } catch (const geometry::ModelError& e) {
    throw InputError(key, e.what());
  }
}

double shortest_edge(const Polyhedron& shape) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& face : shape.faces) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Vec3 a = nth(shape.vertices, face[i]);
      const Vec3 b = nth(shape.vertices, face[(i + 1) % face.size()]);
      shortest = std::min(shortest, norm(b - a));
    }
  }
  return shortest;
}

void check_support(const BlockSpec& spec, const std::string& key) {
  if (spec.fixed && spec.free) throw InputError(key + ".free", "a block cannot be both fixed and free");
  if (spec.fixed && !(spec.velocity == Vec3{} && spec.angular_velocity == Vec3{})) {
    throw InputError(key + (spec.velocity == Vec3{} ? ".angular_velocity" : ".velocity"),
                     "a fixed block has no initial velocity; [block.motion] moves it");
  }
  if (!spec.motion) return;
  if (!spec.fixed) throw InputError(key + ".motion", "only a fixed block can be moved; set fixed = true");
  check_motion(*spec.motion, key + ".motion");
}

/// Refuses `halves` and `cells` for blocks of other shapes, and for fixed ones, which cannot crack.
void check_shape_of_cells(const BlockSpec& spec, const std::string& key) {
  check_cells(spec.halves, spec.cells, key);
  if (spec.halves) {
    const char* against = !spec.box ? "vertices or a polygon" : spec.fixed ? "fixed = true" : nullptr;
    if (against != nullptr) throw InputError(key + ".halves", std::string("true does not go with ") + against + "; allowed: a free box");
  } else if (spec.cells) {
    const bool many = !spec.polygon.empty() && spec.polygon.size() != 4;
    const char* against = spec.fixed ? "fixed = true" : !spec.faces.empty() ? "faces" : many ? "this polygon" : nullptr;
    if (against != nullptr)
      throw InputError(key + ".cells", std::string("does not go with ") + against +
                                           "; allowed: a free box, polygon of four corners with extrude, or eight vertices without faces");
  }
}

/// Cells along the edges at the first vertex of the block's shape.
CellCounts cells_by_edges(const BlockSpec& spec) {
  const CellCounts& n = *spec.cells;
  if (spec.box) {  // its length is the longer horizontal edge
    const Vec3 size = (*spec.box)[1] - (*spec.box)[0];
    return std::abs(size.x) >= std::abs(size.y) ? n : CellCounts{n[1], n[0], n[2]};
  }
  if (spec.polygon.empty()) return n;
  const auto& p = spec.polygon;  // make_prism turns a clockwise one round: its first edge is then the last
  const double turn = (p[2][0] - p[0][0]) * (p[3][1] - p[1][1]) - (p[2][1] - p[0][1]) * (p[3][0] - p[1][0]);
  return turn > 0.0 ? CellCounts{n[0], n[2], n[1]} : CellCounts{n[2], n[0], n[1]};
}

/// Centre of a box, rotated or not, or centroid of another shape [m].
Vec3 centre_of(const BlockSpec& spec, const Polyhedron& shape) {
  if (!spec.box) return geometry::mass_properties(shape).centroid;
  Vec3 sum;
  for (const Vec3 v : shape.vertices) sum += v;
  return sum / static_cast<double>(shape.vertices.size());
}

/// Adds to the velocities of cells what the block's angular velocity gives them: they move as parts of one body.
void spin(const BlockSpec& spec, std::vector<Block>& cells) {
  std::vector<Vec3> centre;
  std::vector<double> share;
  double volume = 0.0;
  for (const Block& cell : cells) {
    centre.push_back(centre_of(spec, cell.shape));
    share.push_back(spec.box ? 1.0 : geometry::mass_properties(cell.shape).volume);
    volume += share.back();
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    Vec3 arm;  // from the centroid of the whole
    for (std::size_t j = 0; j < cells.size(); ++j) arm += (share[j] / volume) * (centre[i] - centre[j]);
    cells[i].velocity += cross(spec.angular_velocity, arm);
  }
}

/// The cells of a block, which was cut before `rotate`: rotated, and moving as parts of one body.
std::vector<Block> moving_cells(const BlockSpec& spec, const std::string& key, Block whole, Model& model) {
  if (spec.halves)
    set_halves(whole);
  else
    whole.cells = cells_by_edges(spec);
  std::vector<Block> cells{std::move(whole)};
  divide_units(cells, model.units);
  try {
    for (const Block& cell : cells) geometry::validate(cell.shape);
  } catch (const geometry::ModelError& e) {
    throw InputError(key + ".cells", std::string("would have faces that are not plane, or no volume (") + e.what() +
                                         "); allowed: a shape whose opposite edges, cut into equal parts, give plane cuts, as a prism");
  }
  if (spec.rotate) {
    for (Block& cell : cells) cell.shape = turned(cell.shape, *spec.rotate);
  }
  if (cells.size() > 1 && !(spec.angular_velocity == Vec3{})) spin(spec, cells);
  return cells;
}

}  // namespace

void check_motion(const SupportMotion& m, const std::string& key) {
  if (m.velocity.has_value() + m.file.has_value() + (m.to || m.turn) != 1)
    throw InputError(key, "give exactly one of: velocity; file; to, turn or both");
}

SupportHistory support_history(const SupportMotion& motion, const std::string& key) {
  SupportHistory history;
  history.key = key;
  history.about = motion.about;
  if (motion.file) {
    history.file = *motion.file;
  } else if (motion.to || motion.turn) {
    history.time = {0.0, 1.0};
    history.displacement = {Vec3{}, motion.to.value_or(Vec3{})};
    if (motion.turn) history.rotation = {Vec3{}, std::numbers::pi / 180.0 * *motion.turn};
  } else {
    history.time = {0.0, 1.0};
    history.displacement = {Vec3{}, *motion.velocity};
    history.open_ended = true;
  }
  return history;
}

namespace {

/// Adds one block, or its cells. \param first  blocks by their names so far
void add_free_block(const Case& c, std::size_t i, std::map<std::string, std::size_t>& first, Model& model) {
  const BlockSpec& spec = c.blocks[i];
  const std::string key = indexed_key("block", i, "");
  if (spec.name.empty()) throw InputError(key + ".name", "is missing; every block has a name of its own");
  if (const auto [at, added] = first.emplace(spec.name, i); !added) {
    throw InputError(key + ".name", quoted(spec.name) + " is already the name of " + indexed_key("block", at->second, ""));
  }
  check_support(spec, key);
  Block block;
  block.name = spec.name;
  block.tag = spec.name;
  set_part(spec.part, block);
  block.material = find_material(model.materials, spec.material, key + ".material");
  block.shape = shape_of(spec, key);
  block.segment_size = (spec.faces.empty() ? shortest_edge(block.shape) : geometry::least_width(block.shape)) / 4.0;
  block.fixed = spec.fixed;
  block.free = spec.free;
  block.velocity = spec.velocity;
  block.angular_velocity = spec.angular_velocity;
  if (spec.motion) {
    block.support_motion = static_cast<std::int32_t>(model.support_motions.size());
    model.support_motions.push_back(support_history(*spec.motion, key + ".motion.file"));
  }
  block.given = static_cast<std::int32_t>(i);
  if (!spec.halves && !spec.cells) {
    model.blocks.push_back(std::move(block));
    return;
  }
  check_shape_of_cells(spec, key);
  for (Block& cell : moving_cells(spec, key, std::move(block), model)) {
    if (cell.name != spec.name)
      if (const auto [at, added] = first.emplace(cell.name, i); !added)
        throw InputError(key + ".name",
                         quoted(cell.name) + ", a part of it, is already the name of " + indexed_key("block", at->second, ""));
    model.blocks.push_back(std::move(cell));
  }
}

}  // namespace

void add_free_blocks(const Case& c, Model& model) {
  std::map<std::string, std::size_t> first;
  Faults faults;
  for (std::size_t i = 0; i < c.blocks.size(); ++i) faults.attempt([&] { add_free_block(c, i, first, model); });
  faults.raise();
}

void set_part(const std::string& part, Block& block) {
  if (part.empty()) return;
  block.tag = part;
  const std::string name = part.substr(0, part.find(", storey "));
  if (name.ends_with(" wall") || name.ends_with(" gable")) block.kind = PartKind::walling;
}

}  // namespace voussoir::cases
