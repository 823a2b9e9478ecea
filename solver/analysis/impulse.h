// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "cases/forward.h"
#include "solver/world/world.h"

/// Natural frequencies by the method of the paper (section 3.5): an impulse, free undamped vibration, a Fourier transform.
namespace voussoir::solver {

/// The paper's sampling: 512 samples of 0.01 s, so the transform has bins of 0.195 Hz.
inline constexpr double kImpulseInterval = 0.01;  // s
inline constexpr int kImpulseSamples = 512;

struct ImpulseResponse {
  std::vector<std::vector<double>> displacement;  // m along the axis of the impulse: by entry of Output::history, by sample
  std::int64_t broken = 0;                        // segment sides; if above 0, the frequencies are not those of the undamaged structure
};

/// Moves the base along an axis (0: x, 1: y, 2: z) with 1 m/s2 at time zero and nothing from the next sample on, without gravity, mass
/// damping, loads, initial velocities, or motion of supports. A step given by the case is reduced to divide the interval. `tick` is called
/// at every sample with the fraction done. \throw cases::InputError, NumericalError
ImpulseResponse impulse_response(const cases::Case& c, const cases::Model& m, const Options& options, int axis,
                                 const std::function<void(double)>& tick);

/// Frequency [Hz] of the largest amplitude of a discrete Fourier transform, without the mean. \pre an even number of samples, at least 4
double dominant_frequency(std::span<const double> samples, double interval);

}  // namespace voussoir::solver
