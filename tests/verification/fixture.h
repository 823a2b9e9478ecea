// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cases/census.h"
#include "cases/model.h"
#include "io/input/case_file/case_file.h"
#include "io/input/motion/motion_files.h"
#include "kernels/integrate.h"
#include "solver/contact/contact_forces.h"
#include "solver/contact/contact_lists.h"
#include "solver/run/simulation.h"
#include "solver/setup/setup.h"
#include "tests/verification/manual.h"

/// What the verification tests share: a case of cases/verification, stepped in-process, and the constants of the closed forms.
namespace voussoir::testing {

inline constexpr double kGravity = 9.8;  // m/s2
inline constexpr double kPi = 3.14159265358979323846;

/// The adobe of the cases.
struct Adobe {
  static constexpr double density = 1800.0, young = 9.8e7, poisson = 0.25;
  static constexpr double plane = young / (1.0 - poisson * poisson);  // E'
  static constexpr double shear = young / (2.0 * (1.0 + poisson));    // G
  static double speed() { return std::sqrt(plane / density); }        // c_L
};

inline double radians(double degrees) { return degrees * kPi / 180.0; }
inline double relative_error(double got, double expected) { return std::abs(got - expected) / std::abs(expected); }

/// Rows of the manual: what was expected, what came out, and the limit it must keep. The limits are those of the specification.
inline void expect_near(const std::string& what, double got, double expected, double limit) {
  const double error = relative_error(got, expected);
  MESSAGE(what, ": expected ", expected, ", got ", got, ", error ", error, ", limit ", limit);
  write(ManualRow{what, "relative", expected, got, error, limit});
  CHECK_MESSAGE(error <= limit, what);
}
inline void expect_within(const std::string& what, double got, double expected, double limit) {
  const double error = std::abs(got - expected);
  MESSAGE(what, ": expected ", expected, ", got ", got, ", off by ", error, ", limit ", limit);
  write(ManualRow{what, "absolute", expected, got, error, limit});
  CHECK_MESSAGE(error <= limit, what);
}
/// Rows that are known to miss and fail no test; scripts/verify says when that changes (known_misses.txt).
inline void report_within(const std::string& what, double got, double expected, double limit) {
  const double error = std::abs(got - expected);
  MESSAGE(what, ": expected ", expected, ", got ", got, ", off by ", error, ", limit ", limit);
  write(ManualRow{what, "absolute", expected, got, error, limit});
}
inline void report_near(const std::string& what, double got, double expected, double limit) {
  const double error = relative_error(got, expected);
  MESSAGE(what, ": expected ", expected, ", got ", got, ", error ", error, ", limit ", limit);
  write(ManualRow{what, "relative", expected, got, error, limit});
}
inline void expect_below(const std::string& what, double got, double limit) {
  MESSAGE(what, ": got ", got, ", limit ", limit);
  write(ManualRow{what, "at most", 0.0, got, got, limit});
  CHECK_MESSAGE(got <= limit, what);
}

/// The kernel set under test: `fast`, or as VOUSSOIR_KERNELS says.
inline bool reference_kernels() {
  const char* set = std::getenv("VOUSSOIR_KERNELS");
  return set != nullptr && std::string_view(set) == "reference";
}

/// With VOUSSOIR_MULTIRATE=k: the case with time.multirate = k, in k-th parts of its step, so that its pairs take that step as before; a
/// pair that allows less is evaluated more often. Else the case as it is, and so if it loads slowly.
inline cases::Case with_rates(cases::Case c) {
  const char* wanted = std::getenv("VOUSSOIR_MULTIRATE");
  if (wanted == nullptr || cases::is_assessment(c.analysis)) return c;
  const cases::Model m = cases::build_model(c);
  const double step = solver::choose_step(c, {}, cases::census(m).step_bound);
  c.time.multirate = std::atoi(wanted);
  c.time.step = step / c.time.multirate;
  return c;
}

inline io::LoadedCase load(const std::string& name, const std::vector<std::string>& overrides = {}) {
  note_case(name);
  return io::load_case(std::string(VOUSSOIR_SOURCE_DIR) + "/cases/verification/" + name + ".toml", overrides);
}

/// One case, built and ready to step. State is read before a step: displacements belong to time(), velocities to half a step earlier.
class Run {
 public:
  explicit Run(const std::string& name, const std::vector<std::string>& overrides = {}) : Run(load(name, overrides).value) {}
  explicit Run(cases::Case c) : case_(with_rates(std::move(c))), model_(cases::build_model(case_)) {
    if (case_.motion) motion_ = io::load_motion(*case_.motion, case_.folder);
    solver::Options options;
    options.threads = 1;
    options.reference_kernels = reference_kernels();
    sim_ = std::make_unique<solver::Simulation>(case_, model_, motion_, options);
    if (sim_->phase() == solver::Phase::shaking) sim_->start_shaking();
  }

