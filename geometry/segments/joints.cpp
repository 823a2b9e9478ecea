// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/segments/joints.h"

#include <algorithm>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "geometry/message.h"
#include "geometry/nth.h"
#include "geometry/parallel/ranges.h"
#include "geometry/segments/rim_points.h"

namespace voussoir::geometry {

namespace {

constexpr double kAreaTolerance = 1e-9;   // relative
constexpr double kPointTolerance = 1e-9;  // m
constexpr double kRaster = 0x1p-40;       // m, raster of the segments' coordinates: equal patches get equal bits
constexpr double kInset = 0.01;           // of a segment, distance of free points from the rim: see FreePatch

/// One side of one contact, listed under the face that masters the side.
struct Side {
  std::int32_t contact = 0;
  bool is_b = false;
};

/// Sides by face, in the order of the contacts.
struct SidesByFace {
  std::vector<std::int32_t> start;
  std::vector<Side> sides;
};

std::size_t face_index(const Scene& scene, std::int32_t element, std::int32_t face) {
  return static_cast<std::size_t>(nth(scene.elements, element).first_face + face);
}

SidesByFace sort_sides(const Scene& scene, std::span<const Contact> contacts) {
  SidesByFace out;
  out.start.assign(scene.grids.size() + 2, 0);
  const auto for_each_side = [&](auto visit) {
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      const Contact& c = contacts[k];
      visit(face_index(scene, c.element_a, c.face_a), Side{static_cast<std::int32_t>(k), false});
      if (c.element_b != kBase) visit(face_index(scene, c.element_b, c.face_b), Side{static_cast<std::int32_t>(k), true});
    }
  };
  for_each_side([&](std::size_t f, Side) { ++out.start[f + 2]; });
  for (std::size_t f = 2; f < out.start.size(); ++f) out.start[f] += out.start[f - 1];
  out.sides.resize(static_cast<std::size_t>(out.start.back()));
  for_each_side([&](std::size_t f, Side s) { nth(out.sides, out.start[f + 1]++) = s; });
  return out;
}

/// Moves segments, given relative to the corner of the face, to coordinates about their area centroid on the raster, and `others` by the
/// same shift. Returns the frame there.
SharedFrame centre_on(const PlacedGrid& face, std::vector<Segment>& segments, std::vector<Segment>& others) {
  double area = 0.0, s = 0.0, t = 0.0;
  for (const Segment& x : segments) area += x.area, s += x.area * x.s, t += x.area * x.t;
  s /= area, t /= area;
  const auto move = [&](std::vector<Segment>& list) {
    for (Segment& x : list) x.s = snapped(x.s - s, kRaster), x.t = snapped(x.t - t, kRaster);
  };
  move(segments);
  move(others);
  const FaceGrid& g = *face.grid;
  return {face.origin + s * g.axis_s + t * g.axis_t, face.grid};
}

void check_sum(const Contact& c, const std::vector<Segment>& side, const char* name) {
  double sum = 0.0;
  for (const Segment& x : side) sum += x.area;
  if (std::abs(sum - c.area) <= kAreaTolerance * c.area) return;
  throw std::logic_error(std::string("segments of side ") + name + " between block " + std::to_string(c.element_a) + " and block " +
                         std::to_string(c.element_b) + " sum to " + figure(sum) + " m2, the overlap is " + figure(c.area) + " m2");
}

bool is_ground(const Scene& scene, std::int32_t element) { return nth(scene.parts, element).ground; }

/// Determines whether the segments of both sides of a joint coincide.
class Matcher {
 public:
  /// Whether both sides have the same points and areas; coordinates are relative to the corner of face a, whose grid is `g`.
  bool coincide(const FaceGrid& g, const std::vector<Segment>& side_a, const std::vector<Segment>& side_b) {
    if (side_a.size() != side_b.size()) return false;
    const auto cells = static_cast<std::size_t>(g.cell_count());
    if (by_cell_.size() < cells) by_cell_.resize(cells, -1);
    for (std::size_t k = 0; k < side_a.size(); ++k) by_cell_[cell_of(g, side_a[k])] = static_cast<std::int32_t>(k);
    const bool all = std::all_of(side_b.begin(), side_b.end(), [&](const Segment& b) {
      const std::int32_t k = by_cell_[cell_of(g, b)];
      return k >= 0 && equal(nth(side_a, k), b);
    });
    for (const Segment& a : side_a) by_cell_[cell_of(g, a)] = -1;
    return all;
  }

