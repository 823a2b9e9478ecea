// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/motion/synthetic/wavelets.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/nth.h"

namespace voussoir::io {
namespace {

constexpr double kLowestCarrier = 0.7;  // Hz
constexpr int kCarriers = 30;           // log-spaced over five octaves, one wavelet each per slot
constexpr int kSlots = 37;              // of half a second, from 0.25 s

/// Knuth's 64-bit linear congruential generator (the MMIX constants). The upper 53 bits are the fraction, which is therefore exact on every
/// machine.
class Generator {
 public:
  explicit Generator(std::uint64_t seed) : state_(seed) {}
  double fraction() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state_ >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t state_;
};

double envelope(const std::array<double, kWaveletKnots>& values, double t) {
  std::size_t j = 0;
  while (j + 2 < kWaveletKnots && kWaveletKnotTimes[j + 1] <= t) ++j;
  const double part = (t - kWaveletKnotTimes[j]) / (kWaveletKnotTimes[j + 1] - kWaveletKnotTimes[j]);
  return (1.0 - part) * values[j] + part * values[j + 1];
}

}  // namespace

void add(const Wavelet& p, std::vector<double>& acceleration) {
  const double w = 2.0 * std::numbers::pi * p.frequency, k = std::numbers::pi / p.half_length;
  const int end = static_cast<int>(acceleration.size()) - 1;
  const int first = std::max(0, static_cast<int>(std::ceil((p.centre - p.half_length) / kWaveletStep)));
  const int last = std::min(end, static_cast<int>(std::floor((p.centre + p.half_length) / kWaveletStep)));
  for (int i = first; i <= last; ++i) {
    const double u = i * kWaveletStep - p.centre;
    const double s = 0.5 * (1.0 + std::cos(k * u)), s1 = -0.5 * k * std::sin(k * u), s2 = -0.5 * k * k * std::cos(k * u);
    const double window = s * s, window1 = 2.0 * s * s1, window2 = 2.0 * (s1 * s1 + s * s2);
    const double c = std::cos(w * u + p.phase);
    const double value = window * c + 2.0 / w * window1 * std::sin(w * u + p.phase) - window2 / (w * w) * c;
    nth(acceleration, i) += p.amplitude * value;
  }
}

void add_short_wavelets(const WaveletAmplitudes& amplitudes, std::uint64_t seed, std::vector<double>& acceleration) {
  Generator random(seed);
  for (int slot = 0; slot < kSlots; ++slot) {
    for (int carrier = 0; carrier < kCarriers; ++carrier) {
      const double shift = random.fraction(), wait = random.fraction(), phase = 2.0 * std::numbers::pi * random.fraction();
      const double frequency = kLowestCarrier * std::exp2(5.0 * (carrier + shift) / kCarriers);
      const double centre = 0.25 + 0.5 * (slot + wait);
      const double half_length = std::max(0.8, 1.5 / frequency);  // s; three cycles at least
      // A wavelet cut off by the start would leave a drift. The end cuts none off: the last centre is at 18.75 s, and the longest half
      // length is 2.15 s.
      if (centre < half_length) continue;
      const int band = carrier * kWaveletBands / kCarriers;
      const double amplitude = nth(amplitudes.band, band) * envelope(band < kWaveletLowBands ? amplitudes.low : amplitudes.high, centre);
      add({amplitude, frequency, centre, half_length, phase}, acceleration);
    }
  }
}

}  // namespace voussoir::io
