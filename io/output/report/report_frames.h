// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// Frames of a run in the packed form that the report page reads.
namespace voussoir::io {

class FrameReader;
class Hdf5File;

/// All frames, packed (see packed_text.h). A frame of n elements is 15 n bytes, all differences from the frame before (of the first: from
/// zero): for each of dx, dy, dz, w, x, y, z the n low bytes, then the n high bytes of zigzag_step; then n bytes of the broken fraction,
/// modulo 256. Displacements from position0 are in units of `quantum`, the quaternion of an element with the shift s in units of 2^s/32767,
/// fractions of 1/255. The shift of an element is the largest for which rounding the rotation moves no corner by more than rounding the
/// position may: half a quantum along each of three axes.
struct PackedFrames {
  double quantum = 0;               // m; positions are exact to half a quantum
  std::vector<std::uint8_t> shift;  // by element
  std::string text;
};

/// Interval of the frames in a page, which has the first, every so many after it, and the last: 1 for a house, more for large models,
/// limited by what a browser can load.
std::uint64_t frames_apart(std::uint64_t elements, std::uint64_t frames);

/// \throw FileError, also for a frame with a value that is no number
PackedFrames pack_frames(const Hdf5File& run, const FrameReader& reader);

}  // namespace voussoir::io
