// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/vec3.h"
#include "io/output/replay/covered_faces.h"
#include "io/output/replay/frame_reader.h"

namespace voussoir::io {

class Hdf5File;

/// Lower bounds of the width of crack levels [m]: level i + 1 from kCrackWidths[i] on; level 0 is a joint that is not open
/// (joint_openings.h).
inline constexpr std::array<double, 13> kCrackWidths{0,    0.05e-3, 0.1e-3, 0.2e-3, 0.5e-3, 1e-3,  2e-3,
                                                     5e-3, 10e-3,   20e-3,  50e-3,  100e-3, 200e-3};
/// Width [m] from which the broken faces of a joint are shown.
inline constexpr double kFacesShow = 5e-3;

/// Level of an open joint. \param width  m
[[nodiscard]] std::uint8_t crack_level(double width) noexcept;

/// Joints that open during a run: their edges, and their level in every frame. The width is that of io/MEASURES.md: the distance, in
/// opening and sliding together, of the two points that initially coincided in the middle of the joint.
struct JointCracks {
  std::vector<std::int32_t> elements;  // two per joint; the second −1: the base
  std::vector<std::uint8_t> edges;     // by joint, number of its edges on the surface of the masonry
  std::vector<float> ends;             // m, two points per edge, joint by joint, in the reference configuration
  std::vector<std::uint8_t> level;     // of all these joints, frame by frame
  std::vector<double> shown;           // s, by joint of the run: time from which its faces are shown; infinity: never
};

/// Finds the joints that open. \param run  with its joints, faces and cracks \throw FileError
JointCracks joint_cracks(const Hdf5File& run, const FrameReader& frames);

struct JointEdge {
  Vec3 from, to;  // m, in the reference configuration
};

/// For each joint, the edges of the area shared by its two elements that lie on the surface of the masonry: those along a face that is not
/// entirely covered by bonded joints.
/// \param run  with the half-spaces of the elements' faces \param joints  rows of /model/joint \throw FileError
std::vector<std::vector<JointEdge>> joint_edges(const Hdf5File& run, const std::vector<std::size_t>& joints,
                                                DryJoints dry = DryJoints::open);

/// For each joint, the corners of the area shared by its two elements, in the reference configuration [m].
/// \param joints  rows of /model/joint \throw FileError
std::vector<std::vector<Vec3>> joint_corners(const Hdf5File& run, const std::vector<std::size_t>& joints);

}  // namespace voussoir::io
