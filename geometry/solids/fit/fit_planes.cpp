// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/solids/fit/fit_planes.h"

#include <algorithm>
#include <cmath>

#include "geometry/grid.h"
#include "geometry/nth.h"
#include "geometry/prism.h"
#include "geometry/solids/fit/fit_cells.h"
#include "geometry/solids/fit/fit_contacts.h"
#include "geometry/solids/fit/half_spaces.h"
#include "geometry/solids/overlaps.h"

namespace voussoir::geometry {

namespace {

constexpr double kTouching = 9e-7;        // m: overlaps that count as contact
constexpr std::size_t kMostFaces = 4096;  // of a piece that is fitted

Box3 grown(Box3 box, double by) {
  const Vec3 all{by, by, by};
  return {box.low - all, box.high + all};
}

class Fit {
 public:
  Fit(std::span<const FitStone> stones, std::optional<double> base_z) : stones_(stones), base_z_(base_z), work_(faces_of(stones)) {
    for (std::size_t s = 0; s < stones.size(); ++s) {
      for (const Polyhedron& p : stones[s].pieces) {
        bodies_.push_back(body_of(p, static_cast<std::int32_t>(s)));
        drawn_.push_back(&p);
      }
    }
  }

  std::vector<FittedStone> fit() {
    find_contacts();
    choose_planes(bodies_, contacts_, base_z_);
    for (std::size_t i = 0; i < bodies_.size(); ++i) shape(i);
    part_by_faces();
    part_midway();
    return report();
  }

 private:
  static std::size_t faces_of(std::span<const FitStone> stones) {
    std::size_t faces = 0;
    for (const FitStone& s : stones) {
      for (const Polyhedron& p : s.pieces) faces += p.faces.size();
    }
    return faces;
  }

  FitBody body_of(const Polyhedron& p, std::int32_t stone) const {
    FitBody b;
    b.body = convex_body(p);
    for (std::size_t f = 0; f < p.faces.size(); ++f) b.faces.push_back(flat_face({p.vertices, p.faces}, f));
    b.box = bounds(p);
    b.stone = stone, b.limit = nth(stones_, stone).limit, b.snap = nth(stones_, stone).snap;
    return b;
  }

  /// How deep two bodies are in each other; 0 or less: they are apart.
  /// \param stone  of a
  Penetration overlap(const ConvexBody& a, const ConvexBody& b, std::int32_t stone) {
    const auto n = [](const auto& list) { return static_cast<double>(list.size()); };
    work_.add((n(a.faces) + n(b.faces) + n(a.directions) * n(b.directions)) * (n(a.vertices) + n(b.vertices)), stone);
    return penetration_of(a, b, 0.0);
  }

  static bool meet(const Box3& a, const Box3& b) {
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y && a.low.z < b.high.z && b.low.z < a.high.z;
  }

  void find_contacts() {
    std::vector<Box3> boxes;
    for (const FitBody& b : bodies_) boxes.push_back(grown(b.box, b.limit + kTouching));
    UniformGrid grid;
    grid.build(boxes);
    std::vector<std::int32_t> near;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      near.clear();
      grid.query(boxes[i], near);
      const auto a = static_cast<std::int32_t>(i);
      for (const std::int32_t b : near)
        if (b > a) add_pair(a, b);
      if (base_z_) {
        for (FitContact& c : base_contacts_of(bodies_, a, *base_z_)) contacts_.push_back(std::move(c));
      }
    }
  }

  void add_pair(std::int32_t a, std::int32_t b) {
    const FitBody &first = nth(bodies_, a), &second = nth(bodies_, b);
    work_.add(20.0 * static_cast<double>(first.faces.size() * second.faces.size()), first.stone);
    const bool inner = first.stone == second.stone;
    const double depth = !inner && meet(first.box, second.box) ? overlap(first.body, second.body, first.stone).depth : 0.0;
    for (FitContact& c : contacts_of(bodies_, a, b, depth)) {
      if (!inner)
        contacts_.push_back(std::move(c));
      else if (c.exact)
        inner_.push_back(std::move(c));
    }
  }

