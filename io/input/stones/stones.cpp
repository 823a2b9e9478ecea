// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/stones/stones.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cases/case.h"
#include "cases/solids/origin.h"
#include "geometry/message.h"
#include "geometry/nth.h"
#include "geometry/prism.h"
#include "geometry/solids/flatten.h"
#include "geometry/solids/overlaps.h"
#include "geometry/solids/triangles.h"
#include "io/input/stones/cut_stone.h"
#include "io/input/stones/fit/fit_stones.h"
#include "io/input/stones/raw_stones.h"
#include "io/input/stones/shown_faults.h"
#include "io/input/stones/supports.h"

namespace voussoir::io {
namespace {

using geometry::Mesh;
using geometry::Polyhedron;

constexpr double kConvex = 1e-9;      // of the size, as geometry::validate
constexpr int kMostRefused = 20;      // stones set aside because their faces do not fit, before the attempt is given up
constexpr double kNearlyFlat = 0.05;  // rad: between faces of a surface that was meant to be plane, as from coordinates in millimetres

std::string table_key(std::size_t table) { return "stones[" + std::to_string(table) + "]"; }

/// The message without the number of the block in geometry.
std::string without_subject(const geometry::ModelError& e) {
  const std::string message = e.what(), prefix = "block " + std::to_string(e.subject()) + ": ";
  return e.subject() >= 0 && message.starts_with(prefix) ? message.substr(prefix.size()) : message;
}

/// Whether two boxes are nearer to each other than `reach`.
bool meet(const geometry::Box3& a, const geometry::Box3& b, double reach) {
  return a.low.x <= b.high.x + reach && b.low.x <= a.high.x + reach && a.low.y <= b.high.y + reach && b.low.y <= a.high.y + reach &&
         a.low.z <= b.high.z + reach && b.low.z <= a.high.z + reach;
}

using Item = StoneItem;

class Import {
 public:
  explicit Import(cases::Case& c) : case_(c) {}

  void load() {
    read();
    if (!faults_.empty())
      throw cases::InputError(table_key(faults_.front().table) + ".file", faults_.front().message + other_faults(faults_));
    choose_supports(case_);
  }

  std::vector<ShownFault> load_shown() {
    read();
    std::vector<ShownFault> out;
    for (StoneFault& f : faults_) {
      auto& stones = case_.stones[f.table].stones;
      out.push_back({f.table, stones.size(), std::move(f.message)});
      stones.push_back({std::move(f.stone), {}, false, plates_of(f.mesh), {}});
    }
    try {
      choose_supports(case_);
    } catch (const cases::InputError&) {
      return out;
    }
    return out;
  }

 private:
  void read() {
    std::vector<Item> read;
    for (std::size_t t = 0; t < case_.stones.size(); ++t) {
      cases::StonesSpec& spec = case_.stones[t];
      if (!spec.stones.empty()) continue;
      for (RawStone& raw : raw_stones(spec, table_key(t), case_.folder, {spec.notes, spec.doubts})) read.push_back({t, std::move(raw)});
    }
    to_origin(read);
    for (Item& item : read) {
      close_up(item.raw);
      const std::string fault = std::move(item.raw.fault);
      items_.push_back(std::move(item));
      if (!fault.empty()) set_aside(items_.size() - 1, fault);
    }
    if (items_.empty()) return;
    if (fits_planes(case_)) {
      fit();
    } else {
      mend();
    }
    for (std::size_t i = 0; i < items_.size(); ++i) finish(i);
  }

  /// Fits all stones to planes; sets aside those that do not fit within their limits.
  void fit() {
    const std::vector<std::string> faults = fit_stones(case_, items_);
    flattened_.resize(items_.size());
    for (std::size_t i = 0, k = 0; k < faults.size(); ++k) {
      if (faults[k].empty()) {
        ++i;
      } else {
        set_aside(i, faults[k]);
      }
    }
  }

  /// Makes faces within snap touch, and cuts stones into convex pieces.
  void mend() {
    for (Item& item : items_) {
      item.drawn = item.raw.mesh;
      straighten(item);
      part_warped(item);
    }
    put_together();
    for (std::size_t i = 0; i < items_.size();) {
      const std::size_t before = items_.size();
      cut_into_pieces(i);
      if (items_.size() == before) ++i;
    }
    part();
  }

