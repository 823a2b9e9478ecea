// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/results/base_motion.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "cases/case.h"
#include "io/input/motion/motion_files.h"
#include "solver/run/run.h"

namespace voussoir::io {
namespace {

/// Integrates one axis forward in time.
class Integral {
 public:
  explicit Integral(const cases::Accelerogram& a) : a_(a) {}

  struct Row {
    double acceleration, velocity, displacement;
  };
  /// \pre t does not decrease between calls
  Row at(double t) {
    const std::vector<double>& s = a_.acceleration;
    if (s.empty()) return {0.0, 0.0, 0.0};
    while (sample_ + 1 < s.size() && t >= static_cast<double>(sample_ + 1) * a_.dt) go_on();
    const double part = t - static_cast<double>(sample_) * a_.dt;
    if (sample_ + 1 == s.size()) return {cases::acceleration_at(a_, t), velocity_, displacement_ + velocity_ * part};
    const double a0 = s[sample_], slope = (s[sample_ + 1] - a0) / a_.dt;
    return {cases::acceleration_at(a_, t), velocity_ + part * (a0 + part * slope / 2.0),
            displacement_ + part * (velocity_ + part * (a0 / 2.0 + part * slope / 6.0))};
  }

 private:
  void go_on() {
    const double a0 = a_.acceleration[sample_], a1 = a_.acceleration[sample_ + 1], dt = a_.dt;
    displacement_ += dt * (velocity_ + dt * (2.0 * a0 + a1) / 6.0);
    velocity_ += dt * (a0 + a1) / 2.0;
    ++sample_;
  }

  const cases::Accelerogram& a_;
  std::size_t sample_ = 0;
  double velocity_ = 0.0, displacement_ = 0.0;  // at the current sample
};

template <class T>
StaticDataset dataset(const char* name, const std::vector<T>& values, Shape shape, const char* unit, std::string description) {
  StaticDataset d;
  d.name = name;
  d.shape = std::move(shape);
  d.bytes.resize(values.size() * sizeof(T));
  if (!values.empty()) std::memcpy(d.bytes.data(), values.data(), d.bytes.size());
  d.note = {unit, std::move(description)};
  return d;
}

}  // namespace

BaseMotion base_motion(const cases::GroundMotion& motion, double dt, std::int64_t every, std::int64_t last) {
  BaseMotion out;
  std::array<Integral, 3> axes{Integral(motion.axis[0]), Integral(motion.axis[1]), Integral(motion.axis[2])};
  for (std::int64_t n = 0; n <= last; n += every) {
    const double t = static_cast<double>(n) * dt;
    const Integral::Row x = axes[0].at(t), y = axes[1].at(t), z = axes[2].at(t);
    out.time.push_back(t);
    out.acceleration.push_back({x.acceleration, y.acceleration, z.acceleration});
    out.velocity.push_back({x.velocity, y.velocity, z.velocity});
    out.displacement.push_back({x.displacement, y.displacement, z.displacement});
  }
  return out;
}

std::vector<StaticDataset> motion_datasets(const cases::Case& c, const cases::GroundMotion& motion, double dt, std::int64_t cycle) {
  if (!c.motion || is_assessment(c.analysis)) return {};
  const std::int64_t every = solver::in_cycles(c.output.history_interval, dt, cycle);
  const BaseMotion m = base_motion(motion, dt, every, solver::last_step(c.time.duration, dt, cycle));
  const std::string done = done_to_record(*c.motion, motion.factor);
  const Shape rows{m.time.size()}, vectors{m.time.size(), 3};
  std::vector<StaticDataset> all{
      dataset("/motion/time", m.time, rows, "s", "time of the rows: those of /history, up to the case's duration"),
      dataset("/motion/acceleration", m.acceleration, vectors, "m/s2",
              "of the base along x, y, z, as applied: scaled" + (done.empty() ? std::string() : "; of the record " + done)),
      dataset("/motion/velocity", m.velocity, vectors, "m/s", "of the base: the integral of its acceleration from rest"),
      dataset("/motion/displacement", m.displacement, vectors, "m", "of the base: the integral of its velocity from zero")};
  if (c.motion->intensity)
    all.push_back(dataset("/motion/factors", std::vector(motion.factor.begin(), motion.factor.end()), {3}, "1",
                          "by which L, T, V (or x, y, z) of the record were multiplied to reach motion.intensity"));
  return all;
}

}  // namespace voussoir::io
