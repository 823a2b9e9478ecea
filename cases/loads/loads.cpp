// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/loads/loads.h"

#include <algorithm>
#include <cmath>

#include "cases/case.h"
#include "cases/loads/loaded_place.h"
#include "cases/names.h"
#include "cases/solids/outside.h"
#include "cases/solids/stone_blocks.h"
#include "geometry/nth.h"

namespace voussoir::cases {
namespace {

constexpr double kSamePlace = 1e-9;  // m: a point this near to two parts is on the first
constexpr double kVertical = 1e-6;   // share of the horizontal part in a force that counts as vertical

/// Whether a cell of the block has this name.
bool has_cell_named(const BlockSpec& b, const std::string& name) {
  if (!name.starts_with(b.name + "/")) return false;
  const int cells = b.cells ? (*b.cells)[0] * (*b.cells)[1] * (*b.cells)[2] : b.halves ? 2 : 1;
  for (int i = 1; cells > 1 && i <= cells; ++i)
    if (name == b.name + "/" + std::to_string(i)) return true;
  return false;
}

/// The block with this name, or the block one of whose cells has it.
const BlockSpec* block_named(const Case& c, const std::string& name) {
  const auto found = std::ranges::find_if(c.blocks, [&](const BlockSpec& b) { return b.name == name || has_cell_named(b, name); });
  return found == c.blocks.end() ? nullptr : &*found;
}

/// The part that contains the point, or is nearest to it.
std::int32_t part_at(const Model& model, const std::vector<std::int32_t>& parts, Vec3 point) {
  const auto outside = [&](std::int32_t e) { return std::max(0.0, distance_outside(model.assembly, static_cast<std::size_t>(e), point)); };
  std::int32_t best = parts.front();
  for (const std::int32_t e : parts)
    if (outside(e) < outside(best) - kSamePlace) best = e;
  return best;
}

/// Divides a load on a whole among its parts; the total force and moment are as given.
void share_out(const Model& model, const Load& load, const std::vector<std::int32_t>& parts, std::vector<LoadShare>& out) {
  const auto mass = [&](std::int32_t e) -> const geometry::MassProperties& { return nth(model.assembly.elements, e).mass; };
  if (load.at || parts.size() == 1) {
    const std::int32_t e = load.at ? part_at(model, parts, *load.at) : parts.front();
    out.push_back({e, 1.0, load.at.value_or(mass(e).centroid)});
    return;
  }
  double volume = 0.0;
  for (const std::int32_t e : parts) volume += mass(e).volume;
  for (const std::int32_t e : parts) out.push_back({e, mass(e).volume / volume, mass(e).centroid});
}

void check_name(const Case& c, std::size_t i) {
  const Load& load = c.loads[i];
  const std::string key = indexed_key("load", i, "block");
  const BlockSpec* named = block_named(c, load.block);
  if (named == nullptr && !is_stone_or_group(c, load.block)) {
    std::vector<std::string> names;
    for (const BlockSpec& b : c.blocks) names.push_back(b.name);
    for (const StonesSpec& spec : c.stones) {
      for (const Stone& stone : spec.stones) {
        names.push_back(stone_name(spec, stone.name));
        for (const std::string& group : stone.groups) names.push_back(stone_name(spec, group));
      }
    }
    throw InputError(key, "there is no [[block]]" + std::string(c.stones.empty() ? "" : ", stone or group") + " named " +
                              quoted(load.block) + (names.empty() ? "" : "; " + did_you_mean(load.block, names)));
  }
  if (named != nullptr && named->fixed) throw InputError(key, quoted(load.block) + " is fixed, a load cannot move it");
}

void check_load(const Case& c, std::size_t i) {
  const Load& load = c.loads[i];
  if (!load.block.empty()) check_name(c, i);
  if (!(load.ramp[0] <= load.ramp[1])) {
    throw InputError(indexed_key("load", i, "ramp"),
                     "begins at " + text(load.ramp[0]) + " s, after its end at " + text(load.ramp[1]) + " s");
  }
}

/// As in the case file, in the axes of which the origin is not zero.
std::string place(const Model& model, Vec3 p) {
  p += model.origin;
  return "[" + text(p.x) + ", " + text(p.y) + ", " + text(p.z) + "]";
}

}  // namespace

LoadShare share_met(const Model& model, const Load& load, Vec3 from, const std::string& key) {
  const LoadedPlace met = place_of_load(model, from, normalised(load.force));
  if (met.element < 0) throw InputError(key, "no block lies at " + place(model, from) + ", or behind it along the force");
  const Block& block = nth(model.blocks, met.element);
  if (block.fixed) throw InputError(key, "the force at " + place(model, from) + " meets " + quoted(block.name) + ", which is fixed");
  return {met.element, 1.0, met.at};
}

Vec3 push_direction(const Case& c) {
  const Analysis& a = c.analysis;
  Vec3 sum;
  if (a.kind == AnalysisKind::cyclic || (a.kind == AnalysisKind::pushover && a.pattern == LoadPattern::given)) {
    for (const Load& l : c.loads)
      if (l.grows) sum += l.force;
  }
  if (std::hypot(sum.x, sum.y) < kVertical * norm(sum)) return {0.0, 0.0, sum.z > 0.0 ? 1.0 : -1.0};
  const double length = std::hypot(a.direction[0], a.direction[1]);  // whose square may be no number
  return {a.direction[0] / length, a.direction[1] / length, 0.0};
}

void check_loads(const Case& c) {
  Faults faults;
  for (std::size_t i = 0; i < c.loads.size(); ++i) faults.attempt([&] { check_load(c, i); });
  faults.raise();
}

std::vector<LoadShare> load_shares(const Model& model, const Load& load, std::size_t index) {
  if (load.block.empty()) return {share_met(model, load, *load.at, indexed_key("load", index, "at"))};
  std::vector<std::vector<std::int32_t>> wholes = parts_named(model, load.block);
  const std::string key = indexed_key("load", index, "block");
  if (wholes.empty()) throw InputError(key, "= " + quoted(load.block) + " is the name of no block");
  std::vector<LoadShare> shares;
  for (std::vector<std::int32_t>& parts : wholes) {
    std::erase_if(parts, [&](std::int32_t e) { return nth(model.blocks, e).fixed; });
    if (!parts.empty()) share_out(model, load, parts, shares);
  }
  if (shares.empty()) throw InputError(key, quoted(load.block) + " is fixed, a load cannot move it");
  return shares;
}

}  // namespace voussoir::cases