  /// Makes the coordinates of the case and of what was read relative to the origin of the model.
  void to_origin(std::vector<Item>& read) {
    if (!case_.origin) {
      cases::check_reach(case_);
      std::vector<geometry::Box3> boxes;
      for (const Item& item : read) {
        boxes.push_back(geometry::box_of(item.raw.mesh));
        check_reach(item, boxes.back());
      }
      cases::move_origin(case_, cases::suitable_origin(case_, boxes));
    }
    if (*case_.origin == Vec3{}) return;
    for (Item& item : read) {
      for (Vec3& v : item.raw.mesh.vertices) v = v - *case_.origin;
    }
  }

  void check_reach(const Item& item, const geometry::Box3& box) const {
    for (const Vec3 v : {box.low, box.high}) {
      if (std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}) <= cases::kFarthest) continue;
      throw cases::InputError(table_key(item.table) + ".file", stone_words(spec_of(item), item.raw.name) + " reaches to " +
                                                                   geometry::place_text(v) +
                                                                   " m, too far from the origin of the axes; "
                                                                   "allowed: -1e7 to 1e7 m; stones.place moves the stones of a file");
    }
  }

  [[nodiscard]] const cases::StonesSpec& spec_of(const Item& item) const { return case_.stones[item.table]; }

  /// Records a refused stone and excludes it from further steps.
  void set_aside(std::size_t i, const std::string& message) {
    Item& item = items_[i];
    faults_.push_back({item.table, item.raw.name,
                       stone_words(spec_of(item), item.raw.name) + " " + message + cases::origin_note(*case_.origin, message),
                       std::move(item.raw.mesh)});
    items_.erase(items_.begin() + static_cast<std::ptrdiff_t>(i));
    if (i < flattened_.size()) flattened_.erase(flattened_.begin() + static_cast<std::ptrdiff_t>(i));
  }

  /// Straightens a stone that is convex up to the rounding of its corners: triangles of what was meant to be one face become that face.
  void straighten(Item& item) const {
    const double size = geometry::diagonal(item.raw.mesh), snap = spec_of(item).snap;
    if (snap == 0.0 || geometry::is_convex(item.raw.mesh, kConvex * size)) return;
    // A fourth corner is up to four times as far from the plane of the other three as all four are from their mean plane.
    Mesh merged = geometry::with_merged_faces(item.raw.mesh, 4.0 * std::min(snap, 0.005 * size), kNearlyFlat);
    if (!geometry::is_convex(merged, 2.0 * snap)) return without_dents(item, merged.faces.size());
    if (is_plane(merged, snap)) merge(item, std::move(merged));
  }

  static bool is_plane(const Mesh& m, double within) {
    for (std::size_t f = 0; f < m.faces.size(); ++f) {
      if (geometry::warp(m, f) > within) return false;
    }
    return true;
  }

  static void merge(Item& item, Mesh merged) {
    item.nearly_flat = item.raw.mesh.faces.size() - merged.faces.size();
    item.raw.mesh = std::move(merged);
  }

  /// Straightens a stone that is not convex, of triangles with rounded corners. Dents of flat faces may be too shallow to cut along, so no
  /// more faces are merged than needed to cut the stone with no, or the smallest, dents ignored. \param fewest  faces, if all that are
  /// nearly in one plane are merged
  void without_dents(Item& item, std::size_t fewest) const {
    std::size_t faces = item.raw.mesh.faces.size();
    double least = faces == fewest ? 0.0 : dents_left(item);
    const double most = 4.0 * std::min(spec_of(item).snap, 0.005 * geometry::diagonal(item.raw.mesh));
    Mesh best;
    for (double within = 1e-6 * most; least > 0.0 && within < 2.0 * most; within *= 10.0) {
      Item tried = item;
      tried.raw.mesh = geometry::with_merged_faces(item.raw.mesh, std::min(within, most), kNearlyFlat);
      if (tried.raw.mesh.faces.size() == faces || !is_plane(tried.raw.mesh, spec_of(item).snap)) continue;
      faces = tried.raw.mesh.faces.size();
      if (const double left = dents_left(tried); left < least) least = left, best = std::move(tried.raw.mesh);
    }
    if (!best.faces.empty()) merge(item, std::move(best));
  }

