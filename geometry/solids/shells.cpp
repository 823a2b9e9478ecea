// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/solids/shells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/disjoint_sets.h"
#include "geometry/nth.h"

namespace voussoir::geometry {

namespace {

/// One use of an edge by a face, its ends in ascending order.
struct Use {
  std::int32_t low, high;
  std::size_t face;
  bool forward;  // the face runs from low to high
};

class Shells {
 public:
  explicit Shells(const Mesh& m) : mesh_(m), shells_(m.faces.size()) {
    for (std::size_t f = 0; f < m.faces.size(); ++f) normal_.push_back(loop_plane(m, f).normal);
  }

  std::vector<Mesh> part() {
    std::vector<Use> uses;
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
      const auto& loop = mesh_.faces[f];
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const std::int32_t a = loop[i], b = loop[(i + 1) % loop.size()];
        uses.push_back({std::min(a, b), std::max(a, b), f, a < b});
      }
    }
    std::stable_sort(uses.begin(), uses.end(),
                     [](const Use& x, const Use& y) { return x.low < y.low || (x.low == y.low && x.high < y.high); });
    for (std::size_t first = 0; first < uses.size();) {
      std::size_t end = first;
      while (end < uses.size() && uses[end].low == uses[first].low && uses[end].high == uses[first].high) ++end;
      pair_up(std::vector<Use>(uses.begin() + static_cast<std::ptrdiff_t>(first), uses.begin() + static_cast<std::ptrdiff_t>(end)));
      first = end;
    }
    return meshes();
  }

 private:
  /// Unit direction from the edge into the face, in the plane of the face.
  [[nodiscard]] Vec3 inward(const Use& u, Vec3 along) const { return cross(normal_[u.face], u.forward ? along : -along); }

  void pair_up(const std::vector<Use>& uses) {
    if (uses.size() == 2) return shells_.join(uses[0].face, uses[1].face);
    const Vec3 edge = nth(mesh_.vertices, uses[0].high) - nth(mesh_.vertices, uses[0].low);
    const double length = norm(edge);
    if (!(length > 0.0)) return;
    const Vec3 along = edge / length;
    for (const Use& u : uses) {
      const Vec3 from = inward(u, along), behind = -normal_[u.face];
      const Use* next = nullptr;
      double least = 1e300;
      for (const Use& other : uses) {
        if (other.forward == u.forward) continue;
        const Vec3 to = inward(other, along);
        double angle = std::atan2(dot(to, behind), dot(to, from));
        if (angle < 1e-6) angle += 2.0 * std::numbers::pi;  // a coincident face of a neighbour counts as a full turn away
        if (angle < least) least = angle, next = &other;
      }
      if (next != nullptr) shells_.join(u.face, next->face);
    }
  }

  std::vector<Mesh> meshes() {
    std::vector<std::int32_t> number(mesh_.faces.size(), -1);
    std::vector<Mesh> out;
    std::vector<std::vector<std::int32_t>> place;  // by shell: sorted numbers of its vertices in the whole mesh
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
      std::int32_t& n = number[shells_.of(f)];
      if (n < 0) {
        n = static_cast<std::int32_t>(out.size());
        out.emplace_back();
        place.emplace_back();
      }
      const auto& loop = mesh_.faces[f];
      nth(out, n).faces.push_back(loop);
      auto& vertices = nth(place, n);
      vertices.insert(vertices.end(), loop.begin(), loop.end());
    }
    for (std::size_t i = 0; i < out.size(); ++i) {
      auto& vertices = place[i];
      std::sort(vertices.begin(), vertices.end());
      vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
      for (const std::int32_t v : vertices) out[i].vertices.push_back(nth(mesh_.vertices, v));
      for (auto& loop : out[i].faces) {
        for (std::int32_t& v : loop)
          v = static_cast<std::int32_t>(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin());
      }
    }
    return out;
  }

  const Mesh& mesh_;
  DisjointSets shells_;  // of faces
  std::vector<Vec3> normal_;
};

}  // namespace

std::vector<Mesh> shells(const Mesh& m) { return Shells(m).part(); }

}  // namespace voussoir::geometry
