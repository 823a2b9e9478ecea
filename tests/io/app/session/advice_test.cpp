// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/session/words/advice.h"

#include <doctest/doctest.h>

#include <optional>
#include <string>

#include "io/app/session/run_time.h"
#include "solver/setup/setup.h"
#include "tests/solver/small_wall.h"

// How long a run takes, and what would have made it faster.

using namespace voussoir;
using namespace voussoir::testing;

namespace {

/// A wall with timber in and on it: elements of several steps.
struct TimberWall {
  explicit TimberWall(int multirate = 1) { c.time.multirate = multirate; }
  cases::Case c = mixed_wall(4, 40);
  cases::Model m = cases::build_model(c);
  cases::GroundMotion g;
};

/// Of 100 s of wall-clock time: 10 s of settling, then 9 s for each of ten seconds of shaking.
io::RunClock clock_of(double output = 0.0) {
  io::RunClock clock;
  const auto stages = [&](double all) { return solver::StageTimes{0.05 * all, 0.85 * all, 0.0, 0.1 * all, 0.0, output * all}; };
  clock.note(-1.0, true, 0.0, stages(0.0));
  clock.note(-0.1, true, 10.0, stages(10.0));
  for (int k = 0; k <= 100; ++k) clock.note(0.1 * k, false, 10.0 + 0.9 * k, stages(10.0 + 0.9 * k));
  return clock;
}

bool has(const std::string& text, const char* words) { return text.find(words) != std::string::npos; }

}  // namespace

TEST_CASE("advice: time after a moment of the run, and of the shaking by stage") {
  const io::RunClock clock = clock_of();
  CHECK(clock.total() == doctest::Approx(100.0));
  CHECK(clock.after(4.0) == doctest::Approx(54.0).epsilon(0.03));
  CHECK(clock.after(11.0) == 0.0);
  CHECK(nth(clock.shaking(), solver::Stage::forces) == doctest::Approx(0.85 * 90.0));
}

TEST_CASE("advice: a run is told to end after its collapse, and to use several rates where that saves a tenth") {
  TimberWall w;
  w.c.time.step = 5e-5;
  const solver::Simulation sim(w.c, w.m, w.g, {});
  const std::string late = io::advice_lines(w.c, sim, clock_of(), 4.0);
  CHECK(has(late, "with time.after_collapse = 1 the run would have ended at 5 s and taken 45 s less of 1 min 40 s"));
  CHECK(has(late, "time.multirate = "));
  CHECK(!has(late, "frames"));
  CHECK(!has(io::advice_lines(w.c, sim, clock_of(), -1.0), "after_collapse"));  // it never collapsed
  CHECK(!has(io::advice_lines(w.c, sim, clock_of(), 8.5), "after_collapse"));   // little came later
  CHECK(has(io::advice_lines(w.c, sim, clock_of(0.2), -1.0), "writing frames and rows of results took 18 % of the time"));
  w.c.time.after_collapse = 2.0;
  CHECK(!has(io::advice_lines(w.c, sim, clock_of(), 4.0), "after_collapse"));
  io::RunClock brief;
  brief.note(0.0, false, 0.0, {});
  brief.note(10.0, false, 19.0, {});
  CHECK(io::advice_lines(w.c, sim, brief, 1.0).empty());
}

TEST_CASE("advice: a run at several rates, and one of elements that all allow the same step, are told of no other rate") {
  const TimberWall fast(4);
  const solver::Simulation rates(fast.c, fast.m, fast.g, {});
  CHECK(!has(io::advice_lines(fast.c, rates, clock_of(), -1.0), "multirate"));
  const cases::Case alike = small_wall(4, 6);
  const cases::Model m = cases::build_model(alike);
  const solver::Simulation one(alike, m, {}, {});
  CHECK(!has(io::advice_lines(alike, one, clock_of(), -1.0), "multirate"));
}