 private:
  static std::size_t cell_of(const FaceGrid& g, const Segment& x) {
    const auto column = std::clamp(static_cast<std::int32_t>(x.s / g.cell_width), 0, g.columns - 1);
    const auto row = std::clamp(static_cast<std::int32_t>(x.t / g.cell_height), 0, g.rows - 1);
    return static_cast<std::size_t>(row * g.columns + column);
  }
  static bool equal(const Segment& a, const Segment& b) {
    return std::abs(a.s - b.s) <= kPointTolerance && std::abs(a.t - b.t) <= kPointTolerance &&
           std::abs(a.area - b.area) <= kAreaTolerance * a.area;
  }

  std::vector<std::int32_t> by_cell_;  // segment of a, or −1
};

/// Segments of a joint, relative to the corner of its face a.
struct Draft {
  std::vector<Segment> side_a, side_b;
};

/// Joints between two faces of which only one has been cut. Safe to call from any number of threads at once.
class HalfJoints {
 public:
  /// Keeps the first side of a joint; called for the second side, returns the first.
  std::optional<std::vector<Segment>> meet(std::int32_t contact, std::vector<Segment>& side) {
    const std::scoped_lock hold(lock_);
    const auto [first, is_new] = sides_.try_emplace(contact);
    if (is_new) {
      first->second = std::move(side);
      return std::nullopt;
    }
    std::vector<Segment> other = std::move(first->second);
    sides_.erase(first);
    return other;
  }

  [[nodiscard]] bool empty() const { return sides_.empty(); }

 private:
  std::mutex lock_;
  std::unordered_map<std::int32_t, std::vector<Segment>> sides_;  // by contact
};

/// Cuts faces into the segments of their joints and of the free patches. Keeps scratch memory between faces.
class FaceCutter {
 public:
  /// \param joints  in the order of the contacts; a joint is filled when its only side, or the second of its two, has been cut
  FaceCutter(const Scene& scene, std::span<const Contact> contacts, SegmentRule rule, SegmentStore& store, HalfJoints& halves,
             std::vector<Joint>& joints)
      : scene_(scene), contacts_(contacts), rule_(rule), store_(store), halves_(halves), joints_(joints) {}

  void cut_face(std::int32_t element, std::int32_t face, std::span<const Side> sides) {
    if (is_ground(scene_, element)) return;
    if (rule_ != SegmentRule::centres) {
      cut_face_to_rim(element, face, sides);
      return;
    }
    const PlacedGrid& placed = scene_.grids[face_index(scene_, element, face)];
    const FaceGrid& g = *placed.grid;
    if (!sides.empty()) taken_.assign(static_cast<std::size_t>(g.cell_count()), {});
    for (const Side& side : sides) cut_side(g, side);
    cutter_.cut(g, g.polygon, pieces_);
    if (!sides.empty()) subtract_taken(g);
    merge_small(g, pieces_);  // merges slivers at a slanting edge
    segments_.clear();
    for (const Piece& p : pieces_) segments_.push_back({p.centroid.s, p.centroid.t, p.area});
    add_patch(element, face, placed);
  }

  /// Free patches of all faces cut so far.
  [[nodiscard]] std::vector<FreePatch> take_patches() { return std::move(patches_); }

 private:
  [[nodiscard]] double size_of(std::int32_t element) const { return nth(scene_.parts, element).segment_size; }