  /// Settles under gravity; returns whether rest was reached.
  bool settle() {
    while (!sim_->at_rest() && !sim_->settled_too_long()) sim_->step({false, sim_->steps() % 20 == 0});
    const bool rest = sim_->at_rest();
    sim_->start_shaking();
    return rest;
  }

  /// One step, or with several rates all steps of a cycle. With `due` the results are those of its first, where rows of energies stand.
  void cycle(solver::Due due) {
    sim_->step(due);
    for (std::int64_t k = 1; k < sim_->cycle(); ++k) sim_->step({});
  }

  /// Steps until `end` [s]; `each` sees the state at time() before every step, or every cycle of multi-rate stepping. With `due` the
  /// results of the last step are behind it.
  template <class Each>
  void until(double end, solver::Due due, const Each& each) {
    while (sim_->time() < end - 0.5 * sim_->dt()) {
      each();
      cycle(due);
    }
  }
  void until(double end) {
    until(end, {}, [] {});
  }

  [[nodiscard]] double time() const { return sim_->time(); }
  [[nodiscard]] Vec3 displacement(std::size_t i) const {
    const solver::Elements& e = sim_->world().elements;
    return {e.ux[i], e.uy[i], e.uz[i]};
  }
  [[nodiscard]] Vec3 velocity(std::size_t i) const {
    const solver::Elements& e = sim_->world().elements;
    return {e.vx[i], e.vy[i], e.vz[i]};
  }
  [[nodiscard]] Vec3 spin(std::size_t i) const {
    const solver::Elements& e = sim_->world().elements;
    return {e.wx[i], e.wy[i], e.wz[i]};
  }
  [[nodiscard]] Vec3 angular_momentum(std::size_t i) const {
    const solver::Elements& e = sim_->world().elements;
    return {e.lx[i], e.ly[i], e.lz[i]};
  }
  [[nodiscard]] Vec3 position(std::size_t i) const {
    const solver::Elements& e = sim_->world().elements;
    return e.body[i].ref + displacement(i);
  }
  [[nodiscard]] Quaternion orientation(std::size_t i) const {
    const solver::Elements& e = sim_->world().elements;
    return {e.qw[i], e.qx[i], e.qy[i], e.qz[i]};
  }
  [[nodiscard]] double mass(std::size_t i) const { return sim_->world().elements.mass[i]; }
  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(sim_->world().elements.count); }

  [[nodiscard]] solver::Simulation& sim() { return *sim_; }
  [[nodiscard]] const solver::Simulation& sim() const { return *sim_; }
  [[nodiscard]] const cases::Case& description() const { return case_; }
  [[nodiscard]] const cases::GroundMotion& motion() const { return motion_; }

 private:
  cases::Case case_;
  cases::Model model_;
  cases::GroundMotion motion_;
  std::unique_ptr<solver::Simulation> sim_;
};

/// Puts an element where the test wants it, unturned, with the velocity of the half step behind: a test by imposed displacement.
inline void place(Run& run, std::size_t i, Vec3 u, Vec3 v) {
  solver::Elements& e = run.sim().world().elements;
  const double moved = norm(u - Vec3{e.ux[i], e.uy[i], e.uz[i]}) + 2.0 * e.radius[i];  // at most, however far it turns back
  e.ux[i] = u.x, e.uy[i] = u.y, e.uz[i] = u.z;
  e.vx[i] = v.x, e.vy[i] = v.y, e.vz[i] = v.z;
  e.qw[i] = 1.0, e.qx[i] = e.qy[i] = e.qz[i] = 0.0;
  for (auto* column : {&e.lx, &e.ly, &e.lz, &e.wx, &e.wy, &e.wz}) (*column)[i] = 0.0;
  kernels::drift(e.view(), run.sim().world().element_rows(), 0.0, 0, e.rows);  // rows follow from the state
  // No way that bodies have gone tells of this.
  solver::World& w = run.sim().world();
  solver::list_candidates(w);
  w.travel.activate(e, static_cast<std::int32_t>(i));
  w.travel.add(static_cast<std::int32_t>(i), moved);
}

/// Stores of a row: what contact may take from, never add to.
inline double mechanical(const solver::EnergyRow& e) { return e.kinetic + e.strain + e.contact + e.gravity; }

/// Times at which a signal rises through zero, interpolated linearly.
class RisingZeros {
 public:
  void add(double time, double value) {
    if (started_ && last_ < 0.0 && value >= 0.0) times_.push_back(last_time_ + (time - last_time_) * last_ / (last_ - value));
    started_ = true, last_time_ = time, last_ = value;
  }
  /// Mean frequency [Hz] between the first and the last.
  [[nodiscard]] double frequency() const {
    REQUIRE(times_.size() >= 2);
    return static_cast<double>(times_.size() - 1) / (times_.back() - times_.front());
  }

 private:
  bool started_ = false;
  double last_time_ = 0.0, last_ = 0.0;
  std::vector<double> times_;
};

}  // namespace voussoir::testing
