// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/solids/face_groups.h"

#include <algorithm>
#include <cmath>

#include "geometry/disjoint_sets.h"
#include "geometry/grid.h"
#include "geometry/nth.h"

namespace voussoir::geometry {

namespace {

constexpr double kExact = 5e-7;      // m and rad, half of the tolerances of find_contacts
constexpr double kLeastArea = 1e-8;  // m2, as find_contacts

/// Two faces in contact or across a bed.
struct Pair {
  std::size_t a, b;
  bool exact;
};

class Finder {
 public:
  Finder(std::span<const RoughSolid> solids, const RoughFaces& faces) : solids_(solids), faces_(faces) {}

  void find() {
    std::vector<Box3> boxes;
    double most = 0.0;
    for (const RoughSolid& s : solids_) {
      boxes.push_back(box_of(s.mesh));
      most = std::max(most, s.snap + s.gap.value_or(0.0));
    }
    UniformGrid grid;
    grid.build(boxes);
    const Vec3 margin{most, most, most};
    std::vector<std::int32_t> near;
    for (std::size_t i = 0; i < solids_.size(); ++i) {
      near.clear();
      grid.query({boxes[i].low - margin, boxes[i].high + margin}, near);
      for (const std::int32_t j : near) {
        if (static_cast<std::size_t>(j) > i) try_solids(i, static_cast<std::size_t>(j));
      }
    }
  }

  std::vector<Pair> contacts, beds;

 private:
  void try_solids(std::size_t i, std::size_t j) {
    const RoughSolid &a = solids_[i], &b = solids_[j];
    const double snap = std::max(a.snap, b.snap);
    const bool bedded = a.gap && a.gap == b.gap;
    const double gap = bedded ? *a.gap : 0.0;
    for (std::size_t f = faces_.first[i]; f < faces_.first[i + 1]; ++f) {
      for (std::size_t g = faces_.first[j]; g < faces_.first[j + 1]; ++g) {
        const auto near = facing(faces_.face[f], faces_.face[g], snap + gap);
        if (!near || !(near->area > kLeastArea)) continue;
        const bool exact = near->high <= kExact && near->low >= -kExact && near->tilt <= kExact;
        const bool wide = near->width > snap;
        if (exact || (wide && near->high <= snap && near->low >= -snap)) {
          contacts.push_back({f, g, exact});
        } else if (bedded && wide && near->high <= gap + snap && near->low >= gap - snap) {
          beds.push_back({f, g, false});
        }
      }
    }
  }

  std::span<const RoughSolid> solids_;
  const RoughFaces& faces_;
};

/// Position of a face with the normal −z relative to the base. \return 0: not within snap, 1: near, 2: on the base
int on_base(const RoughSolid& solid, const FlatFace& f, double base_z) {
  if (norm(f.plane.normal + Vec3{0, 0, 1}) > 0.05) return 0;
  double most = 0.0;
  for (const Point2 p : f.polygon) most = std::max(most, std::abs((f.plane.centre + p.s * f.axis_s + p.t * f.axis_t).z - base_z));
  return most > std::max(solid.snap, kExact) ? 0 : most > kExact ? 1 : 2;
}

}  // namespace

RoughFaces faces_of(std::span<const RoughSolid> solids) {
  RoughFaces out;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    out.first.push_back(out.face.size());
    for (std::size_t f = 0; f < solids[i].mesh.faces.size(); ++f) {
      out.face.push_back(flat_face(solids[i].mesh, f));
      out.solid.push_back(static_cast<std::int32_t>(i));
    }
  }
  out.first.push_back(out.face.size());
  return out;
}

std::vector<FaceGroup> face_groups(std::span<const RoughSolid> solids, const RoughFaces& faces, std::optional<double> base_z) {
  Finder finder(solids, faces);
  finder.find();
  DisjointSets sets(faces.face.size());
  std::vector<std::uint8_t> touches(faces.face.size(), 0), inexact(faces.face.size(), 0), base(faces.face.size(), 0),
      bed(faces.face.size(), 0);
  const auto join = [&](const Pair& p) {
    sets.join(p.a, p.b);
    if (!p.exact) inexact[p.a] = 1;
  };
  for (const Pair& p : finder.contacts) {
    join(p);
    touches[p.a] = touches[p.b] = 1;
  }
  for (std::size_t f = 0; base_z && f < faces.face.size(); ++f) {
    const int near = on_base(nth(solids, faces.solid[f]), faces.face[f], *base_z);
    if (near > 0) touches[f] = base[f] = 1;
    if (near == 1) inexact[f] = 1;
  }
  for (const Pair& p : finder.beds) {
    if (touches[p.a] != 0 || touches[p.b] != 0) continue;
    join(p);
    bed[p.a] = bed[p.b] = 1;
  }
  std::vector<std::int32_t> number(faces.face.size(), -1);
  std::vector<FaceGroup> groups;
  for (std::size_t f = 0; f < faces.face.size(); ++f) {
    if (touches[f] == 0 && bed[f] == 0) continue;
    std::int32_t& n = number[sets.of(f)];
    if (n < 0) {
      n = static_cast<std::int32_t>(groups.size());
      groups.emplace_back();
    }
    FaceGroup& g = nth(groups, n);
    g.faces.push_back(f);
    g.exact = g.exact && inexact[f] == 0;
    g.bed = g.bed || bed[f] != 0;
    g.on_base = g.on_base || base[f] != 0;
  }
  return groups;
}

}  // namespace voussoir::geometry
