// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "cases/case.h"
#include "io/input/motion/motion_files.h"
#include "io/input/motion/spectra/figures.h"
#include "io/input/motion/spectra/intensity.h"
#include "io/input/motion/treatment.h"

namespace voussoir::io {

std::string done_to_record(const cases::Motion& motion, double factor) {
  std::string done = described(motion.treatment);
  if (motion.intensity) {
    char number[32];
    std::snprintf(number, sizeof number, "%.6g", factor);
    done += (done.empty() ? "" : ", ") + std::string("multiplied by ") + number + " to reach " + described(*motion.intensity);
  }
  return done;
}

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
  return text;
}

}  // namespace voussoir::io
