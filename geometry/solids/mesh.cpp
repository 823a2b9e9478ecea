// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/solids/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "geometry/message.h"
#include "geometry/nth.h"

namespace voussoir::geometry {

namespace {

constexpr double kNoVolume = 1e-9;  // of the diagonal cubed: solids of less volume are refused

using Edge = std::array<std::int32_t, 2>;

template <class Visit>
void for_each_edge(const std::vector<std::int32_t>& loop, Visit visit) {
  for (std::size_t i = 0; i < loop.size(); ++i) visit(Edge{loop[i], loop[(i + 1) % loop.size()]});
}

Vec3 at(const Mesh& m, std::int32_t v) { return nth(m.vertices, v); }

std::string edge_text(const Mesh& m, Edge e) { return "from " + place_text(at(m, e[0])) + " to " + place_text(at(m, e[1])) + " m"; }

/// A copy without vertices that no face uses; the other vertices keep their order.
Mesh compacted(const Mesh& m) {
  std::vector<std::int32_t> number(m.vertices.size(), -1);
  for (const auto& loop : m.faces) {
    for (const std::int32_t v : loop) nth(number, v) = 0;
  }
  Mesh out;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] < 0) continue;
    number[v] = static_cast<std::int32_t>(out.vertices.size());
    out.vertices.push_back(m.vertices[v]);
  }
  out.faces = m.faces;
  for (auto& loop : out.faces) {
    for (std::int32_t& v : loop) v = nth(number, v);
  }
  return out;
}

/// For each vertex, the first vertex within the tolerance of it.
std::vector<std::int32_t> first_of_equals(const Mesh& m, double tolerance) {
  std::vector<std::int32_t> order(m.vertices.size()), first(m.vertices.size());
  std::iota(order.begin(), order.end(), 0);
  std::iota(first.begin(), first.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return at(m, a).x < at(m, b).x; });
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t k = i + 1; k < order.size() && at(m, order[k]).x - at(m, order[i]).x <= tolerance; ++k) {
      if (norm(at(m, order[k]) - at(m, order[i])) > tolerance) continue;
      std::int32_t a = nth(first, order[i]), b = nth(first, order[k]);
      if (a > b) std::swap(a, b);
      nth(first, order[i]) = nth(first, order[k]) = a;
      nth(first, b) = a;
    }
  }
  for (std::size_t v = 0; v < first.size(); ++v) {
    while (nth(first, first[v]) != first[v]) first[v] = nth(first, first[v]);
  }
  return first;
}

