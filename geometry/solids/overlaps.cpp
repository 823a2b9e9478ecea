// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/solids/overlaps.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "geometry/grid.h"
#include "geometry/mass.h"
#include "geometry/nth.h"
#include "geometry/separation.h"
#include "geometry/solids/facing.h"
#include "geometry/solids/pieces.h"

namespace voussoir::geometry {

namespace {

constexpr double kTouching = 0.9e-6;  // m; below the 1e-6 that find_contacts takes as touching
constexpr double kOnPlane = 1e-9;     // of the size, the tolerance of validate() for plane faces
constexpr double kApart = 2e-6;       // m, distance beyond which nothing touches
constexpr double kMostLost = 0.5;     // of a piece's volume: greater losses are refused as no mere correction

double size_of(const Polyhedron& p) {
  const Box3 box = bounds(p);
  return norm(box.high - box.low);
}

double lowest(const Polyhedron& p, Vec3 axis) {
  double least = 1e300;
  for (const Vec3& v : p.vertices) least = std::min(least, dot(v, axis));
  return least;
}

HalfSpace turned(const HalfSpace& h) { return {-h.normal, -h.offset}; }

bool meet(const Box3& a, const Box3& b, double margin) {
  return a.low.x <= b.high.x + margin && b.low.x <= a.high.x + margin && a.low.y <= b.high.y + margin && b.low.y <= a.high.y + margin &&
         a.low.z <= b.high.z + margin && b.low.z <= a.high.z + margin;
}

HalfSpace deeper(HalfSpace h) {
  h.offset -= kApart;
  return h;
}

/// Width of the strip that two pieces share on a plane [m]; 0: they share none.
double width_of_strip(const Polyhedron& a, const Polyhedron& b) {
  const Mesh first{a.vertices, a.faces}, second{b.vertices, b.faces};
  double widest = 0.0;
  for (std::size_t f = 0; f < a.faces.size(); ++f) {
    for (std::size_t g = 0; g < b.faces.size(); ++g) {
      const auto near = facing(flat_face(first, f), flat_face(second, g), kTouching);
      if (near && near->tilt < 1e-6) widest = std::max(widest, near->width);
    }
  }
  return widest;
}

/// The part of a piece in a half-space; nothing if that part is no solid, or less than half of the piece.
std::optional<Polyhedron> kept(const Polyhedron& p, const HalfSpace& h) {
  Polyhedron out = clipped(p, h, kOnPlane * size_of(p));
  if (out.faces.empty()) return std::nullopt;
  try {
    validate(out);
  } catch (const ModelError&) {
    return std::nullopt;
  }
  if (signed_volume(out) < (1.0 - kMostLost) * signed_volume(p)) return std::nullopt;
  return out;
}

/// A way to separate two pieces: the half-spaces that the pieces are cut to.
struct Cut {
  std::optional<HalfSpace> first, second;
  double depth = 0.0;  // m, of the overlap along the cut's normal
  int lost = 0;        // contacts with third pieces
};

class Parting {
 public:
  Parting(std::span<DrawnPiece> pieces, std::optional<double> base_z) : pieces_(pieces), base_z_(base_z), depth_(pieces.size(), 0.0) {
    for (const DrawnPiece& p : pieces) {
      body_.push_back(convex_body(p.shape));
      box_.push_back(bounds(p.shape));
    }
    grid_.build(box_);
  }

  std::vector<double> part() {
    std::vector<std::int32_t> near;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      near.clear();
      grid_.query(box_[i], near);
      for (const std::int32_t j : near) {
        if (static_cast<std::size_t>(j) > i) part_pair(i, static_cast<std::size_t>(j));
      }
    }
    for (std::size_t i = 0; base_z_ && i < pieces_.size(); ++i) {
      const double under = *base_z_ - lowest(pieces_[i].shape, {0, 0, 1});
      if (under > kTouching && under <= pieces_[i].snap) cut(i, {{0, 0, -1}, -*base_z_}, under);
    }
    return depth_;
  }

 private:
  void part_pair(std::size_t i, std::size_t j) {
    const double snap = std::max(pieces_[i].snap, pieces_[j].snap);
    if (pieces_[i].solid == pieces_[j].solid || snap <= kTouching) return;
    const Penetration least = penetration_of(body_[i], body_[j], kTouching);
    if (least.depth <= kTouching || least.depth > snap) return;
    std::vector<Cut> cuts = along_faces(i, j, snap);
    if (cuts.empty() || cuts.front().depth > least.depth + kTouching) cuts.push_back(between_edges(i, least));
    for (Cut& c : cuts) c.lost = (c.first ? contacts_lost(i, j, *c.first) : 0) + (c.second ? contacts_lost(j, i, *c.second) : 0);
    std::stable_sort(cuts.begin(), cuts.end(),
                     [](const Cut& a, const Cut& b) { return std::tie(a.lost, a.depth) < std::tie(b.lost, b.depth); });
    for (const Cut& c : cuts) {
      if (apply(i, j, c)) return;
    }
  }