  void shape(std::size_t i) {
    if (shares_.empty()) collect_shares();
    const Polyhedron& drawn = *drawn_[i];
    if (std::none_of(shares_[i].begin(), shares_[i].end(), [](const Share& s) { return !s.keeps; })) {
      shapes_.push_back({drawn});
      return;
    }
    if (drawn.faces.size() > kMostFaces) throw ModelError("has too many faces to be fitted", bodies_[i].stone);
    std::vector<FaceShare> asked;
    for (const Share& s : shares_[i]) asked.push_back(s.share);
    std::vector<Polyhedron> out;
    for (const auto& planes : fitted_cells(bodies_[i].body.faces, asked, work_, bodies_[i].stone)) {
      Polyhedron p = common_part(planes, grown(bodies_[i].box, 3.0 * bodies_[i].limit + kTouching));
      if (!p.faces.empty()) out.push_back(std::move(p));
    }
    shapes_.push_back(std::move(out));
  }

  struct Share {
    FaceShare share;
    bool keeps = false;  // the face stays where it is
  };

  void collect_shares() {
    shares_.resize(bodies_.size());
    for (const FitContact& c : contacts_) {
      std::vector<Vec3> middle;
      for (std::size_t k = 0; k < c.on_a.size(); ++k) {
        const Vec3 v = 0.5 * (c.on_a[k] + c.on_b[k]);
        middle.push_back(v - (dot(c.plane.normal, v) - c.plane.offset) * c.plane.normal);
      }
      add_share(c.a, c.face_a, c.plane, middle, c.exact);
      if (c.b >= 0) add_share(c.b, c.face_b, {-c.plane.normal, -c.plane.offset}, middle, c.exact);
    }
    for (const FitContact& c : inner_) {
      add_share(c.a, c.face_a, nth(nth(bodies_, c.a).body.faces, c.face_a), c.on_a, true);
      add_share(c.b, c.face_b, nth(nth(bodies_, c.b).body.faces, c.face_b), c.on_b, true);
    }
  }

  void add_share(std::int32_t body, std::int32_t face, const HalfSpace& plane, const std::vector<Vec3>& area, bool keeps) {
    nth(shares_, body).push_back({{static_cast<std::size_t>(face), plane, area}, keeps});
  }

  struct Part {
    std::size_t body, piece;
    ConvexBody shape;
  };

  /// Counts the work of comparing all pieces that are near each other.
  void count_comparisons(const std::vector<DrawnPiece>& pieces) {
    std::vector<Box3> boxes;
    for (const DrawnPiece& p : pieces) boxes.push_back(bounds(p.shape));
    UniformGrid grid;
    grid.build(boxes);
    std::vector<std::int32_t> near;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      near.clear();
      grid.query(boxes[i], near);
      const auto edges = static_cast<double>(pieces[i].shape.vertices.size() + pieces[i].shape.faces.size());
      for (const std::int32_t k : near) {
        const Polyhedron& other = nth(pieces, k).shape;
        if (nth(pieces, k).solid != pieces[i].solid)
          work_.add(0.2 * edges * static_cast<double>(other.vertices.size() + other.faces.size()) *
                        (edges + static_cast<double>(other.vertices.size())),
                    pieces[i].solid);
      }
    }
  }