/// All directed edges, sorted, with the face of each.
std::vector<std::pair<Edge, std::int32_t>> edges_of(const Mesh& m) {
  std::vector<std::pair<Edge, std::int32_t>> edges;
  for (std::size_t f = 0; f < m.faces.size(); ++f) {
    for_each_edge(m.faces[f], [&](Edge e) { edges.emplace_back(e, static_cast<std::int32_t>(f)); });
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// The face that has a directed edge, or −1. \param edges  result of edges_of
std::int32_t face_with(const std::vector<std::pair<Edge, std::int32_t>>& edges, Edge e) {
  const auto found = std::lower_bound(edges.begin(), edges.end(), std::pair(e, std::int32_t{-1}));
  return found != edges.end() && found->first == e ? found->second : -1;
}

/// Grows regions of faces in one plane.
class Regions {
 public:
  Regions(const Mesh& m, double tolerance, double angle)
      : mesh_(m), tolerance_(tolerance), cosine_(std::cos(angle)), edges_(edges_of(m)), of_(m.faces.size(), -1) {
    for (std::size_t f = 0; f < m.faces.size(); ++f) plane_.push_back(loop_plane(m, f));
    least_area_ = 1e-12 * diagonal(m) * diagonal(m);
  }

  /// The number of the region of each face.
  const std::vector<std::int32_t>& grow() {
    for (const std::int32_t seed : largest_first()) {
      if (nth(of_, seed) < 0) grow_from(seed);
    }
    return of_;
  }

 private:
  /// Faces by descending area. Areas equal up to round-off keep their order, so that the order is the same on every machine.
  [[nodiscard]] std::vector<std::int32_t> largest_first() const {
    std::vector<std::int32_t> faces(mesh_.faces.size());
    std::iota(faces.begin(), faces.end(), 0);
    const auto area = [&](std::int32_t f) { return nth(plane_, f).area; };
    std::ranges::stable_sort(faces, std::greater{}, area);
    for (auto first = faces.begin(); first != faces.end();) {
      const auto last = std::find_if(first, faces.end(), [&](std::int32_t f) { return area(*first) > area(f) * (1.0 + 1e-9); });
      std::sort(first, last);
      first = last;
    }
    return faces;
  }
  void grow_from(std::int32_t seed) {
    std::vector<std::int32_t> front{seed};
    nth(of_, seed) = seed;
    while (!front.empty()) {
      const std::int32_t f = front.back();
      front.pop_back();
      for_each_edge(nth(mesh_.faces, f), [&](Edge e) {
        const std::int32_t other = face_with(edges_, {e[1], e[0]});
        if (other < 0 || nth(of_, other) >= 0 || !lies_in(other, nth(plane_, seed))) return;
        nth(of_, other) = seed;
        front.push_back(other);
      });
    }
  }
  [[nodiscard]] bool lies_in(std::int32_t face, const LoopPlane& plane) const {
    const LoopPlane& own = nth(plane_, face);
    if (own.area > least_area_ && dot(own.normal, plane.normal) < cosine_) return false;
    const auto& loop = nth(mesh_.faces, face);
    return std::all_of(loop.begin(), loop.end(),
                       [&](std::int32_t v) { return std::abs(dot(at(mesh_, v) - plane.centre, plane.normal)) <= tolerance_; });
  }

  const Mesh& mesh_;
  double tolerance_, cosine_, least_area_ = 0.0;
  std::vector<std::pair<Edge, std::int32_t>> edges_;
  std::vector<LoopPlane> plane_;
  std::vector<std::int32_t> of_;
};

/// The boundary of a region as one loop; empty if it is not one simple loop.
std::vector<std::int32_t> rim(const Mesh& m, const std::vector<std::int32_t>& faces) {
  std::vector<Edge> edges;
  for (const std::int32_t f : faces) for_each_edge(nth(m.faces, f), [&](Edge e) { edges.push_back(e); });
  std::sort(edges.begin(), edges.end());
  std::vector<Edge> outer;
  for (const Edge e : edges) {
    if (!std::binary_search(edges.begin(), edges.end(), Edge{e[1], e[0]})) outer.push_back(e);
  }
  for (std::size_t i = 1; i < outer.size(); ++i) {
    if (outer[i][0] == outer[i - 1][0]) return {};
  }
  std::vector<std::int32_t> loop;
  if (outer.empty()) return loop;
  std::int32_t v = nth(m.faces, faces.front()).front();  // start with the first corner of the first face, if on the boundary
  if (!std::binary_search(outer.begin(), outer.end(), Edge{v, -1}, [](Edge a, Edge b) { return a[0] < b[0]; })) v = outer.front()[0];
  const std::int32_t first = v;
  do {
    loop.push_back(v);
    const auto next = std::lower_bound(outer.begin(), outer.end(), Edge{v, -1});
    if (next == outer.end() || (*next)[0] != v || loop.size() > outer.size()) return {};
    v = (*next)[1];
  } while (v != first);
  return loop.size() == outer.size() ? loop : std::vector<std::int32_t>{};
}

/// Removes vertices that only two faces have from both: they lie within an edge.
void drop_vertices_within_edges(Mesh& m) {
  std::vector<int> faces(m.vertices.size(), 0);
  for (const auto& loop : m.faces) {
    for (const std::int32_t v : loop) ++nth(faces, v);
  }
  for (auto& loop : m.faces) {
    const auto kept = std::count_if(loop.begin(), loop.end(), [&](std::int32_t v) { return nth(faces, v) > 2; });
    if (kept < 3) return;
  }
  for (auto& loop : m.faces) std::erase_if(loop, [&](std::int32_t v) { return nth(faces, v) <= 2; });
}

}  // namespace

std::string place_text(Vec3 v) {
  const auto part = [](double x) { return figure(std::abs(x) < 5e-7 ? 0.0 : x); };
  return "(" + part(v.x) + ", " + part(v.y) + ", " + part(v.z) + ")";
}

Box3 box_of(const Mesh& m) { return bounds(Polyhedron{m.vertices, {}}); }

double diagonal(const Mesh& m) {
  const Box3 box = box_of(m);
  return norm(box.high - box.low);
}

LoopPlane loop_plane(const Mesh& m, std::size_t face) {
  const auto& loop = m.faces[face];
  const Vec3 first = at(m, loop.front());
  Vec3 doubled, sum;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3 a = at(m, loop[i]) - first, b = at(m, loop[(i + 1) % loop.size()]) - first;
    doubled += cross(a, b);
    sum += a;
  }
  const double length = norm(doubled);
  return {length > 0.0 ? normalised(doubled) : Vec3{}, first + sum / static_cast<double>(loop.size()), 0.5 * length};
}