  /// Depth [m] of the dents ignored when a stone is cut without regard to its neighbours; infinite if it cannot be cut.
  [[nodiscard]] double dents_left(Item item) const {
    try {
      part_warped(item);
      std::vector<geometry::RoughSolid> one = {{std::move(item.raw.mesh), spec_of(item).snap, spec_of(item).gap}};
      const bool moved = geometry::flatten(one, std::nullopt).front().moved > 0.0;
      item.raw.mesh = moved ? merged_exactly(one.front().mesh) : std::move(one.front().mesh);
      cut(item);
      return item.dents;
    } catch (const geometry::ModelError&) {
      return std::numeric_limits<double>::infinity();
    }
  }

  void part_warped(Item& item) const {
    if (spec_of(item).warped == cases::WarpedFaces::triangles)
      item.raw.mesh = geometry::with_parted_faces(item.raw.mesh, spec_of(item).snap, item.in_triangles);
  }

  /// Whether no stone is so near that faces could have to fit.
  [[nodiscard]] bool is_lone(std::size_t i) const {
    const auto reach = [&](const Item& item) { return 2.0 * (spec_of(item).snap + spec_of(item).gap.value_or(0.0)); };
    const geometry::Box3 own = geometry::box_of(items_[i].drawn);
    if (case_.base && own.low.z <= case_.base->z + reach(items_[i])) return false;
    for (std::size_t k = 0; k < items_.size(); ++k) {
      if (k != i && meet(own, geometry::box_of(items_[k].drawn), reach(items_[i]) + reach(items_[k]))) return false;
    }
    return true;
  }

  /// Resets a lone stone that cannot be made plane to its drawn mesh; if that has warped faces that cannot be made plane together, divides
  /// them into triangles. Faces warped by more than snap are not divided.
  /// \return false if there is nothing left to try
  bool take_back(std::size_t i) {
    Item& item = items_[i];
    if (item.taken_back == 2 || !is_lone(i)) return false;
    const bool straightened = item.taken_back == 0 && item.nearly_flat > 0;
    item.taken_back = straightened ? 1 : 2;
    item.raw.mesh = item.drawn;
    item.nearly_flat = item.in_triangles = 0;
    part_warped(item);
    if (straightened) return true;
    if (!is_plane(item.raw.mesh, spec_of(item).snap)) return false;
    std::size_t parted = 0;
    item.raw.mesh = geometry::with_parted_faces(item.raw.mesh, 0.1 * kConvex * geometry::diagonal(item.raw.mesh), parted);
    item.in_triangles += parted;
    return parted > 0;
  }

  /// Adjusts the planes of all stones; sets aside those that cannot be made to fit.
  std::vector<geometry::RoughSolid> flat_solids() {
    for (int refused = 0;; ++refused) {
      std::vector<geometry::RoughSolid> solids;
      for (const Item& item : items_) solids.push_back({item.raw.mesh, spec_of(item).snap, spec_of(item).gap});
      try {
        flattened_ = geometry::flatten(solids, case_.base ? std::optional(case_.base->z) : std::nullopt);
        return solids;
      } catch (const geometry::ModelError& e) {
        const auto at_fault = static_cast<std::size_t>(std::max(0, e.subject()));
        if (take_back(at_fault)) {
          --refused;
          continue;
        }
        set_aside(at_fault, without_subject(e));
      }
      if (refused < kMostRefused) continue;
      items_.clear();  // too many are at fault to examine the rest
      flattened_.clear();
      return {};
    }
  }

  void put_together() {
    std::vector<geometry::RoughSolid> solids = flat_solids();
    for (std::size_t i = 0; i < items_.size(); ++i) take_flat(i, std::move(solids[i].mesh));
  }

  static Mesh merged_exactly(const Mesh& m) { return geometry::with_merged_faces(m, kConvex * geometry::diagonal(m), 1e-3); }

