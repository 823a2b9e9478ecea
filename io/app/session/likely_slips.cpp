// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/session/likely_slips.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "cases/case.h"
#include "cases/house/house_openings.h"
#include "cases/house/house_ties.h"
#include "cases/loads/loads.h"
#include "cases/model.h"
#include "cases/names.h"
#include "cases/rules/joint_rules.h"
#include "cases/solids/outside.h"
#include "cases/walls/walls.h"
#include "geometry/nth.h"
#include "io/input/messages/messages.h"
#include "io/input/motion/motion_files.h"
#include "io/input/motion/spectra/figures.h"
#include "io/input/motion/spectra/intensity.h"
#include "io/input/stones/stone_sizes.h"
#include "solver/world/errors.h"

namespace voussoir::io {
namespace {

constexpr double kOff = 0.20;                 // relative difference from the model's frequency
constexpr std::size_t kMostElements = 10000;  // with more elements modes take minutes
constexpr std::array kAxes{"x", "y", "z"};
// Greater values than in any known record (Iwate-Miyagi 2008, 4,022 cm/s2; Chi-Chi 1999, 3.2 m/s and 9 m).
constexpr double kMostAcceleration = 45.0, kMostVelocity = 5.0, kMostDisplacement = 15.0;  // m/s2, m/s, m
constexpr double kMostOfLevel = 0.95;                                                      // of an intensity: share that a run must reach
constexpr double kStepsOfPeriod = 10.0;  // least samples in a period of Sa: with fewer, peaks fall between samples
constexpr double kWeaker = 0.05;         // ratio of two horizontal components below which their geometric mean is meaningless
constexpr double kMostOfRun = 0.8;       // share of the run that a motion must cover

/// Whether the frequency is used: for damping, and for the ramp of gravity without a given length.
bool frequency_matters(const cases::Case& c) {
  return c.damping.frequency && ((c.damping.ratio > 0.0 && !c.damping.alpha) || (c.gravity.settle && !c.gravity.ramp));
}

void look_at_frequency(const cases::Case& c, const cases::Model& model, std::vector<std::string>& out) {
  if (c.damping.own_frequency || !frequency_matters(c) || model.blocks.size() > kMostElements) return;
  std::array<solver::MainMode, 2> modes;
  try {
    modes = solver::main_modes(c, model);
    if (modes[0].number == 0 && modes[1].number == 0) modes = solver::main_modes(c, model, solver::DryJoints::closed);
    if (modes[0].number == 0 && modes[1].number == 0) modes = solver::main_modes_of_all(c, model, solver::DryJoints::closed);
  } catch (const solver::NumericalError&) {
    return;  // no motion to compare with
  }
  std::string own;
  for (const std::size_t axis : {1U, 0U}) {
    const solver::MainMode& m = modes[axis];
    if (m.frequency == 0.0) continue;
    if (std::abs(*c.damping.frequency - m.frequency) <= kOff * m.frequency) return;
    own += (own.empty() ? "" : ", ") + mode_words(m, axis);
  }
  if (own.empty()) return;
  out.push_back("damping.frequency = " + four_digits(*c.damping.frequency) + " Hz is more than 20 % off the model's own: " + own +
                "; damping.frequency = \"auto\" takes that of y");
}

/// Whether the table is in the case's own file or an override; included files may contain more than the case needs.
bool is_own(const LoadedCase& c, const std::string& key) {
  const auto place = c.keys.find(key);
  return place != c.keys.end() && !place->second.included;
}

void look_for_unused(const LoadedCase& c, const cases::Model& m, std::vector<std::string>& out) {
  std::vector<bool> law(m.laws.size(), false), material(m.materials.size(), false);
  const auto mark = [](std::vector<bool>& used, const auto& all, std::int32_t i) {
    for (; i >= 0 && !nth(used, i); i = nth(all, i).made_from) nth(used, i) = true;
  };
  for (const std::int32_t l : m.joint_law) mark(law, m.laws, l);
  for (const cases::Block& b : m.blocks) mark(material, m.materials, b.material);
  const auto tell = [&](const std::string& table, const std::string& name, const char* what) {
    const std::string key = table + "." + name;
    if (is_own(c, key)) out.push_back(c.describe(cases::InputError(key, what)));
  };
  for (std::size_t i = 0; i < law.size(); ++i) {
    if (!law[i]) tell("joint_laws", m.laws[i].name, "is the law of no joint");
  }
  for (std::size_t i = 0; i < material.size(); ++i) {
    if (!material[i]) tell("materials", m.materials[i].name, "is the material of no element");
  }
}

/// Warns of a component that is far weaker than the other: a factor of its own makes much of it, and a geometric mean little.
/// \param a, b  peaks as recorded
void look_at_ratio(const cases::MotionIntensity& of, double a, double b, std::vector<std::string>& out) {
  if (std::min(a, b) == 0.0 || std::min(a, b) >= kWeaker * std::max(a, b)) return;
  const std::string times = "one horizontal component is " + four_digits(std::max(a, b) / std::min(a, b)) + " times as strong as the other";
  if (of.components == cases::IntensityOf::geometric_mean)
    out.push_back("motion.intensity is a geometric mean, and " + times + "; motion.scale = [1, 0, 1] takes one away");
  if (of.components == cases::IntensityOf::each)
    out.push_back("motion.intensity brings each horizontal component to the level, and as recorded " + times +
                  "; motion.intensity.components = \"larger\" keeps their ratio");
}

/// Checks that the run reaches the intensity, which is that of the whole record, and that neither of two components is nearly still.
void look_at_intensity(const cases::Motion& m, const cases::GroundMotion& motion, double duration, std::vector<std::string>& out) {
  std::array<cases::Accelerogram, 3> components;
  for (std::size_t axis = 0; axis < 3; ++axis) components[component_along(m, axis)] = motion.axis[axis];
  std::array<cases::Accelerogram, 2> horizontal{components[0], components[1]};
  look_at_ratio(*m.intensity, figures(horizontal[0]).peak_acceleration / motion.factor[0],
                figures(horizontal[1]).peak_acceleration / motion.factor[1], out);
  const double step = std::max(horizontal[0].dt, horizontal[1].dt);
  if (m.intensity->measure == cases::IntensityMeasure::sa && *m.intensity->period < kStepsOfPeriod * step)
    out.push_back("motion.intensity.period = " + four_digits(*m.intensity->period) + " s is shorter than ten steps of the record (" +
                  four_digits(step) + " s): Sa comes out low there, so the motion comes out too strong");
  for (cases::Accelerogram& h : horizontal) {
    const double last = duration / (h.dt > 0.0 ? h.dt : 1.0);
    if (last + 1.0 < static_cast<double>(h.acceleration.size())) h.acceleration.resize(static_cast<std::size_t>(last) + 1);
  }
  const double reached = intensity(*m.intensity, horizontal[0], horizontal[1]);
  if (reached >= kMostOfLevel * m.intensity->level) return;
  std::string by_axis;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t k = component_along(m, axis);
    if (k < 2) by_axis += (by_axis.empty() ? "" : ", ") + four_digits(intensity(*m.intensity, horizontal[k], {})) + " along " + kAxes[axis];
  }
  out.push_back("motion.intensity: the whole record has " + described(*m.intensity) + ", but up to the end of the run, at " +
                four_digits(duration) + " s, it is " + four_digits(reached) + " (" + by_axis +
                "); motion.to cuts the record before it is measured");
}

void look_at_motion(const cases::Case& c, const cases::GroundMotion& motion, std::vector<std::string>& out) {
  if (is_assessment(c.analysis)) return;  // an assessment does not use the motion
  if (c.motion && c.motion->intensity) look_at_intensity(*c.motion, motion, c.time.duration, out);
  double end = 0.0;
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    const MotionFigures f = figures(motion.axis[axis]);
    end = std::max(end, f.duration);
    if (f.peak_acceleration <= kMostAcceleration && f.peak_velocity <= kMostVelocity && f.peak_displacement <= kMostDisplacement) continue;
    out.push_back("the motion along " + std::string(kAxes[axis]) + " is stronger than any record: peaks of " +
                  four_digits(f.peak_acceleration) + " m/s2, " + four_digits(f.peak_velocity) + " m/s and " +
                  four_digits(f.peak_displacement) + " m; are motion.unit, motion.dt, " +
                  (c.motion && c.motion->intensity ? "motion.intensity" : "motion.scale") + " and motion.baseline right?");
  }
  if (end > 0.0 && end < kMostOfRun * c.time.duration)
    out.push_back("the motion ends at " + four_digits(end) + " s: the ground is still until the run ends, at " +
                  four_digits(c.time.duration) + " s");
}

