// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/solids/pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "geometry/mass.h"
#include "geometry/message.h"
#include "geometry/nth.h"
#include "geometry/solids/folds.h"
#include "geometry/solids/triangles.h"

namespace voussoir::geometry {

namespace {

constexpr std::size_t kMostPieces = 500;
constexpr std::size_t kMostCuts = 20 * kMostPieces;
constexpr double kFills = 1.0;                    // relative error of the total volume, in tolerances of the size
constexpr double kMild = std::numbers::pi / 4.0;  // rad; cuts along faces that turn by less would leave slivers
constexpr int kPerEdge = 1000;                    // score of a plane for each reflex edge that lies in it
constexpr int kSecondChoice = kPerEdge / 2;       // penalty of a cut between two faces that turn by kMild or more
constexpr int kLastChoice = 1'000'000;            // penalty of a cut along a face that turns by less than kMild
constexpr double kNearMiss = 1e-3;                // of the size: a plane this near to a corner, but not through it, cuts off slivers
constexpr double kSameCorner = 10.0;              // tolerances: distance at which two corners are one
constexpr int kMissesCorner = 2 * kPerEdge;       // penalty of a plane that just misses a corner

/// A flat part of the surface within a cell.
struct Patch {
  std::vector<Vec3> corners;
  std::int32_t plane = 0;
};

/// A reflex edge, and the planes that may cut along it, with the penalty of each.
struct ReflexEdge {
  Vec3 from, to;
  struct Cut {
    HalfSpace plane;
    int penalty;
  };
  std::array<Cut, 3> cuts;
};

/// A convex cell, and the parts of the surface within it.
struct Cell {
  Polyhedron shape;
  std::vector<Patch> surface;
};

class Cutting {
 public:
  Cutting(const Mesh& solid, double snap, double tolerance)
      : solid_(solid), size_(diagonal(solid)), tolerance_(tolerance * size_), fills_(kFills * tolerance) {
    for (std::size_t f = 0; f < solid.faces.size(); ++f) plane_.push_back(half_space_of(solid, f));
    for (const Fold& fold : reflex_folds(solid)) add(fold, snap);
  }

  std::vector<Polyhedron> cut() {
    const Box3 box = bounds(Polyhedron{solid_.vertices, {}});
    const Vec3 margin{0.1 * size_, 0.1 * size_, 0.1 * size_};
    Cell all{make_box(box.low - margin, box.high + margin), {}};
    for (std::size_t f = 0; f < solid_.faces.size(); ++f) {
      for (const auto& t : triangles_of(solid_, f)) all.surface.push_back({{t.begin(), t.end()}, number_of_plane(f)});
    }
    std::vector<Cell> open{std::move(all)};
    std::size_t cuts = 0;
    while (!open.empty()) {
      Cell cell = std::move(open.back());
      open.pop_back();
      divide(std::move(cell), open);
      if (open.size() + pieces_.size() > kMostPieces || ++cuts > kMostCuts)
        throw ModelError("takes more than " + std::to_string(kMostPieces) + " convex pieces; simplify it, or part it where it was drawn",
                         -1);
    }
    check_volume();
    return std::move(pieces_);
  }

 private:
  /// The number of the plane of a face: that of the first face in the same plane.
  [[nodiscard]] std::int32_t number_of_plane(std::size_t f) const {
    for (std::size_t g = 0; g < f; ++g) {
      if (dot(plane_[g].normal, plane_[f].normal) > 1.0 - 1e-12 && std::abs(plane_[g].offset - plane_[f].offset) <= tolerance_)
        return static_cast<std::int32_t>(g);
    }
    return static_cast<std::int32_t>(f);
  }

  void add(const Fold& fold, double snap) {
    const bool mild = fold.turn < kMild;
    const int along_face = mild ? kLastChoice : 0;
    edges_.push_back({nth(solid_.vertices, fold.from),
                      nth(solid_.vertices, fold.to),
                      {{{fold.left, along_face}, {fold.right, along_face}, {cut_along(solid_, fold, snap), mild ? 0 : kSecondChoice}}}});
  }