  /// Parts stones that overlap by no more than their limits where this costs the fewest contacts.
  void part_by_faces() {
    std::vector<DrawnPiece> pieces;
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      for (Polyhedron& p : shapes_[i]) pieces.push_back({std::move(p), bodies_[i].stone, bodies_[i].limit});
    }
    count_comparisons(pieces);
    const std::vector<double> depth = geometry::part_overlaps(pieces, base_z_);
    std::size_t next = 0;
    for (auto& of_body : shapes_) {
      for (Polyhedron& p : of_body) {
        p = depth[next] > 0.0 ? in_prism_order(pieces[next].shape) : std::move(pieces[next].shape);
        ++next;
      }
    }
  }

  /// Cuts midway what still overlaps. All cuts are found before the first is made, so their order does not matter.
  void part_midway() {
    std::vector<Part> parts;
    std::vector<Box3> boxes;
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      for (std::size_t k = 0; k < shapes_[i].size(); ++k) {
        parts.push_back({i, k, convex_body(shapes_[i][k])});
        boxes.push_back(bounds(shapes_[i][k]));
      }
    }
    std::vector<std::vector<HalfSpace>> cuts(parts.size());
    UniformGrid grid;
    grid.build(boxes);
    std::vector<std::int32_t> near;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (base_z_ && boxes[i].low.z < *base_z_ - kTouching) cuts[i].push_back({{0, 0, -1}, -*base_z_});
      near.clear();
      grid.query(boxes[i], near);
      for (const std::int32_t n : near) {
        const auto k = static_cast<std::size_t>(n);
        if (k > i && meet(boxes[i], boxes[k])) cut_midway(parts[i], parts[k], cuts[i], cuts[k]);
      }
    }
    for (std::size_t i = 0; i < parts.size(); ++i) {
      for (const HalfSpace& h : cuts[i]) {
        Polyhedron& p = shapes_[parts[i].body][parts[i].piece];
        if (!p.faces.empty()) p = part_under(p, h);
      }
    }
    for (auto& pieces : shapes_) std::erase_if(pieces, [](const Polyhedron& p) { return p.faces.empty(); });
  }

  void cut_midway(const Part& one, const Part& other, std::vector<HalfSpace>& of_a, std::vector<HalfSpace>& of_b) {
    const ConvexBody &a = one.shape, &b = other.shape;
    const Penetration p = overlap(a, b, bodies_[one.body].stone);
    if (p.depth <= kTouching) return;
    double high = -1e300, low = 1e300;
    for (const Vec3& v : a.vertices) high = std::max(high, dot(p.axis, v));
    for (const Vec3& v : b.vertices) low = std::min(low, dot(p.axis, v));
    const double middle = 0.5 * (high + low);
    of_a.push_back({p.axis, middle});
    of_b.push_back({-p.axis, -middle});
  }

  std::vector<FittedStone> report() {
    std::vector<FittedStone> out(stones_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      FittedStone& done = nth(out, bodies_[i].stone);
      const bool same =
          shapes_[i].size() == 1 && shapes_[i].front().vertices == drawn_[i]->vertices && shapes_[i].front().faces == drawn_[i]->faces;
      done.changed = done.changed || !same;
      for (Polyhedron& p : shapes_[i]) done.pieces.push_back(std::move(p));
    }
    for (std::size_t s = 0; s < out.size(); ++s) {
      FittedStone& done = out[s];
      done.volume = done.now = volume_of(stones_[s].pieces);
      if (!done.changed) continue;
      done.now = volume_of(done.pieces);
      const Farthest filled = farthest_outside(done.pieces, stones_[s].pieces), cut = farthest_outside(stones_[s].pieces, done.pieces);
      done.moved = std::max(filled.out, cut.out);
      done.where = filled.out > cut.out ? filled.corner : cut.corner;
    }
    return out;
  }

  std::span<const FitStone> stones_;
  std::optional<double> base_z_;
  std::vector<FitBody> bodies_;
  std::vector<const Polyhedron*> drawn_;         // by body
  std::vector<FitContact> contacts_, inner_;     // of different stones; of pieces of one stone
  std::vector<std::vector<Share>> shares_;       // by body
  std::vector<std::vector<Polyhedron>> shapes_;  // by body
  FitWork work_;
};

}  // namespace

std::vector<FittedStone> fit_planes(std::span<const FitStone> stones, std::optional<double> base_z) { return Fit(stones, base_z).fit(); }

}  // namespace voussoir::geometry
