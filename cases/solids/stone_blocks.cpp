// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/solids/stone_blocks.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>

#include "cases/blocks.h"
#include "cases/case.h"
#include "cases/names.h"
#include "geometry/nth.h"

namespace voussoir::cases {
namespace {

constexpr double kUnbreakable = 1e15;  // Pa
constexpr const char* kInside = "inside a stone";

bool has(const std::vector<std::int32_t>& list, std::int32_t value) { return std::find(list.begin(), list.end(), value) != list.end(); }

std::string millimetres(double metres) { return text(std::round(1e9 * metres) / 1e6); }

std::int32_t material_of(const Case& c, const Model& model, std::size_t set) {
  const std::string key = indexed_key("stones", set, "material");
  if (!c.stones[set].material.empty()) return find_material(model.materials, c.stones[set].material, key);
  if (model.materials.size() == 1) return 0;
  throw InputError(key,
                   model.materials.empty() ? "is missing, and the case has no materials" : "is missing: the case has several materials");
}

constexpr double kThinnest = 0.1;  // of the width of a stone's widest piece: least width that sets the segment size of a piece

Vec3 centroid_of(const Stone& stone) {
  Vec3 sum;
  double volume = 0.0;
  for (const StonePiece& p : stone.pieces) {
    const geometry::MassProperties m = geometry::mass_properties(p.shape);
    sum += m.volume * m.centroid, volume += m.volume;
  }
  return sum / volume;
}

/// Adds the motion of one fixed stone, whose pieces move as one body.
void add_motion(const StonesSpec& spec, const Stone& stone, std::size_t set, Model& model, Block& like) {
  like.support_motion = -1;
  if (!spec.motion || !stone.fixed) return;
  like.support_motion = static_cast<std::int32_t>(model.support_motions.size());
  SupportHistory history = support_history(*spec.motion, indexed_key("stones", set, "motion.file"));
  if (!history.about) history.about = centroid_of(stone);
  model.support_motions.push_back(std::move(history));
}

/// Appends the pieces of one stone as blocks. \param like  a block with all fields but name, shape and beds set
void add_stone(const Stone& stone, const Block& like, const std::string& part, Model& model) {
  double widest = 0.0;
  for (const StonePiece& piece : stone.pieces) widest = std::max(widest, geometry::least_width(piece.shape));
  for (std::size_t i = 0; i < stone.pieces.size(); ++i) {
    Block block = like;
    if (stone.pieces.size() > 1) {
      block.part_of = block.name;
      block.name += "/" + std::to_string(i + 1);
    }
    block.tag = block.name;
    set_part(part, block);
    block.shape = stone.pieces[i].shape;
    block.beds = stone.pieces[i].beds;
    block.segment_size = std::max(geometry::least_width(block.shape), kThinnest * widest) / 4.0;
    model.blocks.push_back(std::move(block));
  }
}

}  // namespace

double metres_in(const std::string& unit) noexcept {
  return unit == "mm" ? 1e-3 : unit == "cm" ? 1e-2 : unit == "in" ? 0.0254 : unit == "ft" ? 0.3048 : 1.0;
}

std::string stone_name(const StonesSpec& spec, const std::string& name) { return spec.name.empty() ? name : spec.name + "/" + name; }

void add_stone_blocks(const Case& c, Model& model) {
  std::set<std::string> names;
  for (const Block& b : model.blocks) {
    if (b.house < 0) names.insert(b.name);
  }
  std::int32_t number = 0;
  for (std::size_t k = 0; k < c.stones.size(); ++k) {
    const StonesSpec& spec = c.stones[k];
    if (spec.stones.empty()) throw InputError(indexed_key("stones", k, "file"), quoted(spec.file) + " gave no stones");
    model.stones.push_back(spec.stones);
    Block like;
    like.set = static_cast<std::int32_t>(k);
    like.material = material_of(c, model, k);
    if (spec.motion && std::ranges::none_of(spec.stones, &Stone::fixed))
      throw InputError(indexed_key("stones", k, "motion"),
                       "moves nothing: no stone of " + quoted(spec.file) + " is fixed; see stones.supports");
    for (const Stone& stone : spec.stones) {
      like.name = stone_name(spec, stone.name);
      if (!names.insert(like.name).second) {
        throw InputError(indexed_key("stones", k, "name"),
                         "a stone " + quoted(like.name) + " of " + quoted(spec.file) +
                             " has the name of another stone or block; give this table a name of its own");
      }
      like.stone = number++;
      like.groups.clear();
      for (const std::string& group : stone.groups) like.groups.push_back(stone_name(spec, group));
      like.fixed = stone.fixed;
      add_motion(spec, stone, k, model, like);
      add_stone(stone, like, spec.part, model);
    }
  }
}

bool is_stone_or_group(const Case& c, const std::string& name) {
  for (const StonesSpec& spec : c.stones) {
    for (const Stone& stone : spec.stones) {
      const std::string full = stone_name(spec, stone.name);
      if (full == name) return true;
      for (const std::string& group : stone.groups) {
        if (stone_name(spec, group) == name) return true;
      }
      for (std::size_t i = 1; stone.pieces.size() > 1 && i <= stone.pieces.size(); ++i) {
        if (full + "/" + std::to_string(i) == name) return true;
      }
    }
  }
  return false;
}

std::vector<std::vector<std::int32_t>> parts_named(const Model& model, const std::string& name) {
  std::vector<std::int32_t> block;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const Block& b = model.blocks[i];
    if (b.house >= 0) continue;
    if (b.name == name) return {{static_cast<std::int32_t>(i)}};
    if (b.unit >= 0 && !name.empty() && b.part_of == name) block.push_back(static_cast<std::int32_t>(i));
  }
  if (!block.empty()) return {block};
  std::vector<std::vector<std::int32_t>> found;
  std::int32_t last = -1;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const Block& b = model.blocks[i];
    if (b.stone < 0) continue;
    const bool in_group = std::find(b.groups.begin(), b.groups.end(), name) != b.groups.end();
    if ((b.part_of.empty() ? b.name : b.part_of) != name && !in_group) continue;
    if (b.stone != last) found.emplace_back();
    last = b.stone;
    found.back().push_back(static_cast<std::int32_t>(i));
  }
  return found;
}