TEST_CASE("the share of elements evaluated is that of the levels that the run has") {
  TimberWall w;
  w.c.time.step = 5e-5;
  const solver::Simulation one(w.c, w.m, w.g, {});
  CHECK(solver::share_evaluated(one.world(), w.c, 1) == 1.0);
  for (const int multirate : {2, 4}) {
    TimberWall other(multirate);
    other.c.time.step = 5e-5;
    const solver::Simulation sim(other.c, other.m, other.g, {});
    const solver::Multirate& rates = sim.world().multirate;
    double sum = 0.0, moving = 0.0;
    for (std::size_t e = 0; e < other.m.blocks.size(); ++e) {
      if (sim.world().elements.fixed[e]) continue;
      sum += 1.0 / rates.steps_of(rates.of_joints[e]), moving += 1.0;
    }
    const std::optional<double> share = solver::share_evaluated(one.world(), w.c, multirate);
    REQUIRE(share);
    CHECK(*share == doctest::Approx(sum / moving));
    CHECK(*share < 1.0);
  }
  w.c.analysis.kind = cases::AnalysisKind::pushover;  // has one rate
  CHECK(!solver::share_evaluated(one.world(), w.c, 4));
}

TEST_CASE("the time of a run grows with its steps; at several rates a collapse takes less, by the share evaluated") {
  TimberWall one, four(4);
  one.c.time.step = four.c.time.step = 5e-5;
  one.c.set_end(10.0), four.c.set_end(10.0);
  const solver::Simulation at_one(one.c, one.m, one.g, {}), at_four(four.c, four.m, four.g, {});
  const io::RunTime t = io::run_time(one.c, at_one, 1e-4, 1e-4), u = io::run_time(four.c, at_four, 0.5e-4, 1e-4);
  const double settling = one.c.gravity.settle ? t.intact - 10.0 / 5e-5 * 1e-4 : 0.0;
  CHECK(t.collapse == doctest::Approx(settling + 10.0 * 10.0 / 5e-5 * 1e-4));
  CHECK(u.intact == doctest::Approx(settling + 10.0 / 5e-5 * 0.5e-4));
  const double share = solver::share_evaluated(at_four.world(), four.c, 4).value();
  CHECK(u.collapse == doctest::Approx(settling + 10.0 * (0.3 + 0.7 * share) * 10.0 / 5e-5 * 1e-4));
}

TEST_CASE("other rates are those that the case does not have; an analysis has none") {
  TimberWall w;
  const auto tried = [&] {
    std::vector<int> rates;
    for (const io::RateTime& r : io::other_rates(w.c, w.m, w.g, {}, 1e-4)) {
      CHECK(r.time.intact > 0.0);
      rates.push_back(r.multirate);
    }
    return rates;
  };
  CHECK(tried() == std::vector<int>{2, 4, 8});
  w.c.time.multirate = 4;
  CHECK(tried() == std::vector<int>{1, 2, 8});
  w.c.analysis.kind = cases::AnalysisKind::pushover;
  CHECK(tried().empty());
}

TEST_CASE("a case at several rates settles at one, which is timed apart") {
  TimberWall one, four(4);
  const solver::Simulation at_one(one.c, one.m, one.g, {}), at_four(four.c, four.m, four.g, {});
  CHECK(io::one_rate_step(one.c, one.m, one.g, at_one, 1e3) == 1e3);
  CHECK(io::one_rate_step(four.c, four.m, four.g, at_four, 1e3) < 1e3);
}

TEST_CASE("a step is timed while the model is shaken, also where it would settle first") {
  TimberWall w;
  w.c.gravity.settle = true;
  solver::Simulation sim(w.c, w.m, w.g, {});
  REQUIRE(sim.phase() == solver::Phase::settling);
  CHECK(io::shaken_step(w.c, sim) > 0.0);
  CHECK(sim.phase() == solver::Phase::shaking);
  // An analysis by dynamics chooses its load after settling.
  w.c.analysis.kind = cases::AnalysisKind::pushover, w.c.analysis.solver = cases::Solver::dynamics;
  solver::Simulation slow(w.c, w.m, w.g, {});
  CHECK(io::shaken_step(w.c, slow) > 0.0);
  CHECK(slow.phase() == solver::Phase::settling);
}
