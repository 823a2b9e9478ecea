// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "cases/motion.h"

// A record by synthesis. Each component is a sum of wavelets: one long one, the velocity pulse of a near-fault motion, and about
// 1000 short ones of random carrier, time and phase, whose amplitudes follow a table of bands and times.
//
// Every wavelet is the second derivative of a displacement that starts and ends at rest at zero, so the record needs no baseline
// correction: its velocity and displacement end at zero by construction. Filtered noise under an envelope was the other road; it
// leaves a drift whose removal changes the low frequencies that the pulse is there for.
//
// The table was tuned outside the program, by gradient descent on the distance to the targets in catalogue/bam-like.md, with the
// seeds chosen among some fifty. What it holds is amplitudes and the shapes of three pulses; nothing of a real record's samples is in it.
namespace voussoir::cases {
namespace {

constexpr double kStep = 0.005;         // s
constexpr int kSamples = 4201;          // 21 s
constexpr double kLowestCarrier = 0.7;  // Hz
constexpr int kCarriers = 30;           // log-spaced over five octaves, one wavelet each per slot
constexpr int kSlots = 37;              // of half a second, from 0.25 s
constexpr int kBands = 10;              // half octaves: 0.7, 0.99, 1.4, ... 22.4 Hz
constexpr int kLowBands = 6;            // these (up to 5.6 Hz) follow the envelope `low`, the others `high`
constexpr int kKnots = 10;
constexpr std::array<double, kKnots> kKnotTimes{0, 1, 2, 3, 4, 6, 8, 10, 13, 19};  // s, of the envelopes

/// Acceleration of d(t) = -A/w² W(u) cos(w u + phase), u = t - centre, W(u) = cos⁴(pi u / 2h) for |u| < h.
/// For many cycles within h this is A W cos(w u + phase); the other terms keep the ends at rest.
struct Wavelet {
  double amplitude;    // A, m/s2
  double frequency;    // Hz
  double centre;       // s
  double half_length;  // h, s
  double phase;        // rad
};

struct Recipe {
  const char* name;
  std::uint64_t seed;
  Wavelet pulse;
  std::array<double, kBands> band;       // amplitude of each band relative to its envelope
  std::array<double, kKnots> low, high;  // amplitude of one wavelet at the knot times, m/s2; linear between
};

constexpr std::array<Recipe, 3> kRecipes{{
    {"bam-like L",
     19,
     {2.697, 1 / 2.8, 2.75, 2.7, 0.3},
     {1.19, 0.83, 0.90, 1.15, 0.97, 0.97, 0.76, 1.52, 1.14, 0.58},
     {0.047, 0.046, 0.054, 0.151, 0.293, 0.229, 0.161, 0.113, 0.073, 0.064},
     {0.121, 0.120, 0.128, 1.076, 0.958, 0.675, 0.896, 0.545, 0.217, 0.159}},
    {"bam-like T",
     59,
     {1.299, 1 / 1.7, 4.40, 2.0, 1.0},
     {0.82, 0.81, 0.97, 0.80, 1.36, 1.23, 0.67, 1.25, 1.16, 0.92},
     {0.035, 0.035, 0.036, 0.094, 0.464, 0.705, 0.663, 0.159, 0.100, 0.089},
     {0.103, 0.107, 0.280, 0.729, 0.293, 0.257, 0.179, 0.132, 0.114, 0.109}},
    {"bam-like V",
     21,
     {1.402, 1 / 1.3, 2.50, 1.6, 0.7},
     {0.70, 0.91, 1.22, 1.08, 0.96, 1.13, 0.92, 0.99, 1.13, 0.96},
     {0.298, 0.308, 0.318, 0.364, 0.324, 0.289, 0.228, 0.151, 0.105, 0.091},
     {0.387, 0.386, 0.928, 1.472, 0.906, 0.593, 0.386, 0.234, 0.154, 0.136}},
}};

/// Knuth's 64-bit linear congruential generator (the MMIX constants); the upper 53 bits make the fraction, so it is exact everywhere.
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

void add(const Wavelet& p, std::vector<double>& acceleration) {
  const double w = 2.0 * std::numbers::pi * p.frequency, k = std::numbers::pi / p.half_length;
  const int first = std::max(0, static_cast<int>(std::ceil((p.centre - p.half_length) / kStep)));
  const int last = std::min(kSamples - 1, static_cast<int>(std::floor((p.centre + p.half_length) / kStep)));
  for (int i = first; i <= last; ++i) {
    const double u = i * kStep - p.centre;
    const double s = 0.5 * (1.0 + std::cos(k * u)), s1 = -0.5 * k * std::sin(k * u), s2 = -0.5 * k * k * std::cos(k * u);
    const double window = s * s, window1 = 2.0 * s * s1, window2 = 2.0 * (s1 * s1 + s * s2);
    const double c = std::cos(w * u + p.phase);
    const double value = window * c + 2.0 / w * window1 * std::sin(w * u + p.phase) - window2 / (w * w) * c;
    acceleration[static_cast<std::size_t>(i)] += p.amplitude * value;
  }
}

double envelope(const std::array<double, kKnots>& values, double t) {
  std::size_t j = 0;
  while (j + 2 < kKnots && kKnotTimes[j + 1] <= t) ++j;
  const double part = (t - kKnotTimes[j]) / (kKnotTimes[j + 1] - kKnotTimes[j]);
  return (1.0 - part) * values[j] + part * values[j + 1];
}

Accelerogram synthesise(const Recipe& r) {
  Accelerogram a{r.name, kStep, std::vector<double>(kSamples, 0.0)};
  add(r.pulse, a.acceleration);
  Generator random(r.seed);
  for (int slot = 0; slot < kSlots; ++slot) {
    for (int carrier = 0; carrier < kCarriers; ++carrier) {
      const double shift = random.fraction(), wait = random.fraction(), phase = 2.0 * std::numbers::pi * random.fraction();
      const double frequency = kLowestCarrier * std::exp2(5.0 * (carrier + shift) / kCarriers);
      const double centre = 0.25 + 0.5 * (slot + wait);
      const double half_length = std::max(0.8, 1.5 / frequency);  // s; three cycles at least
      // A wavelet cut off by the start would leave a drift. The end is far enough: the last centre is at 18.75 s, the longest has 2.15 s.
      if (centre < half_length) continue;
      const int band = carrier * kBands / kCarriers;
      const double amplitude = r.band[static_cast<std::size_t>(band)] * envelope(band < kLowBands ? r.low : r.high, centre);
      add({amplitude, frequency, centre, half_length, phase}, a.acceleration);
    }
  }
  return a;
}

}  // namespace

std::array<Accelerogram, 3> bam_like() { return {synthesise(kRecipes[0]), synthesise(kRecipes[1]), synthesise(kRecipes[2])}; }

}  // namespace voussoir::cases