StoneLaws::StoneLaws(const Case& c, Model& model, std::int32_t default_law) {
  const std::size_t given = model.laws.size();
  for (std::size_t k = 0; k < c.stones.size(); ++k) {
    const auto& joint = c.stones[k].joint;
    of_set_.push_back(joint ? find_law(model.laws, *joint, indexed_key("stones", k, "joint")) : -1);
  }
  of_material_.assign(model.materials.size(), -1);
  const bool pieces =
      std::any_of(model.blocks.begin(), model.blocks.end(), [](const Block& b) { return b.stone >= 0 && !b.part_of.empty(); });
  for (std::size_t m = 0; m < model.materials.size(); ++m) {
    const auto& inside = model.materials[m].value.inside;
    if (inside) of_material_[m] = find_law(std::span(model.laws).first(given), *inside, "materials." + model.materials[m].name + ".inside");
  }
  if (pieces && has(of_material_, -1)) {
    NamedLaw law{kInside, {}};
    law.never_breaks = true;
    law.value.tension = law.value.cohesion = law.value.compression = kUnbreakable;
    std::replace(of_material_.begin(), of_material_.end(), -1, static_cast<std::int32_t>(model.laws.size()));
    model.laws.push_back(std::move(law));
  }
  bed_.resize(c.stones.size());
  for (std::size_t k = 0; k < c.stones.size(); ++k) {
    if (!c.stones[k].gap) continue;
    bed_[k].assign(given, -1);
    const std::int32_t law = of_set_[k] >= 0 ? of_set_[k] : default_law;
    const NamedLaw& own = nth(model.laws, law);
    if (!(own.value.young > 0.0)) {
      throw InputError(indexed_key("stones", k, "gap"), "is a bed of mortar of " + millimetres(*c.stones[k].gap) + " mm, but the law " +
                                                            quoted(own.name) + " between these stones has no young (Pa, of the mortar)");
    }
    NamedLaw bed{own.name + ", bed of " + millimetres(*c.stones[k].gap) + " mm", own.value, law};
    bed.value.thickness = *c.stones[k].gap;
    nth(bed_[k], law) = static_cast<std::int32_t>(model.laws.size());
    model.laws.push_back(std::move(bed));
  }
}

std::optional<std::int32_t> StoneLaws::law(const Block& a, const Block* b) const noexcept {
  if (b == nullptr || a.set < 0) return std::nullopt;
  if (a.stone == b->stone) return nth(of_material_, a.material);
  if (a.set != b->set || nth(of_set_, a.set) < 0) return std::nullopt;
  return nth(of_set_, a.set);
}

std::int32_t StoneLaws::on_bed(std::int32_t law, const Block& a, std::int32_t face_a, const Block& b, std::int32_t face_b) const noexcept {
  if (a.set < 0 || b.set < 0 || a.stone == b.stone || !has(a.beds, face_a) || !has(b.beds, face_b)) return law;
  const auto& beds = nth(bed_, a.set);
  const auto at = static_cast<std::size_t>(law);
  return at < beds.size() && beds[at] >= 0 ? beds[at] : law;
}

}  // namespace voussoir::cases
