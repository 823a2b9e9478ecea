// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/segments/touching.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "geometry/grid.h"
#include "geometry/message.h"
#include "geometry/nth.h"
#include "geometry/parallel/ranges.h"
#include "geometry/solids/mesh.h"
#include "geometry/solids/overlaps.h"

namespace voussoir::geometry {

namespace {

constexpr double kNormalTolerance = 1e-6;  // of n_a + n_b
constexpr double kGapTolerance = 1e-6;     // m, between planes; anything deeper counts as blocks that overlap
constexpr double kLeastArea = 1e-8;        // m2
constexpr double kLeastWidth = 2e-6;       // m, of the overlap: corners a micrometre apart share no joint

/// Distance of the plane of b from the plane of a at a point of the overlap [m].
double gap_at(const PlacedGrid& a, const PlacedGrid& b, Point2 at) {
  const Vec3 point = (a.origin - b.origin) + at.s * a.grid->axis_s + at.t * a.grid->axis_t;
  return std::abs(dot(point, b.grid->normal));
}

/// Upper bound of the distance of the corners of a face from its origin [m].
double reach(const FaceGrid& g) { return g.width + g.height; }

/// Greatest distance between two corners [m].
double longest(const Polygon& p) {
  double most = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) most = std::max(most, std::hypot(p[i].s - p[k].s, p[i].t - p[k].t));
  }
  return most;
}

std::optional<Contact> touch(const PlacedGrid& face_a, const PlacedGrid& face_b) {
  const FaceGrid &a = *face_a.grid, &b = *face_b.grid;
  const Vec3 tilt = a.normal + b.normal;
  if (dot(tilt, tilt) > kNormalTolerance * kNormalTolerance) return std::nullopt;
  const double slack = kNormalTolerance * (reach(a) + reach(b));
  if (std::abs(dot(face_b.origin - face_a.origin, a.normal)) > kGapTolerance + slack) return std::nullopt;

  Contact contact;
  contact.map = plane_map(face_a, face_b);
  Polygon other;
  other.reserve(b.polygon.size());
  // The reflection reverses the loop.
  for (auto p = b.polygon.rbegin(); p != b.polygon.rend(); ++p) other.push_back(contact.map.to_a(*p));
  contact.overlap = intersection(a.polygon, other);
  if (contact.overlap.empty()) return std::nullopt;
  // Corners go back on the raster, from which clipping moved them by round-off, so that a rectangle is recognised as one again.
  const double quantum = std::min(a.quantum, b.quantum);
  for (Point2& p : contact.overlap) p = {snapped(p.s, quantum), snapped(p.t, quantum)};
  const Region shared = region(contact.overlap);
  if (!(shared.area > kLeastArea) || gap_at(face_a, face_b, shared.centroid) > kGapTolerance) return std::nullopt;
  if (!(shared.area > kLeastWidth * longest(contact.overlap))) return std::nullopt;
  contact.area = shared.area;
  return contact;
}

std::span<const PlacedGrid> grids_of(const Scene& scene, std::int32_t element) {
  const Element& e = nth(scene.elements, element);
  return scene.grids.subspan(static_cast<std::size_t>(e.first_face), static_cast<std::size_t>(e.face_count));
}

void touch_elements(const Scene& scene, std::int32_t i, std::int32_t j, std::vector<Contact>& out) {
  const auto faces_i = grids_of(scene, i), faces_j = grids_of(scene, j);
  for (std::size_t fi = 0; fi < faces_i.size(); ++fi) {
    for (std::size_t fj = 0; fj < faces_j.size(); ++fj) {
      auto contact = touch(faces_i[fi], faces_j[fj]);
      if (!contact) continue;
      contact->element_a = i, contact->face_a = static_cast<std::int32_t>(fi);
      contact->element_b = j, contact->face_b = static_cast<std::int32_t>(fj);
      out.push_back(*std::move(contact));
    }
  }
}

/// Two elements that overlap.
struct Overlap {
  std::int32_t a, b;
  double depth;  // m
};

void find_overlap(const Scene& scene, std::int32_t i, std::int32_t j, std::vector<Overlap>& out) {
  const double depth = penetration(scene, i, j, kGapTolerance);
  if (depth > kGapTolerance) out.push_back({i, j, depth});
}

/// Reports the deepest overlap. \throw ModelError if there is any
void refuse_overlaps(const Scene& scene, const std::vector<Overlap>& all) {
  if (all.empty()) return;
  const Overlap& o = *std::max_element(all.begin(), all.end(), [](const Overlap& a, const Overlap& b) { return a.depth < b.depth; });
  const auto shape = [&](std::int32_t e) -> const Polyhedron& { return *nth(scene.parts, e).shape; };
  const std::size_t more = all.size() - 1;
  throw ModelError(
      block_prefix(o.a) + "overlaps block " + std::to_string(o.b) + " by " + figure(o.depth) + " m (allowed " + figure(kGapTolerance) +
          " m) about " + place_text(middle_of_overlap(shape(o.a), shape(o.b))) + " m" +
          (more == 0 ? "" : " (" + std::to_string(more) + (more == 1 ? " more pair overlaps" : " more pairs overlap") + " less)"),
      o.a, o.b);
}

