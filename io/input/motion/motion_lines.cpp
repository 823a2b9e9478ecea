// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "cases/case.h"
#include "geometry/message.h"
#include "io/input/motion/motion_files.h"
#include "io/input/motion/spectra/figures.h"
#include "io/input/motion/spectra/intensity.h"
#include "io/input/motion/treatment.h"

namespace voussoir::io {

std::string done_to_record(const cases::Motion& motion, const std::array<double, 3>& factor) {
  std::string done = described(motion.treatment);
  if (motion.intensity) {
    const auto [first, second, vertical] = factor;
    char by[80];
    std::snprintf(by, sizeof by, "%.6g", first);
    if (second != first || vertical != first) std::snprintf(by, sizeof by, "%.6g, %.6g and %.6g", first, second, vertical);
    done += (done.empty() ? "" : ", ") + std::string("multiplied by ") + by + " to reach " + described(*motion.intensity);
  }
  return done;
}

namespace {

constexpr double kMostOfPeak = 0.95;  // of a motion's peak, that a run should reach

/// How [motion.intensity] was reached: along each axis the factor, and the peak acceleration before and after.
std::string scaling_table(const cases::Motion& m, const cases::GroundMotion& applied) {
  std::string text = "motion.intensity         " + described(*m.intensity) + ", " + meaning_of(m.intensity->components) + "\n";
  for (std::size_t i = 0; i < 3; ++i) {
    if (applied.axis[i].acceleration.empty()) continue;
    const double peak = figures(applied.axis[i]).peak_acceleration, factor = applied.factor[component_along(m, i)];
    char line[120];
    std::snprintf(line, sizeof line, "  scaling along %c        PGA %.4g -> %.4g m/s2 (%.3g g), factor %.4g\n", "xyz"[i], peak / factor,
                  peak, peak / cases::kStandardGravity, factor);
    text += line;
  }
  return text;
}

/// Peaks up to the end of a run that ends before the strongest part of its motion; else empty.
std::string peaks_within(const cases::GroundMotion& applied, double end) {
  std::string peaks, weaker;
  for (std::size_t i = 0; i < 3; ++i) {
    const cases::Accelerogram& a = applied.axis[i];
    double within = 0.0, whole = 0.0;
    for (std::size_t k = 0; k < a.acceleration.size(); ++k) {
      whole = std::max(whole, std::abs(a.acceleration[k]));
      if (static_cast<double>(k) * a.dt <= end) within = whole;
    }
    if (a.acceleration.empty()) continue;
    const auto join = [](std::string& list, const std::string& word) { list += (list.empty() ? "" : ", ") + word; };
    join(peaks, geometry::printed("%.4g", within));
    if (within < kMostOfPeak * whole) join(weaker, std::string(1, "xyz"[i]));
  }
  if (weaker.empty()) return "";
  return geometry::printed(
      "ground until the end     peaks %s m/s2 up to %.3f s; along %s the record's peak comes later, when the run has ended\n",
      peaks.c_str(), end, weaker.c_str());
}

}  // namespace

std::string motion_lines(const cases::Case& c, const cases::GroundMotion& applied) {
  if (!c.motion || is_assessment(c.analysis)) return {};
  std::string text;
  for (std::size_t i = 0; i < 3; ++i) {
    const cases::Accelerogram& a = applied.axis[i];
    if (a.acceleration.empty()) continue;
    const MotionFigures f = figures(a);
    char line[120];
    std::snprintf(line, sizeof line, "motion along %c           %.3f s, peaks %.4g m/s2, %.3g m/s, %.3g m; ", "xyz"[i], f.duration,
                  f.peak_acceleration, f.peak_velocity, f.peak_displacement);
    text += line + a.name + "\n";
  }
  text += peaks_within(applied, c.time.duration);
  const std::string done = done_to_record(*c.motion, applied.factor);
  if (!done.empty()) text += "done to the record       " + done + "\n";
  if (c.motion->intensity) text += scaling_table(*c.motion, applied);
  return text;
}

}  // namespace voussoir::io