double warp(const Mesh& m, std::size_t face) {
  const LoopPlane plane = loop_plane(m, face);
  double most = 0.0;
  for (const std::int32_t v : m.faces[face]) most = std::max(most, std::abs(dot(at(m, v) - plane.centre, plane.normal)));
  return most;
}

double volume(const Mesh& m) {
  const Vec3 origin = m.vertices.front();
  double six = 0.0;
  for (const auto& loop : m.faces) {
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
      six += dot(at(m, loop[0]) - origin, cross(at(m, loop[i]) - origin, at(m, loop[i + 1]) - origin));
  }
  return six / 6.0;
}

Mesh welded(const Mesh& m, double tolerance) {
  const std::vector<std::int32_t> first = first_of_equals(m, tolerance);
  Mesh out{m.vertices, {}};
  for (const auto& given : m.faces) {
    std::vector<std::int32_t> loop;
    for (const std::int32_t v : given) {
      if (loop.empty() || loop.back() != nth(first, v)) loop.push_back(nth(first, v));
    }
    while (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
    if (loop.size() >= 3) out.faces.push_back(std::move(loop));
  }
  return compacted(out);
}

Mesh without_doubled_faces(const Mesh& m) {
  std::set<std::vector<std::int32_t>> known;
  Mesh out{m.vertices, {}};
  for (const auto& loop : m.faces) {
    std::vector<std::int32_t> from_least = loop;
    std::rotate(from_least.begin(), std::min_element(from_least.begin(), from_least.end()), from_least.end());
    if (known.insert(std::move(from_least)).second) out.faces.push_back(loop);
  }
  return out;
}

std::size_t turn_outward(Mesh& m) {
  struct Side {
    std::int32_t face;
    bool forward;  // along the edge from its lower to its higher corner
  };
  std::map<Edge, std::vector<Side>> sides;
  for (std::size_t f = 0; f < m.faces.size(); ++f)
    for_each_edge(m.faces[f], [&](Edge e) {
      sides[{std::min(e[0], e[1]), std::max(e[0], e[1])}].push_back({static_cast<std::int32_t>(f), e[0] < e[1]});
    });
  if (std::ranges::any_of(sides, [](const auto& s) { return s.second.size() != 2; })) return 0;
  std::vector<int> turned(m.faces.size(), -1);  // -1: not reached yet
  for (std::size_t first = 0; first < m.faces.size(); ++first) {
    if (turned[first] >= 0) continue;
    std::vector<std::int32_t> front{static_cast<std::int32_t>(first)};
    turned[first] = 0;
    while (!front.empty()) {
      const std::int32_t f = front.back();
      front.pop_back();
      for_each_edge(nth(m.faces, f), [&](Edge e) {
        const std::vector<Side>& pair = sides[{std::min(e[0], e[1]), std::max(e[0], e[1])}];
        const Side &one = pair[0], &two = pair[1], &other = one.face == f ? two : one;
        if (nth(turned, other.face) >= 0) return;
        nth(turned, other.face) = one.forward == two.forward ? 1 - nth(turned, f) : nth(turned, f);
        front.push_back(other.face);
      });
    }
  }
  const auto turn = [&](std::size_t f) { std::reverse(m.faces[f].begin() + 1, m.faces[f].end()); };  // from the same corner
  for (std::size_t f = 0; f < m.faces.size(); ++f)
    if (turned[f] == 1) turn(f);
  if (volume(m) < 0.0) {
    for (std::size_t f = 0; f < m.faces.size(); ++f) turn(f), turned[f] = 1 - turned[f];
  }
  return static_cast<std::size_t>(std::ranges::count(turned, 1));
}

std::optional<std::string> fault_of(const Mesh& m) {
  if (m.faces.empty()) return "has no faces";
  const auto edges = edges_of(m);
  std::size_t open = 0, turned = 0;
  Edge first_open{}, first_turned{};
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Edge e = edges[i].first;
    if (i > 0 && edges[i - 1].first == e) {
      if (turned++ == 0) first_turned = e;
    } else if (face_with(edges, {e[1], e[0]}) < 0 && (i + 1 == edges.size() || edges[i + 1].first != e)) {
      if (open++ == 0) first_open = e;
    }
  }
  const auto count = [](std::size_t n) { return std::to_string(n) + (n == 1 ? " edge" : " edges"); };
  if (turned > 0)
    return "has faces that are turned against their neighbours, or more than two at one edge: " + count(turned) + ", the first " +
           edge_text(m, first_turned) + "; make the normals of its faces agree, and part what touches along an edge only";
  if (open > 0)
    return "is open: " + count(open) + " of one face only, the first " + edge_text(m, first_open) + "; close it where it was drawn";
  const double size = diagonal(m), v = volume(m);
  if (!(std::abs(v) > kNoVolume * size * size * size))
    return "has no volume: " + figure(v) + " m3 in a box of " + figure(size) + " m across, at " + place_text(m.vertices.front()) +
           " m; leave it out, or give it thickness";
  if (v < 0.0)
    return "is inside out: its volume is " + figure(v) + " m3, at " + place_text(m.vertices.front()) +
           " m; turn its faces round (flip the normals)";
  return std::nullopt;
}