  /// Cuts along the faces of either piece, the shallowest first.
  [[nodiscard]] std::vector<Cut> along_faces(std::size_t i, std::size_t j, double snap) const {
    std::vector<Cut> cuts;
    for (const HalfSpace& f : body_[i].faces) {
      const double depth = f.offset - lowest(pieces_[j].shape, f.normal);
      if (depth <= snap) cuts.push_back({{}, turned(f), depth, 0});
    }
    for (const HalfSpace& f : body_[j].faces) {
      const double depth = f.offset - lowest(pieces_[i].shape, f.normal);
      if (depth <= snap) cuts.push_back({turned(f), {}, depth, 0});
    }
    std::stable_sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.depth < b.depth; });
    return cuts;
  }

  /// Cut of both pieces at half the depth, across the axis. \pre moving the second piece along the axis separates the two
  [[nodiscard]] Cut between_edges(std::size_t i, const Penetration& p) const {
    const double top = -lowest(pieces_[i].shape, -p.axis), middle = top - 0.5 * p.depth;
    return {HalfSpace{p.axis, middle}, HalfSpace{-p.axis, -middle}, p.depth, 0};
  }

  /// Number of third pieces that touch faces which a cut of piece i would remove entirely.
  [[nodiscard]] int contacts_lost(std::size_t i, std::size_t other, const HalfSpace& cut) const {
    int lost = 0;
    for (std::size_t f = 0; f < pieces_[i].shape.faces.size(); ++f) {
      const auto& loop = pieces_[i].shape.faces[f];
      const auto is_gone = [&](std::int32_t v) { return dot(cut.normal, nth(pieces_[i].shape.vertices, v)) >= cut.offset - kTouching; };
      if (std::all_of(loop.begin(), loop.end(), is_gone)) lost += against(i, f, other);
    }
    return lost;
  }

  [[nodiscard]] int against(std::size_t i, std::size_t face, std::size_t other) const {
    const HalfSpace& h = body_[i].faces[face];
    Polyhedron corners;
    for (const std::int32_t v : pieces_[i].shape.faces[face]) corners.vertices.push_back(nth(pieces_[i].shape.vertices, v));
    const Box3 box = bounds(corners);
    std::vector<std::int32_t> near;
    grid_.query(box, near);
    int found = 0;
    for (const std::int32_t n : near) {
      const auto k = static_cast<std::size_t>(n);
      if (k == i || k == other || pieces_[k].solid == pieces_[i].solid || !meet(box, box_[k], kTouching)) continue;
      found += std::any_of(body_[k].faces.begin(), body_[k].faces.end(), [&](const HalfSpace& g) {
        return norm(g.normal + h.normal) < 1e-6 && std::abs(g.offset + h.offset) < kTouching;
      });
    }
    return found;
  }

  bool apply(std::size_t i, std::size_t j, const Cut& c) {
    std::optional<Polyhedron> first = c.first ? kept(pieces_[i].shape, *c.first) : std::nullopt;
    std::optional<Polyhedron> second = c.second ? kept(pieces_[j].shape, *c.second) : std::nullopt;
    if ((c.first && !first) || (c.second && !second)) return false;
    const double width = width_of_strip(first ? *first : pieces_[i].shape, second ? *second : pieces_[j].shape);
    if (width > 0.0 && width <= std::max(pieces_[i].snap, pieces_[j].snap) && is_held(i, j) && is_held(j, i)) {
      std::optional<Polyhedron>& shorter = first ? first : second;
      if (auto apart = kept(pieces_[first ? i : j].shape, deeper(first ? *c.first : *c.second))) shorter = std::move(apart);
    }
    if (first) take(i, *first, c.depth);
    if (second) take(j, *second, c.depth);
    return true;
  }

  /// Whether a piece touches any piece other than `other`.
  [[nodiscard]] bool is_held(std::size_t i, std::size_t other) const {
    for (std::size_t f = 0; f < body_[i].faces.size(); ++f) {
      if (against(i, f, other) > 0 || is_on_base(body_[i].faces[f])) return true;
    }
    return false;
  }
  [[nodiscard]] bool is_on_base(const HalfSpace& f) const {
    return base_z_ && norm(f.normal + Vec3{0, 0, 1}) < 1e-6 && std::abs(f.offset + *base_z_) < kTouching;
  }

  void cut(std::size_t i, const HalfSpace& h, double depth) {
    if (const auto left = kept(pieces_[i].shape, h)) take(i, *left, depth);
  }

  void take(std::size_t i, const Polyhedron& shape, double depth) {
    pieces_[i].shape = shape;
    body_[i] = convex_body(shape);
    depth_[i] = std::max(depth_[i], depth);
  }

  std::span<DrawnPiece> pieces_;
  std::optional<double> base_z_;
  std::vector<ConvexBody> body_;
  std::vector<Box3> box_;  // bounding boxes as drawn; cut pieces lie within
  std::vector<double> depth_;
  UniformGrid grid_;
};

}  // namespace

std::vector<double> part_overlaps(std::span<DrawnPiece> pieces, std::optional<double> base_z) { return Parting(pieces, base_z).part(); }

Vec3 middle_of_overlap(const Polyhedron& a, const Polyhedron& b) {
  const Box3 p = bounds(a), q = bounds(b);
  const Vec3 low{std::max(p.low.x, q.low.x), std::max(p.low.y, q.low.y), std::max(p.low.z, q.low.z)};
  const Vec3 high{std::min(p.high.x, q.high.x), std::min(p.high.y, q.high.y), std::min(p.high.z, q.high.z)};
  Polyhedron shared = a;
  for (const HalfSpace& f : convex_body(b).faces) {
    shared = clipped(shared, f, kOnPlane * size_of(a));
    if (shared.faces.size() < 4) return 0.5 * (low + high);
  }
  return signed_volume(shared) > 0.0 ? mass_properties(shared).centroid : 0.5 * (low + high);
}

}  // namespace voussoir::geometry
