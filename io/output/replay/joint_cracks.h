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

/// Widths from which a crack has a level, m: level i + 1 from kCrackWidths[i] on; level 0 is a joint that is not open (joint_openings.h).
inline constexpr std::array<double, 13> kCrackWidths{0,    0.05e-3, 0.1e-3, 0.2e-3, 0.5e-3, 1e-3,  2e-3,
                                                     5e-3, 10e-3,   20e-3,  50e-3,  100e-3, 200e-3};
/// From this width on the broken faces of a joint show, m.
inline constexpr double kFacesShow = 5e-3;

/// \param width  of a joint that is open [m]
[[nodiscard]] std::uint8_t crack_level(double width) noexcept;

/// Joints that come open during a run: where their edges are, and how wide open they are in every frame. The width is that of
/// io/MEASURES.md: the distance, in opening and sliding together, of the two points that met in the middle of the joint.
struct JointCracks {
  std::vector<std::int32_t> elements;  // two a joint; the second −1: the base
  std::vector<std::uint8_t> edges;     // number of each joint's edges that lie on the surface of the masonry
  std::vector<float> ends;             // two points an edge, of one joint after the other, in the reference configuration, m
  std::vector<std::uint8_t> level;     // of all these joints in one frame after the other
  std::vector<double> shown;           // of every joint of the run: when its faces begin to show, s; infinity: never
};

/// \param run  its joints, faces and cracks \throw FileError
JointCracks joint_cracks(const Hdf5File& run, const FrameReader& frames);

struct JointEdge {
  Vec3 from, to;  // m, in the reference configuration
};

/// Of the area that two elements share, the edges on the surface of the masonry: those along a face that bonded joints do not cover whole.
/// \param run  for the half-spaces of the elements' faces \param joints  rows of /model/joint; the edges of each \throw FileError
std::vector<std::vector<JointEdge>> joint_edges(const Hdf5File& run, const std::vector<std::size_t>& joints,
                                                DryJoints dry = DryJoints::open);

}  // namespace voussoir::io
