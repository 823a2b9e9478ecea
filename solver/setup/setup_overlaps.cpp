// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <tuple>

#include "cases/model.h"
#include "geometry/nth.h"
#include "solver/setup/setup.h"

namespace voussoir::solver {

namespace {

// Of a segment. Under the rule of centres points lie half a segment inside the edge: a little less, so that what rests on such a contact is
// no deeper than half a segment. Under that of the rim points see all but edges that cross, and free ones lie a hundredth inside. With
// contact.restitution an edge or a corner is to push where it is, not where the points beside it are.
constexpr double kAllowed = 0.45, kLittleAllowed = 0.04;
constexpr double kSameDirection = 1e-9;  // sine between edges that are parallel

/// From the centroid, in multiples of 2^-40 m, so that equal bricks have equal shapes.
Vec3 rounded(Vec3 r) {
  constexpr double kGrid = 0x1p40;
  return {std::round(r.x * kGrid) / kGrid, std::round(r.y * kGrid) / kGrid, std::round(r.z * kGrid) / kGrid};
}

using Key = std::vector<std::tuple<double, double, double>>;  // vertices, then normals of faces

Key key_of(const std::vector<Vec3>& vertices, std::span<const kernels::Face> faces) {
  Key key;
  for (const Vec3& v : vertices) key.emplace_back(v.x, v.y, v.z);
  for (const kernels::Face& f : faces) key.emplace_back(f.normal.x, f.normal.y, f.normal.z), key.emplace_back(f.distance, 0.0, 0.0);
  return key;
}

std::vector<Vec3> edge_directions(const geometry::Polyhedron& p) {
  std::vector<Vec3> out;
  for (const auto& loop : p.faces) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec3 edge = normalised(nth(p.vertices, loop[(i + 1) % loop.size()]) - nth(p.vertices, loop[i]));
      if (std::ranges::none_of(out, [&](Vec3 o) { return norm(cross(o, edge)) < kSameDirection; })) out.push_back(edge);
    }
  }
  return out;
}

/// Every edge with its two faces.
std::vector<kernels::Crease> creases(const geometry::Polyhedron& p) {
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> open;  // from one vertex to another: the face on their left
  std::vector<kernels::Crease> out;
  for (std::size_t f = 0; f < p.faces.size(); ++f) {
    const auto& loop = p.faces[f];
    const auto face = static_cast<std::int32_t>(f);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::int32_t from = loop[i], to = loop[(i + 1) % loop.size()];
      const auto other = open.find({to, from});
      if (other == open.end()) {
        open[{from, to}] = face;
        continue;
      }
      const Vec3 along = normalised(nth(p.vertices, to) - nth(p.vertices, from));
      out.push_back({.direction = along, .vertex = from, .left = face, .right = other->second});
    }
  }
  return out;
}

bool is_small(const geometry::Polyhedron& p) { return kernels::is_small(p.faces.size(), p.vertices.size()); }

/// Where what belongs to a shape begins, until all are there and lie still.
struct Range {
  std::size_t vertices, vertex_count, edges, edge_count, creases, crease_count, first_face, face_count;
};

template <class T>
void append(std::vector<T>& to, const std::vector<T>& what) {
  to.insert(to.end(), what.begin(), what.end());
}

/// Which pairs have a joint, and its sides.
void list_joined_pairs(World& w) {
  Overlaps& o = w.overlaps;
  std::vector<std::array<std::int32_t, 3>> all;  // the lower element, the other, the side
  for (std::int64_t id = 0; id < w.sides.count(); ++id) {
    if (nth(w.sides.joint, id) < 0) continue;
    const kernels::Side s = w.sides.side(id);
    all.push_back({std::min(s.master, s.slave), std::max(s.master, s.slave), static_cast<std::int32_t>(id)});
  }
  std::ranges::sort(all);
  o.first_side.assign(static_cast<std::size_t>(w.elements.count) + 1, 0);
  o.joined_to.reserve(all.size()), o.side.reserve(all.size());
  for (const auto& [a, b, side] : all) {
    ++o.first_side[static_cast<std::size_t>(a) + 1];
    o.joined_to.push_back(b), o.side.push_back(side);
  }
  std::partial_sum(o.first_side.begin(), o.first_side.end(), o.first_side.begin());
}

}  // namespace

void set_up_overlaps(World& w) {
  list_joined_pairs(w);
  Overlaps& o = w.overlaps;
  const cases::Model& m = w.model;
  const bool all_small = std::ranges::all_of(m.blocks, [](const cases::Block& b) { return is_small(b.shape); });
  std::map<Key, std::int32_t> known;
  std::vector<Range> ranges;
  for (std::size_t i = 0; i < m.blocks.size(); ++i) {
    const geometry::Polyhedron& shape = m.blocks[i].shape;
    std::vector<Vec3> vertices;
    for (const Vec3& v : shape.vertices) vertices.push_back(rounded(v - m.assembly.elements[i].mass.centroid));
    const auto first = static_cast<std::size_t>(w.elements.first_face[i]), count = static_cast<std::size_t>(w.elements.face_count[i]);
    const auto [at, is_new] =
        known.try_emplace(key_of(vertices, std::span(w.faces).subspan(first, count)), static_cast<std::int32_t>(ranges.size()));
    o.shape_of.push_back(at->second);
    if (!is_new) continue;
    const std::vector<Vec3> edges = is_small(shape) ? edge_directions(shape) : std::vector<Vec3>{};
    const std::vector<kernels::Crease> folds = all_small ? std::vector<kernels::Crease>{} : creases(shape);
    ranges.push_back({o.vertices.size(), vertices.size(), o.edges.size(), edges.size(), o.creases.size(), folds.size(), first, count});
    append(o.vertices, vertices), append(o.edges, edges), append(o.creases, folds);
  }
  for (const Range& r : ranges) {
    o.shape.push_back({.vertices = std::span(o.vertices).subspan(r.vertices, r.vertex_count),
                       .edges = std::span(o.edges).subspan(r.edges, r.edge_count),
                       .faces = std::span<const kernels::Face>(w.faces).subspan(r.first_face, r.face_count),
                       .creases = std::span(o.creases).subspan(r.creases, r.crease_count)});
  }
  const bool little = m.assembly.rule != geometry::SegmentRule::centres || w.contact.restitution > 0.0;
  const double allowed = little ? kLittleAllowed : kAllowed;
  // A cube of the same volume, between its centroid and a face (Eq. 1 over that face): 2 E' V^(1/3).
  for (std::size_t i = 0; i < m.blocks.size(); ++i) {
    if (m.blocks[i].ground >= 0) {
      o.stiffness_n.push_back(0.0), o.stiffness_s.push_back(0.0), o.allowed.push_back(0.0);
      continue;
    }
    const cases::Material& material = nth(m.materials, m.blocks[i].material).value;
    const double edge = std::cbrt(m.assembly.elements[i].mass.volume);
    o.stiffness_n.push_back(2.0 * edge * material.young / (1.0 - material.poisson * material.poisson));
    o.stiffness_s.push_back(edge * material.young / (1.0 + material.poisson));
    o.allowed.push_back(allowed * m.blocks[i].segment_size + (w.contact.crushing.on() ? w.contact.crushing.depth : 0.0));
  }
}

}  // namespace voussoir::solver
