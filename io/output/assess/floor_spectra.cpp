// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/assess/floor_spectra.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "io/input/files/errors.h"
#include "io/input/motion/spectra/figures.h"
#include "io/output/measures/point_accelerations.h"

namespace voussoir::io {
namespace {

constexpr int kPeriods = 61;
constexpr double kShortest = 0.02, kLongest = 4.0;  // s
constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};

/// Rate of change of equally spaced values: central, one-sided at the ends.
double rate(const std::vector<double>& v, std::size_t axis, std::size_t i, double dt) {
  const std::size_t rows = v.size() / 3, before = i > 0 ? i - 1 : i, after = i + 1 < rows ? i + 1 : i;
  return after == before ? 0.0 : (v[3 * after + axis] - v[3 * before + axis]) / (static_cast<double>(after - before) * dt);
}

/// Sets the peaks of a point. \param all  low-passed accelerations of the run
void take_peaks(const PointAccelerations& all, FloorAcceleration& p) {
  const auto take = [&](Vec3 a) {
    p.peak_horizontal = std::max(p.peak_horizontal, std::hypot(a.x, a.y));
    p.peak = {std::max(p.peak[0], std::abs(a.x)), std::max(p.peak[1], std::abs(a.y)), std::max(p.peak[2], std::abs(a.z))};
  };
  const auto own = std::ranges::find(all.points, p.name, &PointAcceleration::name);
  p.low_passed = own != all.points.end();
  if (p.low_passed) return std::ranges::for_each(own->acceleration, take), void();
  for (std::size_t i = 0; i < p.axis[0].acceleration.size(); ++i)
    take({p.axis[0].acceleration[i], p.axis[1].acceleration[i], p.axis[2].acceleration[i]});
}

void add_rows(std::string& out, const std::string& name, const std::array<cases::Accelerogram, 3>& motion,
              const std::vector<double>& dampings) {
  const std::vector<double> periods = spectrum_periods();
  std::string quoted = name;
  std::ranges::replace(quoted, '"', '\'');
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (motion[axis].acceleration.empty()) continue;
    for (const double damping : dampings) {
      const std::vector<double> values = spectrum(motion[axis], periods, damping);
      for (std::size_t k = 0; k < periods.size(); ++k) {
        std::array<char, 100> numbers{};
        std::snprintf(numbers.data(), numbers.size(), ",%s,%g,%.6g,%.6g\n", kAxes[axis], damping, periods[k], values[k]);
        out += "\"" + quoted + "\"" + numbers.data();
      }
    }
  }
}

}  // namespace

std::vector<FloorAcceleration> floor_accelerations(const Hdf5File& run, const std::vector<std::string>& names,
                                                   const cases::GroundMotion& base) {
  const auto time = run.read<double>("/history/time");
  std::vector<FloorAcceleration> all;
  if (time.size() < 3) return all;
  const double dt = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
  const PointAccelerations low_passed = point_accelerations(run);
  for (const std::string& name : names) {
    const std::string from = "/history/" + name + "/velocity";
    const auto v = run.read<double>(from);
    if (v.size() != 3 * time.size()) throw FileError(run.path(), from + " does not fit /history/time");
    FloorAcceleration& p = all.emplace_back();
    p.name = name;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      p.axis[axis].name = name, p.axis[axis].dt = dt;
      for (std::size_t i = 0; i < time.size(); ++i)
        p.axis[axis].acceleration.push_back(rate(v, axis, i, dt) + cases::acceleration_at(base.axis[axis], time[i]));
    }
    take_peaks(low_passed, p);
  }
  return all;
}

std::vector<double> spectrum_periods() {
  std::vector<double> periods;
  for (int k = 0; k < kPeriods; ++k) periods.push_back(kShortest * std::pow(kLongest / kShortest, static_cast<double>(k) / (kPeriods - 1)));
  return periods;
}

std::vector<double> spectrum(const cases::Accelerogram& a, const std::vector<double>& periods, double damping) {
  std::vector<double> values;
  for (const double period : periods) {
    const double omega = 2.0 * std::numbers::pi / period;
    values.push_back(omega * omega * spectral_displacement(a, 1.0 / period, damping));
  }
  return values;
}

std::string spectra_csv(const std::vector<FloorAcceleration>& points, const cases::GroundMotion& base,
                        const std::vector<double>& dampings) {
  std::string out = "point,axis,damping,period,acceleration\n";
  add_rows(out, "base", base.axis, dampings);
  for (const FloorAcceleration& p : points) add_rows(out, p.name, p.axis, dampings);
  return out;
}

}  // namespace voussoir::io