  /// Whether part of an edge is within the cell.
  [[nodiscard]] bool is_in(const ReflexEdge& e, const Cell& cell) const {
    double low = 0.0, high = 1.0;
    for (std::size_t f = 0; f < cell.shape.faces.size(); ++f) {
      const FacePlane plane = face_plane(cell.shape, static_cast<int>(f));
      const double a = dot(e.from - plane.centroid, plane.normal) + 2.0 * tolerance_,
                   b = dot(e.to - plane.centroid, plane.normal) + 2.0 * tolerance_;
      if (a > 0.0 && b > 0.0) return false;
      if (a > 0.0) low = std::max(low, a / (a - b));
      if (b > 0.0) high = std::min(high, a / (a - b));
    }
    return (high - low) * norm(e.to - e.from) > 4.0 * tolerance_;
  }

  [[nodiscard]] bool lies_on(const ReflexEdge& e, const HalfSpace& h) const {
    return std::abs(dot(h.normal, e.from) - h.offset) <= tolerance_ && std::abs(dot(h.normal, e.to) - h.offset) <= tolerance_;
  }

  /// Least and greatest height of the corners of a patch above a plane [m].
  static std::pair<double, double> span_over(const Patch& p, const HalfSpace& h) {
    double low = 1e300, high = -1e300;
    for (const Vec3& v : p.corners) {
      const double x = dot(h.normal, v) - h.offset;
      low = std::min(low, x), high = std::max(high, x);
    }
    return {low, high};
  }

  /// The plane of a patch that has other patches beyond it; nothing: the solid is convex within the cell.
  [[nodiscard]] const HalfSpace* violated(const Cell& cell) const {
    for (const Patch& p : cell.surface) {
      const HalfSpace& h = nth(plane_, p.plane);
      for (const Patch& q : cell.surface) {
        if (q.plane != p.plane && span_over(q, h).second > tolerance_) return &h;
      }
    }
    return nullptr;
  }

  [[nodiscard]] bool just_misses_corner(const Cell& cell, const HalfSpace& h) const {
    for (const Patch& p : cell.surface) {
      for (const Vec3& v : p.corners) {
        const double off = std::abs(dot(h.normal, v) - h.offset);
        if (off > tolerance_ && off < kNearMiss * size_) return true;
      }
    }
    return false;
  }

  /// Whether a plane leaves parts of the cell on both sides.
  [[nodiscard]] bool splits(const Cell& cell, const HalfSpace& h) const {
    double low = 0.0, high = 0.0;
    for (const Vec3& v : cell.shape.vertices) {
      const double x = dot(h.normal, v) - h.offset;
      low = std::min(low, x), high = std::max(high, x);
    }
    return low < -tolerance_ && high > tolerance_;
  }

  /// The best plane to cut along; nothing if no plane leaves parts on both sides, so nothing sticks out by more than the tolerance.
  [[nodiscard]] std::optional<HalfSpace> choose(const Cell& cell, const HalfSpace& otherwise) const {
    std::vector<const ReflexEdge*> in;
    for (const ReflexEdge& e : edges_) {
      if (is_in(e, cell)) in.push_back(&e);
    }
    const HalfSpace* best = nullptr;
    int most = 0;
    for (const ReflexEdge* e : in) {
      for (const ReflexEdge::Cut& c : e->cuts) {
        if (!splits(cell, c.plane)) continue;
        int score = -c.penalty - (just_misses_corner(cell, c.plane) ? kMissesCorner : 0);
        for (const ReflexEdge* other : in) score += lies_on(*other, c.plane) ? kPerEdge : 0;
        for (const Patch& p : cell.surface) {
          const auto [low, high] = span_over(p, c.plane);
          if (low < -tolerance_ && high > tolerance_) --score;
        }
        if (best == nullptr || score > most) best = &c.plane, most = score;
      }
    }
    if (best != nullptr) return *best;
    return splits(cell, otherwise) ? std::optional(otherwise) : std::nullopt;
  }