  void append_points(const Polygon& polygon, double size, std::vector<Segment>& out) const {
    rule_ == SegmentRule::rim ? append_rim_points(polygon, size, out) : append_corner_points(polygon, out);
  }

  /// Cuts a face under SegmentRule::rim and corners: points of each joint in which the face is face_a, and of convex polygons that make up
  /// its free part.
  void cut_face_to_rim(std::int32_t element, std::int32_t face, std::span<const Side> sides) {
    const PlacedGrid& placed = scene_.grids[face_index(scene_, element, face)];
    const FaceGrid& g = *placed.grid;
    free_.assign(1, g.polygon);
    for (const Side& side : sides) {
      const Contact& c = nth(contacts_, side.contact);
      if (!side.is_b) {
        const double size = c.element_b == kBase ? size_of(c.element_a) : std::min(size_of(c.element_a), size_of(c.element_b));
        Draft draft;
        append_points(c.overlap, size, draft.side_a);
        finish_joint(side.contact, std::move(draft));
      }
      const Polygon& overlap = overlap_on(side);
      cut_.clear();
      for (const Polygon& p : free_) append_difference(p, overlap, cut_);
      free_.swap(cut_);
    }
    segments_.clear();
    for (const Polygon& p : free_) {
      const double area = region(p).area;
      if (area < kSmallPiece * g.cell_area()) continue;
      const Polygon inside = moved_in(p, kInset * size_of(element));
      const std::size_t first = segments_.size();
      append_points(inside, size_of(element), segments_);
      for (std::size_t i = first; i < segments_.size(); ++i) segments_[i].area *= area / region(inside).area;
    }
    add_patch(element, face, placed);
  }

  /// The overlap of the face and another, in coordinates of the face.
  const Polygon& overlap_on(const Side& side) {
    const Contact& c = nth(contacts_, side.contact);
    if (!side.is_b) return c.overlap;
    mapped_.clear();
    for (auto p = c.overlap.rbegin(); p != c.overlap.rend(); ++p) mapped_.push_back(c.map.to_b(*p));
    return mapped_;
  }

  void cut_side(const FaceGrid& g, const Side& side) {
    const Contact& c = nth(contacts_, side.contact);
    cutter_.cut(g, overlap_on(side), pieces_);
    for (const Piece& p : pieces_) {
      Segment& taken = nth(taken_, p.cell);
      taken.area += p.area, taken.s += p.area * p.centroid.s, taken.t += p.area * p.centroid.t;
    }
    merge_small(g, pieces_);
    std::vector<Segment> segments;
    segments.reserve(pieces_.size());
    for (const Piece& p : pieces_) {
      const Point2 at = side.is_b ? c.map.to_a(p.centroid) : p.centroid;
      segments.push_back({at.s, at.t, p.area});
    }
    if (c.element_b == kBase || is_ground(scene_, c.element_b)) {
      finish_joint(side.contact, {std::move(segments), {}});
    } else if (std::optional<std::vector<Segment>> other = halves_.meet(side.contact, segments)) {
      if (side.is_b) segments.swap(*other);
      finish_joint(side.contact, {std::move(segments), *std::move(other)});
    }
  }

  /// Stores a joint all of whose sides have been cut.
  void finish_joint(std::int32_t contact, Draft draft) {
    const Contact& c = nth(contacts_, contact);
    const PlacedGrid& placed = scene_.grids[face_index(scene_, c.element_a, c.face_a)];
    Joint& joint = nth(joints_, contact);
    check_sum(c, draft.side_a, "a");
    if (rule_ != SegmentRule::centres || (c.element_b != kBase && is_ground(scene_, c.element_b))) {
      joint.merged = c.element_b != kBase;  // both elements share the points of side a
    } else if (c.element_b != kBase) {
      check_sum(c, draft.side_b, "b");
      joint.merged = matcher_.coincide(*placed.grid, draft.side_a, draft.side_b);
      if (joint.merged) draft.side_b.clear();
    }
    static_cast<SharedFrame&>(joint) = centre_on(placed, draft.side_a, draft.side_b);
    joint.side_a = store_.keep(draft.side_a), joint.side_b = store_.keep(draft.side_b);
  }

