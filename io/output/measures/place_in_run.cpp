// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/place_in_run.h"

#include <array>
#include <cstdio>

#include "cases/case.h"
#include "cases/names.h"
#include "io/output/measures/capacity/capacity_file.h"

namespace voussoir::io {
namespace {

std::string seconds(double time) {
  std::array<char, 32> out{};
  std::snprintf(out.data(), out.size(), "%.3f", time);
  return out.data();
}

}  // namespace

std::string stage_at(const cases::Case& c, double time) {
  if (time < 0.0) return "settling";
  return is_assessment(c.analysis) ? name_of(c.analysis.kind) : "shaking";
}

std::string place_in_run(const cases::Case& c, double time) {
  const std::string stage = stage_at(c, time), end = cases::text(c.end()) + " s";
  if (time < 0.0) {
    const std::string next = is_assessment(c.analysis) ? name_of(c.analysis.kind) : "shaking";
    return "at " + seconds(time) + " s, settling: the " + next + " (" + end + ") has not begun";
  }
  if (is_assessment(c.analysis)) return "at " + seconds(time) + " s, " + stage + ", of " + end + " at most";
  return "at " + seconds(time) + " of " + end + ", " + stage;
}

}  // namespace voussoir::io
