// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// Frames of a run as the report page reads them.
namespace voussoir::io {

class FrameReader;
class Hdf5File;

/// All frames, packed (see packed_text.h). A frame of n elements is 15 n bytes, all of them steps from the frame before (the first: from
/// zero): for each of dx, dy, dz, w, x, y, z the n low bytes, then the n high bytes of zigzag_step; then n bytes of the broken fraction,
/// modulo 256. Displacements from position0 are in units of `quantum`, the quaternion of an element with the shift s in units of 2^s/32767,
/// fractions of 1/255. A shift is the largest with which turning moves no corner of the element farther from where it is than rounding its
/// position may: by half a quantum along each of three axes.
struct PackedFrames {
  double quantum = 0;               // m; positions are within half of it
  std::vector<std::uint8_t> shift;  // of each element
  std::string text;
};

/// A page shows the first frame of a run, every so many after it, and the last: all of one house's, of large models as many as a browser
/// bears.
std::uint64_t frames_apart(std::uint64_t elements, std::uint64_t frames);

/// \throw FileError, also for a frame with a value that is no number
PackedFrames pack_frames(const Hdf5File& run, const FrameReader& reader);

}  // namespace voussoir::io
