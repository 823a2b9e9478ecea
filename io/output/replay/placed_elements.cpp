// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/replay/placed_elements.h"

#include <algorithm>
#include <limits>

#include "io/input/files/errors.h"

namespace voussoir::io {
namespace {

Vec3 vector_at(const std::vector<double>& values, std::size_t i) { return {values[3 * i], values[3 * i + 1], values[3 * i + 2]}; }

}  // namespace

std::vector<double> element_radii(const Hdf5File& run, std::size_t elements) {
  const auto first = run.read<std::int32_t>("/model/element/first_vertex");
  const auto centre = run.read<double>("/model/element/position0"), vertex = run.read<double>("/model/vertex");
  if (first.size() != elements || centre.size() != 3 * elements) throw FileError(run.path(), "/model/element does not fit together");
  std::vector<double> radius(elements);
  std::size_t e = 0;
  for (std::size_t v = 0; v < vertex.size() / 3; ++v) {
    while (e + 1 < elements && static_cast<std::int64_t>(v) >= first[e + 1]) ++e;
    radius[e] = std::max(radius[e], norm(vector_at(vertex, v) - vector_at(centre, e)));
  }
  return radius;
}

std::vector<Pose> first_poses(const FrameReader& frames) {
  std::vector<Pose> poses(frames.elements());
  for (std::size_t e = 0; e < poses.size(); ++e) poses[e].centre = vector_at(frames.start(), e);
  return poses;
}

std::vector<Pose> poses_of(const FrameReader& frames, std::uint64_t frame) {
  const std::vector<double> x = frames.position(frame), q = frames.row("quaternion", frame, 4);
  std::vector<Pose> poses(frames.elements());
  for (std::size_t e = 0; e < poses.size(); ++e)
    poses[e] = {vector_at(x, e), rotation({q[4 * e], q[4 * e + 1], q[4 * e + 2], q[4 * e + 3]})};
  return poses;
}

ElementShapes::ElementShapes(const Hdf5File& run, std::size_t elements) : first_(elements + 1), radius_(element_radii(run, elements)) {
  const auto element = run.read<std::int32_t>("/model/face/element");
  const auto normal = run.read<double>("/model/face/normal"), distance = run.read<double>("/model/face/distance");
  if (normal.size() != 3 * element.size() || distance.size() != element.size() || !std::ranges::is_sorted(element))
    throw FileError(run.path(), "/model/face does not fit together");
  for (std::size_t f = 0; f < element.size(); ++f) {
    if (element[f] < 0 || static_cast<std::size_t>(element[f]) >= elements)
      throw FileError(run.path(), "/model/face: row " + std::to_string(f) + " belongs to no element");
    faces_.push_back({vector_at(normal, f), distance[f]});
    ++first_[static_cast<std::size_t>(element[f]) + 1];
  }
  for (std::size_t e = 0; e < elements; ++e) first_[e + 1] += first_[e];
}

std::optional<Chord> ElementShapes::chord(std::size_t element, const Pose& pose, double x, double y) const noexcept {
  // The line is p + z up; in the element's own axes, each face restricts it to z with n·p + z n·up <= distance.
  const Mat3 back = transposed(pose.rotation);
  const Vec3 p = back * Vec3{x - pose.centre.x, y - pose.centre.y, -pose.centre.z}, up = back * Vec3{0, 0, 1};
  Chord c{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (std::size_t f = first_[element]; f < first_[element + 1]; ++f) {
    const double slope = dot(faces_[f].normal, up), room = faces_[f].distance - dot(faces_[f].normal, p);
    if (slope > 0) {
      c.high = std::min(c.high, room / slope);
    } else if (slope < 0) {
      c.low = std::max(c.low, room / slope);
    } else if (room < 0) {
      return {};
    }
  }
  if (c.low >= c.high) return {};
  return c;
}

}  // namespace voussoir::io
