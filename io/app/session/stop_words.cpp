// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/session/stop_words.h"

#include <array>
#include <csignal>
#include <cstdio>

#include "cases/names.h"
#include "io/output/measures/capacity/capacity_file.h"

namespace voussoir::io {
namespace {

std::string seconds(double time) {
  std::array<char, 32> out{};
  std::snprintf(out.data(), out.size(), "%.3f", time);
  return out.data();
}

std::string name_of_signal(int signal) {
  return signal == SIGINT ? "SIGINT (Ctrl-C)" : signal == SIGTERM ? "SIGTERM" : "signal " + std::to_string(signal);
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

std::string stop_lines(const cases::Case& c, double time, int signal, const std::string& folder) {
  return "stopped              " + place_in_run(c, time) + ", by " + name_of_signal(signal) +
         "\n                     what follows is how far it has come, not what comes out\nto go on             voussoir resume " + folder +
         "\n";
}

}  // namespace voussoir::io
