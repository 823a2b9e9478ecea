// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <stdexcept>
#include <string>

#include "solver/run/run.h"
#include "tests/solver/small_wall.h"

// A recorder that fails, as one that writes to a full disk does.

using namespace voussoir;
using namespace voussoir::testing;

namespace {

/// Takes rows up to a time, and then none.
class FullDisk final : public solver::Recorder {
 public:
  explicit FullDisk(double histories_until) : histories_until_(histories_until) {}

  void history(double time, std::span<const solver::HistorySample>) override {
    if (time < histories_until_) return;
    full = true;
    throw std::runtime_error("no room for histories");
  }
  void energy(const solver::EnergyRow&) override {}
  void forces(const solver::ForcesRow&) override {}
  void damage(const solver::DamageRow&) override {}
  void cracks(std::span<const solver::CrackRow>) override {
    if (!full && histories_until_ < kNever) return;
    ++refused;
    throw std::runtime_error("no room for cracks");
  }
  void frame(const solver::FrameView&) override {}
  void summary(const solver::Summary&) override { ++summaries; }

  static constexpr double kNever = 1e9;  // s
  bool full = false;
  int refused = 0, summaries = 0;

 private:
  double histories_until_;  // s
};

/// A wall with a brick on its way out of it.
cases::Case struck_wall() {
  cases::Case c = small_wall(3, 4, 1e-2);
  c.blocks.back().velocity = {0.0, 3.0, 0.0};
  return c;
}

std::string failure_of(FullDisk& out) {
  const cases::Case c = struck_wall();
  const cases::Model m = cases::build_model(c);
  solver::Simulation sim(c, m, {}, {});
  solver::RunState plan;
  try {
    solver::run(sim, plan, c, 0.05, out, [](const solver::RunStatus&) { return true; });
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "none";
}

}  // namespace

TEST_CASE("cracks that a recorder could not write are not told it again: it has them") {
  FullDisk out(FullDisk::kNever);
  CHECK(failure_of(out) == "no room for cracks");
  CHECK(out.refused == 1);
  CHECK(out.summaries == 1);
}

TEST_CASE("of two failures the first, which stops the run, is the one that its caller hears of") {
  FullDisk out(0.01);
  CHECK(failure_of(out) == "no room for histories");
  CHECK(out.refused == 1);  // the cracks up to there were offered
  CHECK(out.summaries == 1);
}
