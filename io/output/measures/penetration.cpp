// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/penetration.h"

#include <algorithm>
#include <utility>

#include "geometry/nth.h"
#include "io/input/files/errors.h"

namespace voussoir::io {
namespace {

constexpr double kTouch = 1e-4;  // m, far above the rounding of positions to float32 in frames

Vec3 vector_at(const std::vector<double>& values, std::size_t i) { return {values[3 * i], values[3 * i + 1], values[3 * i + 2]}; }

std::vector<geometry::ConvexBody> bodies_of(const Hdf5File& run, const std::vector<Pose>& start) {
  const auto first_vertex = run.read<std::int32_t>("/model/element/first_vertex"), face_of = run.read<std::int32_t>("/model/face/element");
  const auto vertex = run.read<double>("/model/vertex");
  const auto normal = run.read<double>("/model/face/normal"), distance = run.read<double>("/model/face/distance");
  if (first_vertex.size() != start.size() || normal.size() != 3 * face_of.size() || distance.size() != face_of.size())
    throw FileError(run.path(), "/model/element does not fit together");
  std::vector<std::vector<Vec3>> vertices(start.size());
  std::vector<std::vector<geometry::HalfSpace>> faces(start.size());
  std::size_t e = 0;
  for (std::size_t v = 0; v < vertex.size() / 3; ++v) {
    while (e + 1 < start.size() && static_cast<std::int64_t>(v) >= first_vertex[e + 1]) ++e;
    vertices[e].push_back(vector_at(vertex, v) - start[e].centre);
  }
  for (std::size_t f = 0; f < face_of.size(); ++f) {
    if (face_of[f] < 0 || static_cast<std::size_t>(face_of[f]) >= start.size())
      throw FileError(run.path(), "/model/face: row " + std::to_string(f) + " belongs to no element");
    nth(faces, face_of[f]).push_back({vector_at(normal, f), distance[f]});
  }
  if (std::ranges::any_of(vertices, [](const auto& v) { return v.empty(); }))
    throw FileError(run.path(), "/model/vertex: an element has no vertices");
  std::vector<geometry::ConvexBody> bodies;
  for (std::size_t i = 0; i < start.size(); ++i) bodies.push_back(geometry::convex_body(std::move(vertices[i]), std::move(faces[i])));
  return bodies;
}

std::vector<double> half_segments(const Hdf5File& run, std::size_t elements) {
  const std::string name = "/model/element/segment_size";
  if (!run.exists(name)) return {};
  std::vector<double> size = run.read<double>(name);
  if (size.size() != elements) throw FileError(run.path(), "/model/element does not fit together");
  for (double& s : size) s *= 0.5;
  return size;
}

geometry::Box3 box_round(const geometry::ConvexBody& body, double wider) {
  geometry::Box3 box{body.vertices.front(), body.vertices.front()};
  for (const Vec3& v : body.vertices) {
    box.low = {std::min(box.low.x, v.x), std::min(box.low.y, v.y), std::min(box.low.z, v.z)};
    box.high = {std::max(box.high.x, v.x), std::max(box.high.y, v.y), std::max(box.high.z, v.z)};
  }
  const Vec3 more{wider, wider, wider};
  return {box.low - more, box.high + more};
}

}  // namespace

InterpenetrationCheck::InterpenetrationCheck(const Hdf5File& run, const Building& building, const std::vector<Pose>& start)
    : body_(bodies_of(run, start)),
      placed_(body_),
      half_segment_(half_segments(run, start.size())),
      fixed_(start.size()),
      has_base_(building.has_base),
      base_(building.base),
      box_(start.size()) {
  for (std::size_t e = 0; e < fixed_.size(); ++e) fixed_[e] = building.mass[e] == 0.0 ? 1 : 0;
}

void InterpenetrationCheck::place_all(const std::vector<Pose>& poses, double wider) {
  for (std::size_t e = 0; e < poses.size(); ++e) {
    geometry::place(body_[e], poses[e].rotation, poses[e].centre, placed_[e]);
    box_[e] = box_round(placed_[e], wider);
  }
  grid_.build(box_);
}

void InterpenetrationCheck::take_base(std::size_t element, Interpenetration& now) const {
  const double depth = geometry::depth_under(placed_[element], base_);
  now.deepest_in_base = std::max(now.deepest_in_base, depth);
  if (depth > now.deepest) now.deepest = depth, now.a = static_cast<std::int32_t>(element), now.b = kBaseBody;
  if (!half_segment_.empty() && depth > half_segment_[element]) ++now.deep_pairs;
}

// Begins with the deepest pair of the frame before, which is likely to be deep again: given its depth, most pairs need no exact depth.
void InterpenetrationCheck::begin_with_last(Interpenetration& now) const {
  if (last_a_ == kBaseBody || last_b_ == kBaseBody) return;
  const double depth = geometry::penetration_of(nth(placed_, last_a_), nth(placed_, last_b_), 0.0).depth;
  if (depth > 0.0) now.deepest = depth, now.a = last_a_, now.b = last_b_;
}

// A pair that is neither the deepest so far nor deep needs no exact depth.
void InterpenetrationCheck::take_pair(std::int32_t a, std::int32_t b, Interpenetration& now) const {
  const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
  const bool known = !half_segment_.empty();
  const double half = known ? std::max(half_segment_[i], half_segment_[j]) : 0.0,
               enough = known ? std::min(half, now.deepest) : now.deepest;
  const double depth = geometry::penetration_of(placed_[i], placed_[j], enough).depth;
  if (depth > now.deepest) now.deepest = depth, now.a = a, now.b = b;
  if (known && depth > half) ++now.deep_pairs;
}

Interpenetration InterpenetrationCheck::at(const std::vector<Pose>& poses) {
  place_all(poses, 0.0);
  Interpenetration now;
  if (half_segment_.empty()) now.deep_pairs = -1;
  begin_with_last(now);
  for (std::size_t e = 0; e < poses.size(); ++e) {
    if (has_base_ && fixed_[e] == 0) take_base(e, now);
    near_.clear();
    grid_.query(box_[e], near_);
    for (const std::int32_t other : near_)
      if (is_pair(e, other)) take_pair(static_cast<std::int32_t>(e), other, now);
  }
  last_a_ = now.a, last_b_ = now.b;
  return now;
}

bool InterpenetrationCheck::touch(std::int32_t a, std::int32_t b) const {
  const geometry::ConvexBody &first = nth(placed_, a), &second = nth(placed_, b);
  return geometry::penetration_of(first, second, -kTouch).depth > -kTouch && geometry::distance(first, second) <= kTouch;
}

std::int64_t InterpenetrationCheck::touching_pairs(const std::vector<Pose>& poses) {
  place_all(poses, 0.5 * kTouch);
  std::int64_t pairs = 0;
  for (std::size_t e = 0; e < poses.size(); ++e) {
    pairs += has_base_ && fixed_[e] == 0 && geometry::depth_under(placed_[e], base_) >= -kTouch;
    near_.clear();
    grid_.query(box_[e], near_);
    for (const std::int32_t other : near_) pairs += is_pair(e, other) && touch(static_cast<std::int32_t>(e), other);
  }
  return pairs;
}

}  // namespace voussoir::io
