// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "cases/case.h"
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
  const std::string done = done_to_record(*c.motion, applied.factor);
  if (!done.empty()) text += "done to the record       " + done + "\n";
  if (c.motion->intensity) text += scaling_table(*c.motion, applied);
  return text;
}

}  // namespace voussoir::io
