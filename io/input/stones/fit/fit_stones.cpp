// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/stones/fit/fit_stones.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "cases/case.h"
#include "cases/input_error.h"
#include "geometry/message.h"
#include "geometry/nth.h"
#include "geometry/solids/fit/fit_planes.h"
#include "geometry/solids/folds.h"
#include "io/input/stones/cut_stone.h"

namespace voussoir::io {
namespace {

using geometry::FitStone;
using geometry::FittedStone;
using geometry::Mesh;
using geometry::Polyhedron;

constexpr double kPlane = 1e-9;              // of the size, as geometry::validate
constexpr double kShare = 0.25;              // of the least width of a stone: its limit where the case has none
constexpr double kShallow = 0.3;             // rad: folds that turn by less are of a surface that was meant to be convex or plane
constexpr std::size_t kMostFolds = 30;       // of a stone that was meant not to be convex
constexpr std::size_t kMostMeasured = 2048;  // corners of a stone whose width is measured by its faces

/// A stone as convex pieces, before the fit.
struct Prepared {
  std::vector<Polyhedron> pieces;
  double limit = 0.0;   // m
  double moved = 0.0;   // m, by making it convex
  double volume = 0.0;  // m3, as drawn
  std::string fault;
};

/// The least distance between a face and the corner farthest behind it; of stones of many corners the least edge of their bounding box [m].
double width_of(const Mesh& m) {
  const geometry::Box3 box = geometry::box_of(m);
  const Vec3 edges = box.high - box.low;
  double least = std::min({edges.x, edges.y, edges.z});
  if (m.vertices.size() > kMostMeasured) return least;
  least = geometry::diagonal(m);
  for (std::size_t f = 0; f < m.faces.size(); ++f) {
    const geometry::HalfSpace h = geometry::half_space_of(m, f);
    double deepest = 0.0;
    for (const Vec3& v : m.vertices) deepest = std::max(deepest, h.offset - dot(h.normal, v));
    least = std::min(least, deepest);
  }
  return least;
}

/// Whether a stone has plane faces and few folds inward, all of them sharp.
bool is_sharply_folded(const Mesh& m) {
  for (std::size_t f = 0; f < m.faces.size(); ++f) {
    if (geometry::warp(m, f) > kPlane * geometry::diagonal(m)) return false;
  }
  const std::vector<geometry::Fold> folds = geometry::reflex_folds(m);
  return !folds.empty() && folds.size() <= kMostFolds &&
         std::all_of(folds.begin(), folds.end(), [](const geometry::Fold& f) { return f.turn > kShallow; });
}

std::optional<CutStone> tried_cut(const Mesh& m, double snap) {
  try {
    return cut_stone(m, snap);
  } catch (const geometry::ModelError&) {
    return std::nullopt;
  }
}

/// A stone that is not convex within its limit: with its faces made plane, cut along its folds.
void cut_folded(const Mesh& m, double snap, Prepared& p) {
  try {
    std::vector<geometry::RoughSolid> one = {{m, std::max(snap, 0.5 * p.limit), std::nullopt}};
    p.moved = geometry::flatten(one, std::nullopt).front().moved;
    CutStone done = cut_stone(one.front().mesh, snap);
    p.pieces = std::move(done.pieces);
  } catch (const geometry::ModelError& e) {
    p.fault = std::string("is not convex within ") + geometry::millimetres(p.limit) + " (stones.fit_limit), and " + e.what();
  }
}

Prepared prepared(const Mesh& m, const cases::StonesSpec& spec, geometry::FitWork& work, std::int32_t stone) {
  Prepared p;
  p.limit = spec.fit_limit.value_or(kShare * width_of(m));
  p.volume = geometry::volume(m);
  const bool exact = geometry::is_convex(m, kPlane * geometry::diagonal(m));
  if (exact || is_sharply_folded(m)) {
    if (auto done = tried_cut(m, spec.snap)) {
      p.pieces = std::move(done->pieces);
      return p;
    }
  }
  if (auto shape = geometry::nearly_convex(m, p.limit, p.moved, work, stone)) {
    p.pieces.push_back(*std::move(shape));
    return p;
  }
  cut_folded(m, spec.snap, p);
  return p;
}

std::string percent(double ratio) { return geometry::printed("%+.2g %%", 100.0 * ratio); }

/// Figures of a table of stones.
struct Summary {
  std::size_t stones = 0, changed = 0;
  double volume = 0.0, now = 0.0, least = 0.0, most = 0.0, moved = 0.0;
  std::string farthest;  // stone that moved the most