void touch_base(const Scene& scene, std::int32_t i, double base_z, std::vector<Contact>& out) {
  const double low = nth(scene.boxes, i).low.z;
  if (low < base_z - kGapTolerance) {
    throw ModelError(block_prefix(i) + "reaches " + figure(base_z - low) + " m below the base (its lowest point is at z = " + figure(low) +
                         " m, the base at " + figure(base_z) + " m)",
                     i);
  }
  if (low > base_z + kGapTolerance) return;
  const auto faces = grids_of(scene, i);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const FaceGrid& g = *faces[f].grid;
    const Region whole = region(g.polygon);
    const double z = faces[f].origin.z + whole.centroid.s * g.axis_s.z + whole.centroid.t * g.axis_t.z;
    if (norm(g.normal + Vec3{0, 0, 1}) > kNormalTolerance || std::abs(z - base_z) > kGapTolerance) continue;
    out.push_back({i, static_cast<std::int32_t>(f), kBase, -1, {}, g.polygon, whole.area});
  }
}

bool in_order(const Contact& x, const Contact& y) {
  const auto key = [](const Contact& c) { return std::array{c.element_a, c.face_a, c.element_b, c.face_b}; };
  return key(x) < key(y);
}

/// Finds contacts of element i with the base and with elements of higher index. \param near  scratch memory
void meet_neighbours(const Scene& scene, std::optional<double> base_z, const UniformGrid& grid, std::int32_t i,
                     std::vector<std::int32_t>& near, std::vector<Contact>& out, std::vector<Overlap>& overlaps) {
  const auto first = static_cast<std::ptrdiff_t>(out.size());
  const bool ground = nth(scene.parts, i).ground;
  if (base_z && !ground) touch_base(scene, i, *base_z, out);
  const Box3& box = nth(scene.boxes, i);
  const Vec3 margin{2 * kGapTolerance, 2 * kGapTolerance, 2 * kGapTolerance};
  near.clear();
  grid.query({box.low - margin, box.high + margin}, near);
  for (const std::int32_t j : near) {
    if (j <= i || (ground && nth(scene.parts, j).ground)) continue;
    find_overlap(scene, i, j, overlaps);
    touch_elements(scene, i, j, out);
  }
  std::sort(out.begin() + first, out.end(), in_order);
}

}  // namespace

PlaneMap plane_map(const PlacedGrid& face_a, const PlacedGrid& face_b) {
  const FaceGrid &a = *face_a.grid, &b = *face_b.grid;
  constexpr double kAligned = 1e-13;
  PlaneMap m;
  m.c = dot(b.axis_s, a.axis_s), m.s = dot(b.axis_s, a.axis_t);
  if (std::abs(m.c) < kAligned) m.c = 0.0;
  if (std::abs(m.s) < kAligned) m.s = 0.0;
  const double length = std::hypot(m.c, m.s);
  m.c /= length, m.s /= length;
  const Vec3 between = face_b.origin - face_a.origin;
  const double quantum = std::min(a.quantum, b.quantum);
  m.shift = {snapped(dot(between, a.axis_s), quantum), snapped(dot(between, a.axis_t), quantum)};
  return m;
}

std::vector<Contact> find_contacts(const Scene& scene, std::optional<double> base_z) {
  UniformGrid grid;
  grid.build(scene.boxes);
  struct Found {
    std::vector<Contact> contacts;
    std::vector<Overlap> overlaps;
  };
  std::vector<Found> found(range_count(scene.elements.size()));
  for_ranges(scene.elements.size(), scene.threads, [&](std::size_t range, std::size_t first, std::size_t last) {
    Found mine;
    std::vector<std::int32_t> near;
    for (std::size_t i = first; i < last; ++i)
      meet_neighbours(scene, base_z, grid, static_cast<std::int32_t>(i), near, mine.contacts, mine.overlaps);
    found[range] = std::move(mine);
  });
  std::size_t count = 0;
  for (const Found& f : found) count += f.contacts.size();
  std::vector<Contact> out;
  out.reserve(count);
  std::vector<Overlap> overlaps;
  for (Found& f : found) {
    std::ranges::move(f.contacts, std::back_inserter(out));
    overlaps.insert(overlaps.end(), f.overlaps.begin(), f.overlaps.end());
    f = {};
  }
  refuse_overlaps(scene, overlaps);
  return out;
}

}  // namespace voussoir::geometry