/// Finds points far off their element, as from a wrong unit.
void look_at_points(const LoadedCase& c, const cases::Model& m, std::vector<std::string>& out) {
  const auto tell = [&](const std::string& key, std::size_t element, Vec3 point) {
    const auto [low, high] = geometry::bounds(m.blocks[element].shape);
    const double away = cases::distance_outside(m.assembly, element, point), size = norm(high - low);
    if (away > size)
      out.push_back(
          c.describe(cases::InputError(key, "lies " + four_digits(away) + " m off " + cases::describe(m.blocks[element], element) +
                                                ", which is " + four_digits(size) + " m across")));
  };
  for (std::size_t i = 0; i < c.value.loads.size(); ++i) {
    const cases::Load& load = c.value.loads[i];
    if (!load.at || load.block.empty()) continue;
    for (const cases::LoadShare& s : cases::load_shares(m, load, i))
      tell(cases::indexed_key("load", i, "at"), static_cast<std::size_t>(s.element), *load.at);
  }
  if (const auto& control = c.value.analysis.control)
    tell("analysis.control", static_cast<std::size_t>(cases::nearest_element(m, *control)), *control);
}

/// Rafters without boards stand like dominoes: a push along the ridge finds them, and not the house.
void look_at_rafters(const LoadedCase& c, std::vector<std::string>& out) {
  const cases::Analysis& a = c.value.analysis;
  if (a.kind != cases::AnalysisKind::pushover && a.kind != cases::AnalysisKind::tilt) return;
  if (!c.value.house || c.value.house->roof.kind != cases::RoofKind::pitched || c.value.house->roof.deck) return;
  out.push_back(c.describe(cases::InputError(
      "house.roof.kind",
      "= \"pitched\" without house.roof.deck: nothing but their feet holds the rafters along the ridge, so a push that has "
      "a part along it may find the load at which they tip, not that of the house")));
}

}  // namespace