  void divide(Cell cell, std::vector<Cell>& open) {
    if (cell.shape.faces.empty()) return;
    if (cell.surface.empty()) {
      if (winding_number(solid_, mass_properties(cell.shape).centroid) > 0.5) keep(std::move(cell.shape));
      return;
    }
    const HalfSpace* beyond = violated(cell);
    const std::optional<HalfSpace> cut = beyond == nullptr ? std::nullopt : choose(cell, *beyond);
    if (!cut) {
      for (const Patch& p : cell.surface) {
        cell.shape = clipped(cell.shape, nth(plane_, p.plane), tolerance_);
        if (cell.shape.faces.empty()) return;
      }
      keep(std::move(cell.shape));
      return;
    }
    const HalfSpace& h = *cut;
    const HalfSpace turned{-h.normal, -h.offset};
    Cell below{clipped(cell.shape, h, tolerance_), {}}, above{clipped(cell.shape, turned, tolerance_), {}};
    for (const Patch& p : cell.surface) share_out(p, h, below, above);
    open.push_back(std::move(above));
    open.push_back(std::move(below));
  }

  void share_out(const Patch& p, const HalfSpace& h, Cell& below, Cell& above) const {
    const auto [low, high] = span_over(p, h);
    if (low >= -tolerance_ && high <= tolerance_) {  // in the cut: the patch bounds the side behind it
      (dot(nth(plane_, p.plane).normal, h.normal) > 0.0 ? below : above).surface.push_back(p);
      return;
    }
    if (low < -tolerance_) below.surface.push_back(high > tolerance_ ? part(p, h, 1.0) : p);
    if (high > tolerance_) above.surface.push_back(low < -tolerance_ ? part(p, h, -1.0) : p);
  }

  /// The part of a patch on one side of a plane.
  [[nodiscard]] Patch part(const Patch& p, const HalfSpace& h, double sign) const {
    Patch out{{}, p.plane};
    for (std::size_t i = 0; i < p.corners.size(); ++i) {
      const Vec3 a = p.corners[i], b = p.corners[(i + 1) % p.corners.size()];
      const double ha = sign * (dot(h.normal, a) - h.offset), hb = sign * (dot(h.normal, b) - h.offset);
      if (ha <= tolerance_) out.corners.push_back(a);
      if ((ha < -tolerance_ && hb > tolerance_) || (ha > tolerance_ && hb < -tolerance_))
        out.corners.push_back(a + (ha / (ha - hb)) * (b - a));
    }
    return out;
  }

  /// Replaces corners of a piece that lie at corners of the solid by the latter: where four nearly coincident planes meet, clipping gives
  /// several points.
  [[nodiscard]] Polyhedron with_own_corners(Polyhedron shape) const {
    for (Vec3& v : shape.vertices) {
      const Vec3* nearest = nullptr;
      double least = kSameCorner * tolerance_;
      for (const Vec3& own : solid_.vertices) {
        const double apart = norm(own - v);
        if (apart <= least) least = apart, nearest = &own;
      }
      if (nearest != nullptr) v = *nearest;
    }
    Mesh joined = welded({std::move(shape.vertices), std::move(shape.faces)}, 4.0 * tolerance_);
    return {std::move(joined.vertices), std::move(joined.faces)};
  }

  void keep(Polyhedron shape) {
    shape = with_own_corners(std::move(shape));
    if (shape.faces.size() < 4) return;  // a sliver that vanished when its corners were joined
    if (signed_volume(shape) > 1e-12 * size_ * size_ * size_) pieces_.push_back(std::move(shape));
  }

  void check_volume() const {
    double sum = 0.0;
    for (const Polyhedron& p : pieces_) sum += signed_volume(p);
    const double whole = volume(solid_);
    if (std::abs(sum - whole) <= fills_ * whole) return;
    throw ModelError("cannot be cut into convex pieces: they hold " + figure(std::abs(sum - whole)) +
                         (sum > whole ? " m3 more" : " m3 less") + " than its " + figure(whole) +
                         " m3; its surface goes through itself, or has dents too shallow to cut along; mend it where it was drawn, or "
                         "raise stones.snap",
                     -1);
  }

  const Mesh& solid_;
  double size_, tolerance_, fills_;
  std::vector<HalfSpace> plane_;  // by face
  std::vector<ReflexEdge> edges_;
  std::vector<Polyhedron> pieces_;
};

}  // namespace

std::vector<Polyhedron> convex_pieces(const Mesh& solid, double snap, double tolerance) { return Cutting(solid, snap, tolerance).cut(); }

}  // namespace voussoir::geometry
