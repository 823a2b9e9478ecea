// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/session/prepared_case.h"

#include <omp.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "cases/followed_points.h"
#include "cases/joint_rules.h"
#include "io/motion/support_motion.h"
#include "solver/analysis/main_modes.h"
#include "solver/world/errors.h"

namespace voussoir::io {
namespace {

constexpr double kOff = 0.20;                 // of the model's own frequency
constexpr std::size_t kMostElements = 10000;  // above it modes take minutes
constexpr std::array kAxes{"x", "y"};

void warn(const std::string& text) { std::fprintf(stderr, "voussoir: warning: %s\n", text.c_str()); }

std::string four_digits(double v) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", v);
  return text.data();
}

/// "8.015 Hz (mode 1, 75.1 % of the mass in y)"
std::string described(const solver::MainMode& m, std::size_t axis) {
  std::array<char, 80> text{};
  std::snprintf(text.data(), text.size(), "%s Hz (mode %d, %.1f %% of the mass in %s)", four_digits(m.frequency).c_str(), m.number,
                100.0 * m.mass_share, kAxes[axis]);
  return text.data();
}

/// The frequency sets the damping, and the ramp of gravity where that is not given.
bool frequency_matters(const cases::Case& c) {
  return c.damping.frequency && ((c.damping.ratio > 0.0 && !c.damping.alpha) || (c.gravity.settle && !c.gravity.ramp));
}

void warn_of_frequency(const cases::Case& c, const cases::Model& model) {
  if (c.damping.own_frequency || !frequency_matters(c) || model.blocks.size() > kMostElements) return;
  std::array<solver::MainMode, 2> modes;
  try {
    modes = solver::main_modes(c, model);
  } catch (const solver::NumericalError&) {
    return;  // nothing to compare with
  }
  std::string own;
  for (const std::size_t axis : {1U, 0U}) {
    const solver::MainMode& m = modes[axis];
    if (m.number == 0) continue;
    if (std::abs(*c.damping.frequency - m.frequency) <= kOff * m.frequency) return;
    own += (own.empty() ? "" : ", ") + described(m, axis);
  }
  if (own.empty()) return;
  warn("damping.frequency = " + four_digits(*c.damping.frequency) + " Hz is more than 20 % off the model's own: " + own +
       "; damping.frequency = \"auto\" takes that of y");
}

}  // namespace

cases::Model build_on_all_threads(const cases::Case& c) { return cases::build_model(c, omp_get_max_threads()); }

cases::Model prepared_model(const cases::Case& c) {
  cases::Model model = build_on_all_threads(c);
  load_support_motions(model, c.folder);
  cases::check_followed_points(c, model);
  return model;
}

void fill_own_frequency(cases::Case& c) {
  if (!c.damping.own_frequency || c.damping.frequency) return;
  const cases::Model model = prepared_model(c);
  solver::MainMode mode = solver::main_modes(c, model)[1];
  // Beams that lie on walls by friction alone have six still modes each: then their weight is taken to hold them.
  const bool held = mode.number == 0;
  if (held) mode = solver::main_modes(c, model, solver::DryJoints::closed)[1];
  if (mode.number == 0)
    throw cases::InputError("damping.frequency", "is \"auto\", but none of the " + std::to_string(solver::kMainModesOf) +
                                                     " lowest modes moves a tenth of the mass along y (voussoir modes lists them once a "
                                                     "number stands here); give a number of Hz");
  c.damping.frequency = std::strtod(four_digits(mode.frequency).c_str(), nullptr);
  std::fprintf(stderr, "voussoir: damping.frequency = \"auto\": %s%s\n", described(mode, 1).c_str(),
               held ? ", with joints without a bond held as if bonded" : "");
}

void warn_of_slips(const cases::Case& c, const cases::Model& model) {
  for (const std::string& rule : cases::unused_joint_rules(c, model)) warn(rule);
  warn_of_frequency(c, model);
}

}  // namespace voussoir::io
