// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <span>

#include "solver/analysis/modes.h"
#include "solver/run/run.h"
#include "tests/io/input/stones/written_files.h"

// A copy that is turned together with gravity, and moved, is the same structure.

namespace {

using namespace stones;
namespace solver = voussoir::solver;
namespace cases = voussoir::cases;

/// Keeps the first rows of cracks.
struct Cracks final : solver::Recorder {
  std::vector<solver::CrackRow> first;
  void history(double, std::span<const solver::HistorySample>) override {}
  void energy(const solver::EnergyRow&) override {}
  void forces(const solver::ForcesRow&) override {}
  void damage(const solver::DamageRow&) override {}
  void cracks(std::span<const solver::CrackRow> rows) override {
    if (first.empty()) first.assign(rows.begin(), rows.end());
  }
  void frame(const solver::FrameView&) override {}
  void summary(const solver::Summary&) override {}
};

struct Outcome {
  std::vector<double> frequencies;
  solver::CrackRow crack;
};

Outcome outcome_of(cases::Case c) {
  const cases::Model model = cases::build_model(c);
  solver::Options options;
  options.threads = 1;
  solver::Simulation sim(c, model, {}, options);
  Outcome out;
  for (const auto& mode : solver::natural_modes(sim.world(), 6)) out.frequencies.push_back(mode.frequency);
  Cracks cracks;
  solver::RunState plan;
  solver::run(sim, plan, c, 0.02, cracks, [&](const solver::RunStatus&) { return cracks.first.empty(); });
  REQUIRE(!cracks.first.empty());
  out.crack = cracks.first.front();
  return out;
}

}  // namespace

TEST_CASE("a copy turned together with gravity and moved by ten metres: the same frequencies and the same first crack") {
  const TempFolder folder;
  // Not symmetrical, so that one joint is the first.
  std::vector<Named> all = arch(13, 2.0, 2.4, 0.7);
  for (Named& n : all) {
    for (Vec3& v : n.mesh.vertices) v.x *= v.x > 0.0 ? 1.25 : 1.0;
  }
  const std::string file = folder.write("arch.obj", obj(all));
  const std::string law =
      "[joint_laws.weak]\ntension = 2500.0\ncohesion = 1e5\nfriction = 30.0\ncompression = 1e8\nthickness = 0.005\nyoung = 1e8\npoisson = "
      "0.2\n"
      "[gravity]\nramp = 0.5\n[time]\nduration = 0.02\n";
  const auto c = load(file, "joint = \"weak\"\nsupports = \"ground\"", law);
  const Outcome straight = outcome_of(c);

  const Vec3 axis{1.0, -2.0, 0.7}, by{7.0, -6.0, 3.5};
  const double angle = 51.0;
  auto t = voussoir::io::read_case({"t", kMaterial + law + "[[stones]]\nfile = \"" + file +
                                             "\"\nunit = \"m\"\njoint = \"weak\"\nsupports = [\"voussoir_0\", \"voussoir_12\"]\n" +
                                             "place = [7.0, -6.0, 3.5]\nturn = { axis = [1.0, -2.0, 0.7], angle = 51.0 }\n"})
               .value;
  voussoir::io::load_stones(t);
  const auto turned_vector = voussoir::geometry::rotated({{Vec3{0, 0, -9.8}}, {}}, axis, angle * M_PI / 180.0, {}).vertices[0];
  t.gravity.acceleration = turned_vector;
  const Outcome turned = outcome_of(t);
  CHECK(norm(by) < 10.0);

  REQUIRE(straight.frequencies.size() == turned.frequencies.size());
  double worst = 0.0;
  for (std::size_t i = 0; i < straight.frequencies.size(); ++i)
    worst = std::max(worst, std::abs(turned.frequencies[i] / straight.frequencies[i] - 1.0));
  MESSAGE("frequencies apart by " << worst << ", first crack at " << straight.crack.time << " s in joint " << straight.crack.joint);
  CHECK(worst < 1e-9);
  CHECK(turned.crack.joint == straight.crack.joint);
  CHECK(turned.crack.element_a == straight.crack.element_a);
  CHECK(turned.crack.mode == straight.crack.mode);
  CHECK(turned.crack.area == doctest::Approx(straight.crack.area).epsilon(1e-9));
  CHECK(turned.crack.time == doctest::Approx(straight.crack.time).epsilon(1e-3));
}