Mesh with_merged_faces(const Mesh& m, double tolerance, double angle) {
  const std::vector<std::int32_t> of = Regions(m, tolerance, angle).grow();
  std::vector<std::vector<std::int32_t>> members(m.faces.size());
  for (std::size_t f = 0; f < of.size(); ++f) nth(members, of[f]).push_back(static_cast<std::int32_t>(f));
  Mesh out{m.vertices, {}};
  std::vector<bool> done(m.faces.size(), false);
  for (std::size_t f = 0; f < of.size(); ++f) {
    const auto region = static_cast<std::size_t>(of[f]);
    const auto& faces = members[region];
    if (faces.size() == 1) {
      out.faces.push_back(m.faces[f]);
      continue;
    }
    if (done[region]) continue;
    done[region] = true;
    if (auto loop = rim(m, faces); !loop.empty()) {
      out.faces.push_back(std::move(loop));
    } else {
      for (const std::int32_t g : faces) out.faces.push_back(nth(m.faces, g));
    }
  }
  if (out.faces.size() == m.faces.size()) return m;
  drop_vertices_within_edges(out);
  return compacted(out);
}

bool is_convex(const Mesh& m, double tolerance) {
  for (std::size_t f = 0; f < m.faces.size(); ++f) {
    const LoopPlane plane = loop_plane(m, f);
    for (const Vec3& v : m.vertices) {
      if (dot(v - plane.centre, plane.normal) > tolerance) return false;
    }
  }
  return true;
}

}  // namespace voussoir::geometry