std::string four_digits(double v) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", v);
  return text.data();
}

/// A mode in words: "8.015 Hz (mode 1, 75.1 % of the mass in y)".
std::string mode_words(const solver::MainMode& m, std::size_t axis) {
  std::array<char, 80> text{};
  const std::string number = m.number == 0 ? "a mode above many local ones" : "mode " + std::to_string(m.number);
  std::snprintf(text.data(), text.size(), "%s Hz (%s, %.1f %% of the mass in %s)", four_digits(m.frequency).c_str(), number.c_str(),
                100.0 * m.mass_share, kAxes[axis]);
  return text.data();
}

std::vector<std::string> doubts_of_stones(const LoadedCase& c) {
  std::vector<std::string> out;
  for (std::size_t t = 0; t < c.value.stones.size(); ++t) {
    const std::string key = cases::indexed_key("stones", t, "file");
    for (const std::string& doubt : c.value.stones[t].doubts) out.push_back(c.describe(cases::InputError(key, doubt)));
  }
  return out;
}

std::vector<std::string> slips_of_model(const LoadedCase& c, const cases::Model& model) {
  std::vector<std::string> out = doubts_of_stones(c);
  for (std::string& rule : cases::unused_joint_rules(c.value, model)) out.push_back(std::move(rule));
  look_for_unused(c, model, out);
  for (const cases::InputError& e : unusual_sizes(c.value)) out.push_back(c.describe(e));
  if (c.value.house) {
    for (const cases::InputError& rod : cases::rods_in_openings(*c.value.house)) out.push_back(c.describe(rod));
    for (const cases::InputError& opening : cases::unsupported_heads(*c.value.house)) out.push_back(c.describe(opening));
  }
  for (const cases::InputError& opening : cases::wall_heads_without_lintel(c.value.walls)) out.push_back(c.describe(opening));
  for (const cases::InputError& wall : cases::wall_overhangs(c.value.walls, cases::spans_of(c.value))) out.push_back(c.describe(wall));
  look_at_points(c, model, out);
  look_at_rafters(c, out);
  return out;
}

std::vector<std::string> likely_slips(const LoadedCase& c, const cases::Model& model, const cases::GroundMotion& motion) {
  std::vector<std::string> out = slips_of_model(c, model);
  look_at_motion(c.value, motion, out);
  look_at_frequency(c.value, model, out);
  return out;
}

void warn_of(const std::vector<std::string>& findings) {
  for (const std::string& f : findings) say_warning(f);
}

}  // namespace voussoir::io