  void take_flat(std::size_t i, Mesh mesh) {
    if (flattened_[i].moved > 0.0) {
      const std::size_t before = mesh.faces.size();
      mesh = merged_exactly(mesh);
      items_[i].nearly_flat += before - mesh.faces.size();
    }
    items_[i].raw.mesh = std::move(mesh);
  }

  /// Flattens one stone. \throw ModelError as geometry::flatten
  void flatten_alone(std::size_t i) {
    std::vector<geometry::RoughSolid> one = {{items_[i].raw.mesh, spec_of(items_[i]).snap, spec_of(items_[i]).gap}};
    flattened_[i] = geometry::flatten(one, std::nullopt).front();
    take_flat(i, std::move(one.front().mesh));
  }

  void cut(Item& item) const {
    CutStone done = cut_stone(item.raw.mesh, spec_of(item).snap);
    item.pieces = std::move(done.pieces);
    item.dents = done.dents;
  }

  void cut_into_pieces(std::size_t i) {
    for (bool again = false;;) {
      try {
        if (again) flatten_alone(i);
        cut(items_[i]);
        return;
      } catch (const geometry::ModelError& e) {
        again = take_back(i);
        if (!again) return set_aside(i, without_subject(e));
      }
    }
  }

  /// Cuts apart stones that overlap by no more than snap.
  void part() {
    std::vector<geometry::DrawnPiece> drawn;
    for (std::size_t i = 0; i < items_.size(); ++i) {
      for (Polyhedron& p : items_[i].pieces) drawn.push_back({std::move(p), static_cast<std::int32_t>(i), spec_of(items_[i]).snap});
      items_[i].pieces.clear();
    }
    const auto depth = geometry::part_overlaps(drawn, case_.base ? std::optional(case_.base->z) : std::nullopt);
    for (std::size_t k = 0; k < drawn.size(); ++k) {
      Item& item = nth(items_, drawn[k].solid);
      item.pieces.push_back(depth[k] > 0.0 ? geometry::in_prism_order(drawn[k].shape) : std::move(drawn[k].shape));
      item.parted = std::max(item.parted, depth[k]);
    }
  }

  void finish(std::size_t i) {
    Item& item = items_[i];
    cases::Stone stone;
    stone.name = item.raw.name;
    stone.groups = std::move(item.raw.groups);
    stone.fixed = item.raw.support;
    for (Polyhedron& p : item.pieces) stone.pieces.push_back({std::move(p), {}});
    for (cases::StonePiece& piece : stone.pieces) piece.beds = beds_of(piece.shape, flattened_[i].beds);
    stone.change = change_of(item, flattened_[i], stone.pieces.size(), inner_law(item));
    case_.stones[item.table].stones.push_back(std::move(stone));
  }

  static std::vector<std::int32_t> beds_of(const Polyhedron& shape, const std::vector<geometry::HalfSpace>& beds) {
    std::vector<std::int32_t> out;
    for (std::size_t f = 0; !beds.empty() && f < shape.faces.size(); ++f) {
      const geometry::FacePlane plane = geometry::face_plane(shape, static_cast<int>(f));
      const auto is_on = [&](const geometry::HalfSpace& h) {
        return dot(h.normal, plane.normal) > 1.0 - 1e-9 && std::abs(dot(h.normal, plane.centroid) - h.offset) < 1e-7;
      };
      if (std::any_of(beds.begin(), beds.end(), is_on)) out.push_back(static_cast<std::int32_t>(f));
    }
    return out;
  }

  /// Name of the law between pieces of a stone; empty: they never part.
  [[nodiscard]] std::string inner_law(const Item& item) const {
    const auto& materials = case_.materials;
    const std::string& name = spec_of(item).material;
    const auto material = name.empty() ? materials.begin() : materials.find(name);
    return material != materials.end() && material->second.inside ? *material->second.inside : "";
  }

  cases::Case& case_;
  std::vector<Item> items_;
  std::vector<geometry::Flattened> flattened_;
  std::vector<StoneFault> faults_;
};

}  // namespace

void load_stones(cases::Case& c) { Import(c).load(); }

std::vector<ShownFault> load_shown_stones(cases::Case& c) { return Import(c).load_shown(); }

}  // namespace voussoir::io
