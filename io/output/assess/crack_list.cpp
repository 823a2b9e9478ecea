// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/assess/crack_list.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "geometry/disjoint_sets.h"
#include "geometry/nth.h"
#include "io/input/files/errors.h"
#include "io/input/files/hdf5_file.h"
#include "io/output/replay/joint_cracks.h"
#include "io/output/replay/joint_openings.h"

namespace voussoir::io {
namespace {

constexpr double kTouch = 0.012;      // m: joints on two sides of a corner of a brick are apart by the thickness of the mortar
constexpr double kOnWallFace = 1e-4;  // m

/// An open joint of a wall.
struct Open {
  const JointWidth* joint;
  std::int32_t wall;
  Box box;  // along the axes of the model
  std::vector<Vec3> corners;
  std::vector<JointEdge> edges;  // on the surface of the masonry
};

bool touch(const Box& a, const Box& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (a.low[k] > b.high[k] + kTouch || b.low[k] > a.high[k] + kTouch) return false;
  return true;
}

/// The wall whose crack a joint is. Of a joint between two walls the one in whose plane its normal lies, so that it is seen as a line
/// there; of two such walls, one upon the other or at a corner, the first.
std::int32_t wall_of(const Building& b, const JointWidth& joint, Vec3 normal) {
  const auto [first, second] = joint.wall;
  if (first < 0 || second < 0) return std::max(first, second);
  const auto across = [&](std::int32_t w) { return std::abs(nth(b.walls, w).through(normal)); };
  const auto [low, high] = std::pair(std::min(first, second), std::max(first, second));
  return across(high) < across(low) - 0.1 ? high : low;
}

/// All open joints that are cracks of some wall, of elements that have not fallen.
std::vector<Open> open_of(const Hdf5File& run, const Building& building, const std::vector<JointWidth>& joints,
                          const std::vector<std::uint8_t>& fallen) {
  const auto a = run.read<std::int32_t>("/model/joint/element_a"), b = run.read<std::int32_t>("/model/joint/element_b");
  const auto normal = run.read<double>("/model/joint/normal");
  std::vector<Open> open;
  std::vector<std::size_t> rows;
  for (const JointWidth& j : joints) {
    const std::array<std::int32_t, 2> of{a.at(j.joint), b.at(j.joint)};
    if (!std::ranges::any_of(j.wall, [&](std::int32_t w) { return is_crack_of(j, w); })) continue;
    if (nth(fallen, of[0]) != 0 || (of[1] >= 0 && nth(fallen, of[1]) != 0)) continue;
    const Vec3 n{normal.at(3 * j.joint), normal.at(3 * j.joint + 1), normal.at(3 * j.joint + 2)};
    open.push_back({&j, wall_of(building, j, n), Box::empty(), {}, {}});
    rows.push_back(j.joint);
  }
  auto corners = joint_corners(run, rows);
  auto edges = joint_edges(run, rows);
  for (std::size_t i = 0; i < open.size(); ++i) {
    for (const Vec3& p : corners[i]) open[i].box.include(p);
    open[i].corners = std::move(corners[i]);
    open[i].edges = std::move(edges[i]);
  }
  return open;
}

/// Joints that hang together.
geometry::DisjointSets sets_of(const std::vector<const Open*>& open) {
  geometry::DisjointSets sets(open.size());
  std::vector<std::size_t> order(open.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return open[i]->box.low[2]; });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Box& box = open[order[i]]->box;
    for (std::size_t k = i + 1; k < order.size() && open[order[k]]->box.low[2] <= box.high[2] + kTouch; ++k)
      if (touch(box, open[order[k]]->box)) sets.join(order[i], order[k]);
  }
  return sets;
}

/// Adds up a crack from its joints.
class Adder {
 public:
  Adder(const Building& b, std::int32_t wall) : building_(b), wall_(nth(b.walls, wall)), axis_(1 - wall_.across) { crack_.wall = wall; }

