// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "geometry/mass.h"
#include "geometry/message.h"
#include "geometry/nth.h"
#include "geometry/polyhedron.h"

namespace voussoir::geometry {

namespace {

constexpr double kTolerance = 1e-9;         // of the size: planeness and convexity
constexpr double kRoundOff = 1e-15;         // of the distance to the global origin
constexpr double kVolumeTolerance = 1e-12;  // of the size cubed

[[noreturn]] void fail(int subject, const std::string& what) { throw ModelError(block_prefix(subject) + what, subject); }

void check_vertices(const Polyhedron& p, int subject) {
  if (p.vertices.size() < 4) fail(subject, "fewer than 4 vertices: " + std::to_string(p.vertices.size()));
  for (std::size_t i = 0; i < p.vertices.size(); ++i) {
    const Vec3 v = p.vertices[i];
    if (std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z)) continue;
    fail(subject, "vertex " + std::to_string(i) + " is not finite: (" + figure(v.x) + ", " + figure(v.y) + ", " + figure(v.z) + ")");
  }
}

/// Throws if two corners coincide: a surface could then run round twice and still be closed and convex.
void check_apart(const Polyhedron& p, double allowed, int subject) {
  for (std::size_t i = 0; i < p.vertices.size(); ++i) {
    for (std::size_t k = i + 1; k < p.vertices.size(); ++k) {
      if (norm(p.vertices[k] - p.vertices[i]) > allowed) continue;
      fail(subject, "vertices " + std::to_string(i) + " and " + std::to_string(k) + " coincide");
    }
  }
}

void check_loops(const Polyhedron& p, int subject) {
  const auto count = static_cast<std::int32_t>(p.vertices.size());
  std::vector<bool> used(p.vertices.size(), false);
  if (p.faces.size() < 4) fail(subject, "fewer than 4 faces: " + std::to_string(p.faces.size()));
  for (std::size_t f = 0; f < p.faces.size(); ++f) {
    const auto& loop = p.faces[f];
    const std::string name = "face " + std::to_string(f);
    if (loop.size() < 3) fail(subject, name + " has fewer than 3 corners: " + std::to_string(loop.size()));
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (loop[i] < 0 || loop[i] >= count) {
        fail(subject, name + " uses vertex " + std::to_string(loop[i]) + ", there are " + std::to_string(count));
      }
      if (std::find(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(i), loop[i]) !=
          loop.begin() + static_cast<std::ptrdiff_t>(i)) {
        fail(subject, name + " uses vertex " + std::to_string(loop[i]) + " twice");
      }
      nth(used, loop[i]) = true;
    }
  }
  const auto unused = std::find(used.begin(), used.end(), false);
  if (unused != used.end()) fail(subject, "a vertex is used by no face: vertex " + std::to_string(unused - used.begin()));
}

/// Throws unless every edge is used once in each direction.
void check_closed(const Polyhedron& p, int subject) {
  std::vector<std::array<std::int32_t, 2>> edges, turned;
  for (const auto& loop : p.faces) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::int32_t a = loop[i], b = loop[(i + 1) % loop.size()];
      edges.push_back({a, b});
      turned.push_back({b, a});
    }
  }
  std::sort(edges.begin(), edges.end());
  std::sort(turned.begin(), turned.end());
  const auto doubled = std::adjacent_find(edges.begin(), edges.end());
  if (doubled != edges.end() || edges != turned) {
    const auto at = doubled != edges.end() ? doubled : std::mismatch(edges.begin(), edges.end(), turned.begin()).first;
    fail(subject, "not closed: the edge from vertex " + std::to_string((*at)[0]) + " to " + std::to_string((*at)[1]) +
                      " does not separate two faces of one orientation");
  }
}

void check_planes(const Polyhedron& p, double size, double allowed, int subject) {
  for (std::size_t f = 0; f < p.faces.size(); ++f) {
    const FacePlane plane = face_plane(p, static_cast<int>(f));
    if (!(plane.area > kVolumeTolerance * size * size)) {
      fail(subject, "face " + std::to_string(f) + " has no area: " + figure(plane.area) + " m2");
    }
    for (const std::int32_t i : p.faces[f]) {
      const double gap = std::abs(dot(nth(p.vertices, i) - plane.centroid, plane.normal));
      if (gap <= allowed) continue;
      fail(subject, "a face is not plane: vertex " + std::to_string(i) + " lies " + figure(gap) + " m off face " + std::to_string(f) +
                        " (allowed " + figure(allowed) + " m)");
    }
  }
}

void check_convex(const Polyhedron& p, double allowed, int subject) {
  for (std::size_t f = 0; f < p.faces.size(); ++f) {
    const FacePlane plane = face_plane(p, static_cast<int>(f));
    for (std::size_t i = 0; i < p.vertices.size(); ++i) {
      const double out = dot(p.vertices[i] - plane.centroid, plane.normal);
      if (out <= allowed) continue;
      fail(subject, "not convex: vertex " + std::to_string(i) + " lies " + figure(out) + " m outside face " + std::to_string(f) +
                        " (allowed " + figure(allowed) + " m)");
    }
  }
}

}  // namespace

void validate(const Polyhedron& p, int subject) {
  check_vertices(p, subject);
  check_loops(p, subject);
  check_closed(p, subject);
  const Box3 box = bounds(p);
  const double size = norm(box.high - box.low);
  const double volume = signed_volume(p);
  // The sign of the volume is checked first: if the shape is inside out, every vertex lies outside every face.
  if (!(std::abs(volume) > kVolumeTolerance * size * size * size)) fail(subject, "zero volume: " + figure(volume) + " m3");
  if (volume < 0.0) fail(subject, "inside out: the volume is " + figure(volume) + " m3");
  // Coordinates far from the origin are coarser than the tolerance of a small block.
  const double allowed = kTolerance * size + kRoundOff * (norm(box.low) + norm(box.high));
  check_apart(p, allowed, subject);
  check_planes(p, size, allowed, subject);
  check_convex(p, allowed, subject);
}

}  // namespace voussoir::geometry
