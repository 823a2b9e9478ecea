// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/report_frames.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "io/input/files/packed_text.h"
#include "io/output/replay/frame_reader.h"
#include "io/output/replay/placed_elements.h"

namespace voussoir::io {
namespace {

constexpr int kMostShift = 8;  // larger shifts save nothing

/// The smallest quantum [m] for which the largest displacement fits 16 bits, at least 1 um.
double quantum_of(const FrameReader& reader) {
  double largest = 0;
  for (std::uint64_t f = 0; f < reader.frames(); ++f)
    for (const double u : reader.displacement(f)) largest = std::max(largest, std::abs(u));
  return std::max(largest / kQuantaOfASide, 1e-6);
}

/// Shifts of all elements. Rounding a quaternion to steps of r moves a point at the distance d by at most 2 d √3 r/2, and rounding a
/// position to a quantum by √3/2 of the quantum, so r may be quantum / (2 d), here a power of two.
std::vector<std::uint8_t> shifts(const Hdf5File& run, std::uint64_t elements, double quantum) {
  std::vector<std::uint8_t> all;
  for (const double d : element_radii(run, static_cast<std::size_t>(elements))) {
    int s = 0;
    while (s < kMostShift && std::ldexp(2 * d, s + 1) <= quantum * kQuantaOfASide) ++s;
    all.push_back(static_cast<std::uint8_t>(s));
  }
  return all;
}

/// Writes frames as differences from the frame before.
class FramePacker {
 public:
  explicit FramePacker(std::uint64_t elements) : last_(7 * elements), last_broken_(elements), bytes_(15 * elements) {}

  /// Adds component `channel` (0 to 6) of all elements: values `width` apart, from `first` on. \param quantum  function of the element
  void put(std::size_t channel, std::span<const double> values, std::size_t first, std::size_t width, const auto& quantum) {
    const std::size_t n = last_broken_.size();
    std::byte* low = bytes_.data() + 2 * channel * n;
    for (std::size_t i = 0; i < n; ++i) {
      std::int16_t& last = last_[channel * n + i];
      const std::int16_t now = quantised(values[first + width * i], quantum(i));
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

std::uint64_t frames_apart(std::uint64_t elements, std::uint64_t frames) {
  constexpr std::uint64_t kMost = 40'000'000;  // elements times frames; in a collapse each takes four bytes of the page
  return std::max<std::uint64_t>(1, (elements * frames + kMost - 1) / kMost);
}

PackedFrames pack_frames(const Hdf5File& run, const FrameReader& reader) {
  const double quantum = quantum_of(reader);
  const std::vector<std::uint8_t> shift = shifts(run, reader.elements(), quantum);
  const auto of_position = [&](std::size_t) { return quantum; };
  const auto of_turn = [&](std::size_t e) { return std::ldexp(1 / kQuantaOfASide, shift[e]); };
  FramePacker out(reader.elements());
  for (std::uint64_t f = 0; f < reader.frames(); ++f) {
    const std::vector<double> u = reader.displacement(f), q = reader.row("quaternion", f, 4);
    for (std::size_t k = 0; k < 3; ++k) out.put(k, u, k, 3, of_position);
    for (std::size_t k = 0; k < 4; ++k) out.put(3 + k, q, k, 4, of_turn);
    out.put_broken(reader.row("broken", f, 1));
    out.end_frame();
  }
  return {quantum, shift, out.finish()};
}

}  // namespace voussoir::io
