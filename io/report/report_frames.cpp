// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/report/report_frames.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "io/files/packed_text.h"
#include "io/replay/frame_reader.h"

namespace voussoir::io {
namespace {

constexpr double kSteps = 32767;  // of 16 bits to either side

/// The smallest step in which the largest displacement fits 16 bits, but no finer than 1 um.
double quantum_of(const FrameReader& reader) {
  double largest = 0;
  for (std::uint64_t f = 0; f < reader.frames(); ++f)
    for (const double u : reader.displacement(f)) largest = std::max(largest, std::abs(u));
  return std::max(largest / kSteps, 1e-6);
}

/// Writes frames as steps from the one before.
class FramePacker {
 public:
  explicit FramePacker(std::uint64_t elements) : last_(7 * elements), last_broken_(elements), bytes_(15 * elements) {}

  /// Component `channel` (0 to 6) of all elements: `width` apart, from `first`.
  void put(std::size_t channel, std::span<const double> values, std::size_t first, std::size_t width, double quantum) {
    const std::size_t n = last_broken_.size();
    std::byte* low = bytes_.data() + 2 * channel * n;
    for (std::size_t i = 0; i < n; ++i) {
      std::int16_t& last = last_[channel * n + i];
      const std::int16_t now = quantised(values[first + width * i], quantum);
      const unsigned step = zigzag_step(last, now);
      low[i] = static_cast<std::byte>(step & 255U);
      low[n + i] = static_cast<std::byte>(step >> 8U);
      last = now;
    }
  }
  void put_broken(std::span<const double> fraction) {
    const std::size_t n = last_broken_.size();
    for (std::size_t i = 0; i < n; ++i) {
      const auto now = static_cast<unsigned>(std::lround(255 * std::clamp(fraction[i], 0.0, 1.0)));
      bytes_[14 * n + i] = static_cast<std::byte>(now - last_broken_[i]);
      last_broken_[i] = now;
    }
  }
  void end_frame() { out_.append(bytes_); }
  std::string finish() { return out_.finish(); }

 private:
  std::vector<std::int16_t> last_;
  std::vector<unsigned> last_broken_;
  std::vector<std::byte> bytes_;  // of the frame
  Deflater out_;
};

}  // namespace

PackedFrames pack_frames(const FrameReader& reader) {
  const double quantum = quantum_of(reader);
  FramePacker out(reader.elements());
  for (std::uint64_t f = 0; f < reader.frames(); ++f) {
    const std::vector<double> u = reader.displacement(f), q = reader.row("quaternion", f, 4);
    for (std::size_t k = 0; k < 3; ++k) out.put(k, u, k, 3, quantum);
    for (std::size_t k = 0; k < 4; ++k) out.put(3 + k, q, k, 4, 1 / kSteps);
    out.put_broken(reader.row("broken", f, 1));
    out.end_frame();
  }
  return {quantum, out.finish()};
}

}  // namespace voussoir::io