  void add(const StoneItem& item, const Prepared& before, const FittedStone& after, double by) {
    ++stones;
    volume += before.volume, now += after.now;
    if (!after.changed && before.moved == 0.0) return;
    ++changed;
    const double ratio = after.now / before.volume - 1.0;
    least = std::min(least, ratio), most = std::max(most, ratio);
    if (by > moved) moved = by, farthest = item.raw.name;
  }

  [[nodiscard]] std::string words() const {
    std::string text = "fit to planes: " + std::to_string(changed) + " of " + counted(stones, "stone") + " changed";
    if (changed == 0) return text;
    text += "; volume " + percent(now / volume - 1.0) + " in all, " + percent(least) + " to " + percent(most) + " of single stones";
    return text + "; largest movement " + geometry::millimetres(moved) + (farthest.empty() ? "" : ", of stone \"" + farthest + "\"");
  }
};

/// Why a stone is refused after the fit; empty: it is not.
std::string refusal(const Prepared& before, const FittedStone& after, double by, const std::string& place) {
  if (after.pieces.empty()) return "would vanish between the planes that fit it to its neighbours, at " + place + " m";
  if (by <= before.limit) return "";
  return "would have to move by " + geometry::millimetres(by) + " at " + place + " m to fit its neighbours (allowed " +
         geometry::millimetres(before.limit) + "); set stones.fit_limit if so much is right";
}

/// Does a part of the fit. \throw InputError that names the stone which takes too long, or has too many faces
template <class Part>
auto naming_stones(std::span<const StoneItem> items, const Part& part) {
  try {
    return part();
  } catch (const geometry::ModelError& e) {
    if (e.subject() < 0 || static_cast<std::size_t>(e.subject()) >= items.size()) throw cases::InputError("stones[0].fit", e.what());
    const StoneItem& item = items[static_cast<std::size_t>(e.subject())];
    throw cases::InputError("stones[" + std::to_string(item.table) + "].fit", "stone \"" + item.raw.name + "\" " + e.what());
  }
}

std::vector<Prepared> prepared_all(const cases::Case& c, std::span<const StoneItem> items) {
  std::size_t faces = 0;
  for (const StoneItem& item : items) faces += item.raw.mesh.faces.size();
  geometry::FitWork work(faces);
  std::vector<Prepared> all;
  for (const StoneItem& item : items) all.push_back(prepared(item.raw.mesh, c.stones[item.table], work, static_cast<std::int32_t>(all.size())));
  return all;
}

}  // namespace

bool fits_planes(const cases::Case& c) {
  for (std::size_t t = 1; t < c.stones.size(); ++t) {
    if (c.stones[t].fit != c.stones[0].fit)
      throw cases::InputError("stones[" + std::to_string(t) + "].fit", "differs from that of stones[0]: it must be the same in all tables");
  }
  return !c.stones.empty() && c.stones[0].fit == cases::StoneFit::planes;
}

std::vector<std::string> fit_stones(cases::Case& c, std::span<StoneItem> items) {
  const std::vector<Prepared> before = naming_stones(items, [&] { return prepared_all(c, items); });
  std::vector<FitStone> given;
  for (std::size_t i = 0; i < items.size(); ++i) given.push_back({before[i].pieces, before[i].limit, c.stones[items[i].table].snap});
  const std::optional<double> base = c.base ? std::optional(c.base->z) : std::nullopt;
  std::vector<FittedStone> after = naming_stones(items, [&] { return geometry::fit_planes(given, base); });
  std::vector<Summary> summaries(c.stones.size());
  std::vector<std::string> faults;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const double by = before[i].moved + after[i].moved;
    const Vec3 where = after[i].moved > 0.0 ? after[i].where : items[i].raw.mesh.vertices.front();
    faults.push_back(before[i].fault.empty() ? refusal(before[i], after[i], by, geometry::place_text(where)) : before[i].fault);
    if (!faults.back().empty()) continue;
    summaries[items[i].table].add(items[i], before[i], after[i], by);
    if (after[i].changed || before[i].moved > 0.0)
      items[i].fitted =
          "fitted: volume " + percent(after[i].now / before[i].volume - 1.0) + ", moved by up to " + geometry::millimetres(by);
    items[i].pieces = std::move(after[i].pieces);
  }
  for (std::size_t t = 0; t < c.stones.size(); ++t) {
    if (summaries[t].stones > 0) c.stones[t].notes.push_back(summaries[t].words());
  }
  return faults;
}

}  // namespace voussoir::io
