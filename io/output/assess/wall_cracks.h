// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "io/output/measures/building/building.h"
#include "io/output/replay/frame_reader.h"
#include "io/output/replay/placed_elements.h"

/// Widths of cracks at one time, by joint, by wall and by corner of an opening (io/MEASURES.md).
namespace voussoir::io {

/// Kind of an open joint. Seat: timber has slipped on its wall (Building::is_seat). Parted: wider than any crack, its sides have separated.
enum class OpeningKind : std::uint8_t { crack, seat, parted };

/// Width of an open joint.
struct JointWidth {
  static constexpr double kWidestCrack = 0.2;  // m

  std::size_t joint = 0;               // row of /model/joint
  double opening = 0, sliding = 0;     // m: along the joint's normal, rotated with the joint (below 0: closure), and along the joint
  double width = 0;                    // m, of opening and sliding together
  double area = 0;                     // m2
  Vec3 centre;                         // m, in the reference configuration
  std::array<std::int32_t, 2> wall{};  // of its two elements; −1: none, or the same wall as the first
  OpeningKind kind = OpeningKind::crack;

  [[nodiscard]] bool is_of(std::int32_t w) const noexcept { return w >= 0 && (wall[0] == w || wall[1] == w); }
};

/// Widths of the joints that had opened by `time`. \param time  of the poses [s] \throw FileError
std::vector<JointWidth> joint_widths(const Hdf5File& run, const Building& building, const std::vector<Pose>& start, double time,
                                     const std::vector<Pose>& poses);

/// A point of a wall's elevation with masonry in three of the four quadrants around it, where cracks tend to begin.
struct OpeningCorner {
  std::int32_t wall = 0;
  std::string name;         // "opening 1, upper left", seen from outside; openings are numbered from the left
  double along = 0, z = 0;  // m; along: along the wall's axis
};

/// Corners of the openings of a wall, from the bounding boxes of its elements in the reference configuration.
std::vector<OpeningCorner> opening_corners(const Building& building, std::int32_t wall);

/// Cracks of one wall or near one corner, or seats of timber. Joints narrower than a hair crack are ignored.
struct CrackFigures {
  static constexpr double kHair = 0.1e-3;  // m
  static constexpr double kNear = 0.5;     // m from a corner

  std::size_t joints = 0;
  double largest = 0, mean = 0;                     // m, of the width; the mean is weighted by the joints' areas
  double largest_opening = 0, largest_sliding = 0;  // m

  void add(const JointWidth& j);
  /// Computes the mean. Call once, after the last joint.
  void finish();

 private:
  double area_ = 0, sum_ = 0;  // m2, m3
};

/// Whether the joint is a crack of the wall; shared by tables and maps.
bool is_crack_of(const JointWidth& joint, std::int32_t wall);

CrackFigures wall_figures(const std::vector<JointWidth>& joints, std::int32_t wall);
/// Figures of the seats of timber on the wall, whose widths are slips.
CrackFigures seat_figures(const std::vector<JointWidth>& joints, std::int32_t wall);
/// Number of the wall's joints that have parted.
std::size_t parted_joints(const std::vector<JointWidth>& joints, std::int32_t wall);
CrackFigures corner_figures(const std::vector<JointWidth>& joints, const Building& building, const OpeningCorner& corner);

}  // namespace voussoir::io