  /// Reduces pieces_ (the whole cells of the face) to the parts that no joint took. The rest of a convex cell need not be convex, so only
  /// its area and first moment are kept.
  void subtract_taken(const FaceGrid& g) {
    const double least = kSmallPiece * g.cell_area();
    for (Piece& p : pieces_) {
      const Segment& taken = nth(taken_, p.cell);
      if (taken.area == 0.0) continue;
      const double rest = p.area - taken.area;
      if (rest >= least) {
        p.centroid = {(p.area * p.centroid.s - taken.s) / rest, (p.area * p.centroid.t - taken.t) / rest};
        p.area = rest;
      } else {
        p.area = 0.0;
      }
    }
    std::erase_if(pieces_, [](const Piece& p) { return p.area == 0.0; });
  }

  /// Adds a patch of segments_, if there are any.
  void add_patch(std::int32_t element, std::int32_t face, const PlacedGrid& placed) {
    if (segments_.empty()) return;
    std::vector<Segment> none;
    const SharedFrame frame = centre_on(placed, segments_, none);
    patches_.push_back({frame, element, face, store_.keep(segments_)});
  }

  const Scene& scene_;
  std::span<const Contact> contacts_;
  SegmentRule rule_;
  SegmentStore& store_;
  HalfJoints& halves_;
  std::vector<Joint>& joints_;
  std::vector<FreePatch> patches_;
  Matcher matcher_;
  Cutter cutter_;
  std::vector<Piece> pieces_;
  std::vector<Segment> taken_;     // by cell: area [m2] and first moments [m3] that joints took
  std::vector<Segment> segments_;  // free segments of the face
  std::vector<Polygon> free_, cut_;
  Polygon mapped_;
};

}  // namespace

void make_joints(const Scene& scene, std::span<const Contact> contacts, Assembly& out) {
  out.joints.reserve(contacts.size());
  for (const Contact& c : contacts) {
    Joint& joint = out.joints.emplace_back();
    joint.element_a = c.element_a, joint.face_a = c.face_a;
    joint.element_b = c.element_b, joint.face_b = c.face_b;
    joint.area = c.area;
  }

  const auto store = std::make_shared<SegmentStore>();
  out.segments = store;
  const SidesByFace by_face = sort_sides(scene, contacts);
  HalfJoints halves;
  std::vector<std::vector<FreePatch>> patches(range_count(scene.elements.size()));
  for_ranges(scene.elements.size(), scene.threads, [&](std::size_t range, std::size_t first, std::size_t last) {
    FaceCutter cutter(scene, contacts, out.rule, *store, halves, out.joints);
    for (std::size_t e = first; e < last; ++e) {
      for (std::int32_t f = 0; f < scene.elements[e].face_count; ++f) {
        const auto face = static_cast<std::size_t>(scene.elements[e].first_face + f);
        const auto begin = static_cast<std::size_t>(by_face.start[face]), end = static_cast<std::size_t>(by_face.start[face + 1]);
        cutter.cut_face(static_cast<std::int32_t>(e), f, std::span(by_face.sides).subspan(begin, end - begin));
      }
    }
    patches[range] = cutter.take_patches();
  });
  if (!halves.empty()) throw std::logic_error("a joint has segments on one of its two faces alone");
  std::size_t count = 0;
  for (const std::vector<FreePatch>& p : patches) count += p.size();
  out.patches.reserve(count);
  for (const std::vector<FreePatch>& p : patches) out.patches.insert(out.patches.end(), p.begin(), p.end());
}

}  // namespace voussoir::geometry
