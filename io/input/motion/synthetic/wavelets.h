// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

/// Accelerograms as sums of wavelets: one long one, the velocity pulse of a near-fault motion, and about a thousand short ones of random
/// carrier, time and phase, whose amplitudes follow a table of bands and times.
///
/// Every wavelet is the second derivative of a displacement that starts and ends at rest at zero, so the sum needs no baseline correction:
/// its velocity and displacement end at zero by construction. Filtered noise under an envelope, the alternative, leaves a drift whose
/// removal would change the low frequencies of the pulse.
namespace voussoir::io {

inline constexpr double kWaveletStep = 0.005;         // s, between samples
inline constexpr std::size_t kWaveletSamples = 4201;  // 21 s
inline constexpr int kWaveletBands = 10;              // half octaves: 0.7, 0.99, 1.4, ... 22.4 Hz
inline constexpr int kWaveletLowBands = 6;  // number of bands (up to 5.6 Hz) under the envelope `low`; the others are under `high`
inline constexpr int kWaveletKnots = 10;
inline constexpr std::array<double, kWaveletKnots> kWaveletKnotTimes{0, 1, 2, 3, 4, 6, 8, 10, 13, 19};  // s, of the envelopes

/// Acceleration of d(t) = -A/w² W(u) cos(w u + phase), u = t - centre, W(u) = cos⁴(pi u / 2h) for |u| < h.
/// For many cycles within h the acceleration is A W cos(w u + phase); the other terms keep the ends at rest.
struct Wavelet {
  double amplitude;    // A, m/s2
  double frequency;    // Hz
  double centre;       // s
  double half_length;  // h, s
  double phase;        // rad
};

/// The amplitudes of the short wavelets of one component.
struct WaveletAmplitudes {
  std::array<double, kWaveletBands> band;       // of each band, relative to its envelope
  std::array<double, kWaveletKnots> low, high;  // of one wavelet at the knot times, m/s2; linear between
};

/// Adds a wavelet to samples of kWaveletStep, [m/s2].
void add(const Wavelet& wavelet, std::vector<double>& acceleration);

/// Adds the short wavelets: one in each of 30 logarithmic intervals of the carrier in each half second; place in the interval, time and
/// phase are random numbers of the seed.
void add_short_wavelets(const WaveletAmplitudes& amplitudes, std::uint64_t seed, std::vector<double>& acceleration);

}  // namespace voussoir::io
