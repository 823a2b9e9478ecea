// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/results/base_motion.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <utility>

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

/// The rows of /motion and what they are made of, shared by its datasets.
struct Rows {
  cases::GroundMotion motion;
  double dt;
  std::int64_t every, last;

  [[nodiscard]] std::uint64_t count() const { return static_cast<std::uint64_t>(last / every) + 1; }
};
using SharedRows = std::shared_ptr<const Rows>;

/// \param get  appends what the dataset has of a row
template <class Get>
RowSource source(SharedRows rows, std::size_t width, Get get) {
  return [rows = std::move(rows), width, get](const auto& put) {
    const std::size_t piece = width * checked_layout(width * sizeof(double)).chunk_rows;
    std::vector<double> values;
    values.reserve(std::min<std::size_t>(piece, width * rows->count()));
    base_motion(rows->motion, rows->dt, rows->every, rows->last, [&](const BaseRow& row) {
      get(row, values);
      if (values.size() < piece) return;
      put(values);
      values.clear();
    });
    if (!values.empty()) put(values);
  };
}

StaticDataset times(const SharedRows& rows) {
  StaticDataset d;
  d.name = "/motion/time";
  d.shape = {rows->count()};
  d.source = source(rows, 1, [](const BaseRow& row, std::vector<double>& to) { to.push_back(row.time); });
  d.note = {"s", "time of the rows: those of /history, up to the case's duration"};
  return d;
}

StaticDataset vectors(const char* name, const SharedRows& rows, Vec3 BaseRow::*value, const char* unit, std::string description) {
  StaticDataset d;
  d.name = name;
  d.shape = {rows->count(), 3};
  d.source = source(rows, 3, [value](const BaseRow& row, std::vector<double>& to) {
    const Vec3 v = row.*value;
    to.insert(to.end(), {v.x, v.y, v.z});
  });
  d.note = {unit, std::move(description)};
  return d;
}

StaticDataset factors(const std::array<double, 3>& values) {
  StaticDataset d;
  d.name = "/motion/factors";
  d.shape = {values.size()};
  d.bytes.resize(sizeof values);
  std::memcpy(d.bytes.data(), values.data(), sizeof values);
  d.note = {"1", "by which L, T, V (or x, y, z) of the record were multiplied to reach motion.intensity"};
  return d;
}

}  // namespace

void base_motion(const cases::GroundMotion& motion, double dt, std::int64_t every, std::int64_t last,
                 const std::function<void(const BaseRow&)>& take) {
  std::array<Integral, 3> axes{Integral(motion.axis[0]), Integral(motion.axis[1]), Integral(motion.axis[2])};
  for (std::int64_t n = 0; n <= last; n += every) {
    const double t = static_cast<double>(n) * dt;
    const Integral::Row x = axes[0].at(t), y = axes[1].at(t), z = axes[2].at(t);
    take({t,
          {x.acceleration, y.acceleration, z.acceleration},
          {x.velocity, y.velocity, z.velocity},
          {x.displacement, y.displacement, z.displacement}});
  }
}

std::vector<StaticDataset> motion_datasets(const cases::Case& c, const cases::GroundMotion& motion, double dt, std::int64_t cycle) {
  if (!c.motion || is_assessment(c.analysis)) return {};
  const std::int64_t every = solver::in_cycles(c.output.history_interval, dt, cycle);
  const auto rows = std::make_shared<const Rows>(Rows{motion, dt, every, solver::last_step(c.time.duration, dt, cycle)});
  const std::string done = done_to_record(*c.motion, motion.factor);
  std::vector<StaticDataset> all{
      times(rows),
      vectors("/motion/acceleration", rows, &BaseRow::acceleration, "m/s2",
              "of the base along x, y, z, as applied: scaled" + (done.empty() ? std::string() : "; of the record " + done)),
      vectors("/motion/velocity", rows, &BaseRow::velocity, "m/s", "of the base: the integral of its acceleration from rest"),
      vectors("/motion/displacement", rows, &BaseRow::displacement, "m", "of the base: the integral of its velocity from zero")};
  if (c.motion->intensity) all.push_back(factors(motion.factor));
  return all;
}

}  // namespace voussoir::io
