// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/analysis/impulse.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>

#include "cases/case.h"
#include "cases/model.h"
#include "cases/motion.h"
#include "geometry/nth.h"
#include "solver/run/simulation.h"

namespace voussoir::solver {

namespace {

double component(Vec3 v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/// The largest step not above the given one [s] that divides the interval of the samples.
double dividing_step(double step) { return kImpulseInterval / std::ceil(kImpulseInterval / step * (1.0 - 1e-12)); }

/// The case as it vibrates freely.
cases::Case undamped(cases::Case c) {
  c.gravity.settle = false;
  c.gravity.acceleration = {};
  c.damping = {};
  c.loads.clear();
  c.analysis = {};
  c.time.multirate = 1;                          // samples are no whole cycles apart
  c.output.history_interval = kImpulseInterval;  // an automatic step divides it
  if (c.time.step) c.time.step = dividing_step(*c.time.step);
  return c;
}

/// The model without what moves by itself.
cases::Model at_rest(cases::Model m) {
  for (cases::Block& b : m.blocks) b.velocity = b.angular_velocity = {}, b.support_motion = -1;
  return m;
}

}  // namespace

ImpulseResponse impulse_response(const cases::Case& c, const cases::Model& m, const Options& options, int axis,
                                 const std::function<void(double)>& tick) {
  const cases::Case free = undamped(c);
  const cases::Model still = at_rest(m);
  Options o = options;
  if (o.step) o.step = dividing_step(*o.step);
  cases::GroundMotion motion;
  nth(motion.axis, axis) = {"impulse", kImpulseInterval, {1.0, 0.0}};
  Simulation sim(free, still, motion, o);
  const std::int64_t every = std::max<std::int64_t>(1, std::llround(kImpulseInterval / sim.dt()));
  ImpulseResponse response;
  response.displacement.resize(free.output.history.size());
  for (int sample = 0; sample < kImpulseSamples; ++sample) {
    for (std::int64_t step = 0; step < every; ++step) sim.step({step == 0, false});
    for (std::size_t k = 0; k < response.displacement.size(); ++k)
      response.displacement[k].push_back(component(sim.history()[k].displacement, axis));
    tick(static_cast<double>(sample + 1) / kImpulseSamples);
  }
  const Damage& d = sim.damage();
  response.broken = d.tension + d.shear + d.compression + d.slipped;
  return response;
}

double dominant_frequency(std::span<const double> samples, double interval) {
  const std::vector<double> values(samples.begin(), samples.end());
  std::vector<std::complex<double>> transform;
  Eigen::FFT<double> fft;
  fft.fwd(transform, values);
  const auto half = transform.begin() + static_cast<std::ptrdiff_t>(values.size() / 2 + 1);
  const auto peak = std::max_element(transform.begin() + 1, half, [](auto a, auto b) { return std::norm(a) < std::norm(b); });
  return static_cast<double>(peak - transform.begin()) / (static_cast<double>(values.size()) * interval);
}

}  // namespace voussoir::solver
