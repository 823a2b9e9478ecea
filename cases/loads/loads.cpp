// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/loads/loads.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cases/case.h"
#include "cases/loads/loaded_place.h"
#include "cases/names.h"
#include "cases/solids/outside.h"
#include "cases/solids/stone_blocks.h"
#include "geometry/nth.h"

namespace voussoir::cases {
namespace {

constexpr double kSamePlace = 1e-9;       // m: a point this near to two parts is on the first
constexpr double kVertical = 1e-6;        // share of the horizontal part in a force that counts as vertical
constexpr double kOfElement = 0.25;       // of the size of the smallest element: how far a moving load goes from one station to the next
constexpr double kMostStations = 1000.0;  // beside the rows of its file

/// The block with this name, or the block one of whose halves has it.
const BlockSpec* block_named(const Case& c, const std::string& name) {
  const auto found = std::ranges::find_if(
      c.blocks, [&](const BlockSpec& b) { return b.name == name || (b.halves && (b.name + "/1" == name || b.name + "/2" == name)); });
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

/// The share of a load that acts on what it meets from a point on.
LoadShare share_met(const Model& model, const Load& load, Vec3 from, const std::string& key) {
  const LoadedPlace met = place_of_load(model, from, normalised(load.force));
  if (met.element < 0) throw InputError(key, "no block lies at " + place(model, from) + ", or behind it along the force");
  const Block& block = nth(model.blocks, met.element);
  if (block.fixed) throw InputError(key, "the force at " + place(model, from) + " meets " + quoted(block.name) + ", which is fixed");
  return {met.element, 1.0, met.at};
}

/// Between two points of a path so many stations that none is farther from the next than `spacing`; the path itself is given by its rows.
SupportHistory with_stations(const SupportHistory& path, double spacing) {
  SupportHistory all;
  for (std::size_t k = 0; k < path.time.size(); ++k) {
    const Vec3 from = path.displacement[k > 0 ? k - 1 : 0], way = path.displacement[k] - from;
    const double count = k > 0 ? std::max(1.0, std::ceil(norm(way) / spacing)) : 1.0, t0 = path.time[k > 0 ? k - 1 : 0];
    for (double s = 1.0; s <= count; s += 1.0) {
      all.time.push_back(s < count ? t0 + (s / count) * (path.time[k] - t0) : path.time[k]);
      all.displacement.push_back(s < count ? from + (s / count) * way : path.displacement[k]);
    }
  }
  return all;
}

/// m, between stations: a part of the smallest element, but no more stations than kMostStations.
double station_spacing(const Model& model, const SupportHistory& path) {
  double least = std::numeric_limits<double>::infinity(), length = 0.0;
  for (const geometry::Element& e : model.assembly.elements) least = std::min(least, std::cbrt(e.mass.volume));
  for (std::size_t k = 1; k < path.displacement.size(); ++k) length += norm(path.displacement[k] - path.displacement[k - 1]);
  return std::max(kOfElement * least, length / kMostStations);
}

}  // namespace

std::vector<MovingShare> moving_shares(const Model& model, const Load& load, std::size_t index, const SupportHistory& path) {
  const SupportHistory at = with_stations(path, station_spacing(model, path));
  std::vector<MovingShare> shares;
  for (std::size_t k = 0; k < at.time.size(); ++k) {
    MovingShare m{share_met(model, load, at.displacement[k] - model.origin, indexed_key("load", index, "path")), {}};
    const auto row = [&](std::size_t i, Vec3 force) { m.force.time.push_back(at.time[i]), m.force.displacement.push_back(force); };
    if (k > 0) row(k - 1, {});
    row(k, load.force);
    if (k + 1 < at.time.size()) row(k + 1, {});
    shares.push_back(std::move(m));
  }
  return shares;
}

Vec3 push_direction(const Case& c) {
  const Analysis& a = c.analysis;
  Vec3 sum;
  if (a.kind == AnalysisKind::cyclic || (a.kind == AnalysisKind::pushover && a.pattern == LoadPattern::given)) {
    for (const Load& l : c.loads)
      if (l.grows) sum += l.force;
  }
  if (std::hypot(sum.x, sum.y) < kVertical * norm(sum)) return {0.0, 0.0, sum.z > 0.0 ? 1.0 : -1.0};
  return normalised(Vec3{a.direction[0], a.direction[1], 0.0});
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