  void add(const Open& open) {
    crack_.joints.push_back(open.joint->joint);
    for (const Vec3& p : open.corners) box_.include(wall_.axes.of(p));
    for (const JointEdge& e : open.edges)
      for (std::size_t side = 0; side < 2; ++side) {
        const double face = side == 0 ? wall_.box.low[wall_.across] : wall_.box.high[wall_.across];
        const auto on = [&](Vec3 p) { return std::abs(wall_.through(p) - face) <= kOnWallFace; };
        if (on(e.from) && on(e.to)) length_[side] += norm(e.to - e.from);
      }
    if (open.joint->width > crack_.width) crack_.width = open.joint->width, crack_.widest = open.joint->centre;
  }
  Crack finish() {
    crack_.length = std::max(length_[0], length_[1]);
    if (crack_.length == 0) crack_.length = std::hypot(box_.size(axis_), box_.size(2));  // inside the wall
    const bool right = wall_.right() > 0;
    const double low = box_.low[axis_] - wall_.box.low[axis_], high = wall_.box.high[axis_] - box_.high[axis_];
    const double from = std::max(0.0, right ? low : high), size = box_.size(axis_);
    crack_.along = {from, from + size};
    crack_.z = {building_.height_of(box_.low[2]), building_.height_of(box_.high[2])};
    return std::move(crack_);
  }

 private:
  const Building& building_;
  const Wall& wall_;
  std::size_t axis_;
  Box box_ = Box::empty();          // along the axes of the wall
  std::array<double, 2> length_{};  // m, on the faces in the negative and the positive direction
  Crack crack_;
};

}  // namespace

std::vector<Crack> cracks_of(const Hdf5File& run, const Building& building, const std::vector<JointWidth>& joints,
                             const std::vector<std::uint8_t>& fallen) {
  const std::vector<Open> all = open_of(run, building, joints, fallen);
  std::vector<Crack> cracks;
  for (std::size_t w = 0; w < building.walls.size(); ++w) {
    const auto wall = static_cast<std::int32_t>(w);
    std::vector<const Open*> open;
    for (const Open& o : all)
      if (o.wall == wall) open.push_back(&o);
    geometry::DisjointSets sets = sets_of(open);
    std::map<std::size_t, Adder> of_set;
    for (std::size_t i = 0; i < open.size(); ++i) of_set.try_emplace(sets.of(i), building, wall).first->second.add(*open[i]);
    for (auto& [first, adder] : of_set) cracks.push_back(adder.finish());
  }
  std::ranges::stable_sort(cracks,
                           [](const Crack& a, const Crack& b) { return std::pair(a.width, a.length) > std::pair(b.width, b.length); });
  return cracks;
}

std::vector<std::vector<double>> widths_over_time(const Hdf5File& run, const FrameReader& frames, const std::vector<Crack>& cracks) {
  std::map<std::size_t, OpenJoint> open;
  for (const OpenJoint& j : open_joints(run, first_poses(frames))) open.emplace(j.row, j);
  std::vector<std::vector<double>> widths;
  for (std::uint64_t f = 0; f < frames.frames(); ++f) {
    const std::vector<Pose> poses = poses_of(frames, f);
    std::vector<double>& row = widths.emplace_back();
    for (const Crack& crack : cracks) {
      double most = 0;
      for (const std::size_t j : crack.joints)
        if (open.at(j).time <= frames.times()[f]) most = std::max(most, open.at(j).width(poses));
      row.push_back(most);
    }
  }
  return widths;
}

void follow(const Hdf5File& run, const FrameReader& frames, std::vector<Crack>& cracks) {
  const std::vector<std::vector<double>> widths = widths_over_time(run, frames, cracks);
  for (std::size_t f = 0; f < widths.size(); ++f) {
    for (std::size_t i = 0; i < cracks.size(); ++i) {
      if (widths[f][i] > cracks[i].peak) cracks[i].peak = widths[f][i], cracks[i].peak_time = frames.times()[f];
      cracks[i].at_end = widths[f][i];
    }
  }
}

}  // namespace voussoir::io
