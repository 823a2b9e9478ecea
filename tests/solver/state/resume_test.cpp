// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <random>
#include <set>

#include "solver/run/run.h"
#include "solver/state/saved_state.h"
#include "solver/world/errors.h"
#include "tests/solver/row_hash.h"
#include "tests/solver/small_wall.h"

// A run that is saved, thrown away, built anew and gone on with has the bits of one that was never stopped. This is also the proof that the
// field table is complete: an array that is state and not in the table makes these tests fail.

using namespace voussoir;
using namespace voussoir::testing;

namespace {

/// A wall with timber and with joints of one and two sides that settles, cracks and falls, pushed by a load and by a moving support: every
/// piece of state there is.
cases::Case everything(int courses = 8) {
  cases::Case c = mixed_wall(4, courses);
  c.gravity.settle = true;
  c.gravity.ramp = 0.05;
  c.gravity.settle_limit = 0.05;
  c.damping.debris = false;
  c.time.step = 2e-4;
  c.output.frame_interval = 0.01;
  c.output.history = {{"top", {0.4, 0.05, 0.75}}, {"foot", {0.1, 0.05, 0.05}}};
  cases::BlockSpec pusher;
  pusher.name = "pusher", pusher.material = "adobe", pusher.fixed = true;
  pusher.box = {{Vec3{0.2, -0.1, 0.6}, Vec3{0.6, 0.0, 0.7}}};
  pusher.motion = cases::SupportMotion{Vec3{0.0, 0.05, 0.0}, std::nullopt};
  c.blocks.push_back(pusher);
  cases::Load load;
  load.block = "c7_1", load.force = {0.0, 30.0, 0.0}, load.moment = {1.0, 0.0, 0.5}, load.ramp = {0.0, 0.3};
  c.loads.push_back(load);
  cases::JointLaw& mortar = c.joint_laws["mortar"];  // bonds that soften; nails do not
  mortar.fracture_energy_tension = 0.1, mortar.fracture_energy_shear = 0.2, mortar.dilatancy = 10.0;
  c.contact.compression = 2e4, c.contact.residual_compression = 4e3, c.contact.crushing_energy = 2.0, c.contact.crushing_depth = 2e-3;
  // One that yields, one under pretension that breaks, one that goes slack.
  c.ties.push_back({.name = "rod", .from = {0.1, 0.05, 0.05}, .to = {0.5, 0.05, 0.75}, .area = 1e-6, .young = 2e9, .yield = 2e5});
  c.ties.push_back({.name = "wire",
                    .from = {0.7, 0.05, 0.05},
                    .to = {0.3, 0.05, 0.75},
                    .area = 1e-6,
                    .young = 2e9,
                    .elongation = 0.02,
                    .pretension = 5.0});
  c.ties.push_back({.name = "cable", .from = {0.1, 0.05, 0.0}, .to = {0.1, 0.05, 0.65}, .area = 1e-7, .young = 2e9});
  return c;
}

constexpr double kEnd = 0.7;  // s

/// What is compared: all rows, and all fields of the state.
struct Outcome {
  std::array<std::uint64_t, 6> hashes{}, rows{};
  solver::SavedState state;
  solver::Summary summary;
  std::int64_t retired = 0, searches = 0, touching = 0;
  std::vector<kernels::TieState> ties;
  std::ptrdiff_t crushed_in_joints = 0, crushed_on_patches = 0;  // points
};

/// Lanes that no side has count as retired from the start.
std::ptrdiff_t retired_of(const solver::Sides& s) {
  std::ptrdiff_t n = 0;
  for (std::size_t id = 0; id < s.joint.size(); ++id) n += s.joint[id] >= 0 && s.retired[id] == 1;
  return n;
}

/// A run stopped whenever its steps pass one of `stops`, and gone on with in a new simulation by the next number of threads.
Outcome run_with_stops(const cases::Case& c, std::set<std::int64_t> stops, const std::vector<int>& threads, solver::Options o = {},
                       double end = kEnd) {
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion g = strong_shaking();
  RowHash out;
  solver::SavedState saved;
  for (std::size_t leg = 0;; ++leg) {
    o.threads = threads[leg % threads.size()];
    solver::Simulation sim(c, m, g, o);
    solver::RunState plan;
    if (leg > 0) solver::restore(sim, plan, saved);
    const auto stop = [&](const solver::RunStatus& s) {
      if (stops.empty() || s.step < *stops.begin()) return true;
      while (!stops.empty() && s.step >= *stops.begin()) stops.erase(stops.begin());
      return false;
    };
    const solver::RunResult r = solver::run(sim, plan, c, end, out, stop);
    saved = solver::save(sim, plan);
    if (r.stopped) continue;
    const solver::World& w = sim.world();
    return {out.values(),
            out.rows,
            saved,
            r.summary,
            retired_of(w.sides),
            w.contacts.searches,
            std::count_if(w.patches.patch.begin(), w.patches.patch.end(), [](const auto& p) { return p.touching > 0; }),
            w.ties.state,
            std::ranges::count_if(*w.sides.state_of_law("segment_crushed"), [](double x) { return x > 0.0; }),
            std::ranges::count_if(w.patches.crushed, [](double x) { return x > 0.0; })};
  }
}

/// Names of the fields in which two states differ.
std::string difference(const solver::SavedState& a, const solver::SavedState& b) {
  std::string names;
  REQUIRE(a.size() == b.size());
  for (const auto& [name, f] : a) {
    if (f.bytes != b.at(name).bytes) names += name + " ";
  }
  return names;
}

void check_same(const Outcome& a, const Outcome& b) {
  CHECK(difference(a.state, b.state) == "");
  CHECK(a.rows == b.rows);
  CHECK(a.hashes == b.hashes);
  CHECK(a.summary.first_crack_time == b.summary.first_crack_time);
  CHECK(a.summary.peak_base_shear == b.summary.peak_base_shear);
  CHECK(a.summary.worst_residual == b.summary.worst_residual);
}

}  // namespace

TEST_CASE("with contact.restitution a run that is stopped and gone on with by another number of threads has the same bits") {
  cases::Case c = everything();
  c.contact.restitution = 0.4;
  const Outcome straight = run_with_stops(c, {}, {1});
  const auto pressed = straight.state.find("point_pressed");
  REQUIRE(pressed != straight.state.end());
  CHECK(std::ranges::any_of(pressed->second.bytes, [](auto byte) { return byte != decltype(byte){}; }));
  MESSAGE("residual ", straight.summary.worst_residual, ", without ", run_with_stops(everything(), {}, {1}).summary.worst_residual);
  check_same(straight, run_with_stops(c, {1500, 2500, 3300}, {2, 1}));
}

TEST_CASE("a run that is stopped and gone on with has the bits of one that is not, in settling, cracking and collapse") {
  const cases::Case c = everything();
  const Outcome straight = run_with_stops(c, {}, {1});
  // The run has what the test is about.
  CHECK(straight.retired > 20);
  CHECK(straight.touching > 0);
  CHECK(straight.searches > 20);
  CHECK(straight.summary.first_crack_time >= 0.0);
  CHECK(straight.summary.fallen_mass_fraction > 0.1);
  CHECK(straight.crushed_in_joints > 0);
  CHECK(straight.crushed_on_patches > straight.crushed_in_joints / 2);
  CHECK(straight.ties[0].plastic > 0.0);
  CHECK(straight.ties[1].broken == 1);
  const std::int64_t all = 500 + std::int64_t(kEnd / 2e-4) + 1;  // 0.1 s of settling at most
  SUBCASE("at the very beginning") { check_same(straight, run_with_stops(c, {0}, {1})); }
  SUBCASE("while it settles") { check_same(straight, run_with_stops(c, {20, 300, 480}, {1, 2})); }
  SUBCASE("where shaking begins") { check_same(straight, run_with_stops(c, {500, 520}, {2, 1})); }
  SUBCASE("many times, by other numbers of threads") {
    std::mt19937 random(3);
    std::set<std::int64_t> stops;
    for (int i = 0; i < 12; ++i) stops.insert(std::uniform_int_distribution<std::int64_t>(0, all)(random));
    check_same(straight, run_with_stops(c, stops, {1, 2, 3, 8}));
  }
  SUBCASE("at several rates, stopped within cycles") {
    cases::Case two = everything(14);
    two.time.step = 5e-5, two.time.multirate = 4;
    const Outcome whole = run_with_stops(two, {}, {1}, {}, 0.45);
    CHECK(whole.retired > 5);
    check_same(whole, run_with_stops(two, {40, 1300, 2000, 3020, 4040, 5060, 6080}, {2, 1, 3}, {}, 0.45));
  }
  SUBCASE("with plain kernels") {
    solver::Options plain;
    plain.reference_kernels = true;
    check_same(run_with_stops(c, {}, {1}, plain), run_with_stops(c, {700, 2000}, {2}, plain));
  }
}

TEST_CASE("a wall of bricks in cells that is stopped and gone on with has the same bits, while bricks split and crush") {
  cases::Case c = everything();
  c.materials["adobe"].inside = "brick";
  c.joint_laws["brick"] = c.joint_laws["mortar"];
  for (cases::BlockSpec& b : c.blocks)
    if (!b.fixed && b.material == "adobe") b.cells = cases::CellCounts{2, 1, 2};
  c.time.step = 1e-4;
  const Outcome straight = run_with_stops(c, {}, {1}, {}, 0.45);
  CHECK(straight.retired > 20);
  CHECK(straight.crushed_in_joints > 0);
  check_same(straight, run_with_stops(c, {700, 2500, 3300, 4100}, {2, 1}, {}, 0.45));
}

TEST_CASE("a run ends so long after the collapse as the case says, and is told of its last step, wherever it was stopped") {
  cases::Case c = everything();
  const auto collapse_of = [](const Outcome& o) {
    double time = 0.0;
    std::memcpy(&time, o.state.at("plan_collapse").bytes.data(), sizeof time);
    return time;
  };
  const Outcome whole = run_with_stops(c, {}, {1}, {}, 1.4);
  const double collapse = collapse_of(whole);
  REQUIRE(collapse > 0.3);
  REQUIRE(collapse < 1.2);
  CHECK(whole.summary.end_time == doctest::Approx(1.4 + 2e-4));
  const auto frame = std::llround(collapse / *c.output.frame_interval);
  CHECK(collapse == doctest::Approx(static_cast<double>(frame) * *c.output.frame_interval));

  c.time.after_collapse = 0.1;
  const Outcome cut = run_with_stops(c, {}, {1}, {}, 1.4);
  CHECK(collapse_of(cut) == collapse);
  CHECK(cut.summary.end_time == doctest::Approx(collapse + 0.1 + 2e-4));
  const auto seen = std::llround(cut.summary.end_time / 2e-4) - 500;  // about, since settling has steps of its own
  check_same(cut, run_with_stops(c, {seen, seen + 250, seen + 600, seen + 800, seen + 1000}, {2, 1}, {}, 1.4));

  c.time.after_collapse = 0.0;
  CHECK(run_with_stops(c, {}, {1}, {}, 1.4).summary.end_time == doctest::Approx(collapse + 2 * 2e-4));
  c.time.after_collapse = 10.0;
  CHECK(difference(whole.state, run_with_stops(c, {}, {1}, {}, 1.4).state) == "");
  CHECK(run_with_stops(c, {}, {1}, {}, 0.2).summary.end_time == doctest::Approx(0.2 + 2e-4));
}

TEST_CASE("the last frame shows the end, whether its interval meets it or not") {
  cases::Case c = small_wall(3, 4);
  c.output.frame_interval = 0.02;
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion g = strong_shaking();
  for (const double end : {0.1, 0.107}) {
    solver::Simulation sim(c, m, g, {});
    solver::RunState plan;
    RowHash out;
    solver::run(sim, plan, c, end, out, [](const solver::RunStatus&) { return true; });
    CHECK(out.rows[5] == (end > 0.1 ? 7U : 6U));
    CHECK(out.last_frame == doctest::Approx(out.last.end_time - sim.dt()));
    CHECK(std::abs(out.last_frame - end) <= 0.5 * sim.dt());
  }
}

TEST_CASE("a run that ended goes on to a later end, as if it had been meant from the start") {
  cases::Case c = small_wall(3, 4);
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion g = strong_shaking();
  const auto never = [](const solver::RunStatus&) { return true; };
  RowHash straight, extended;
  {
    solver::Simulation sim(c, m, g, {});
    solver::RunState plan;
    solver::run(sim, plan, c, 0.2, straight, never);
  }
  solver::SavedState last;
  {
    // Before its last step, since that has a frame and a row of the ledger that a longer run may not have.
    solver::Simulation sim(c, m, g, {});
    solver::RunState plan;
    solver::run(sim, plan, c, 0.1037, extended, [&](const solver::RunStatus& s) { return !s.last; });
    CHECK(sim.steps() == solver::last_step(sim, 0.1037));
    last = solver::save(sim, plan);
  }
  solver::Simulation sim(c, m, g, {});
  solver::RunState plan;
  solver::restore(sim, plan, last);
  solver::run(sim, plan, c, 0.2, extended, never);
  CHECK(straight.values() == extended.values());
}

TEST_CASE("a state of another model, or with numbers that cannot be, is refused with the field's name") {
  const cases::Case c = everything();
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion g = strong_shaking();
  solver::Simulation sim(c, m, g, {});
  solver::RunState plan;
  RowHash out;
  solver::run(sim, plan, c, kEnd, out, [](const solver::RunStatus& s) { return s.step < 3000; });
  const solver::SavedState good = solver::save(sim, plan);
  const auto refusal = [&](const char* name, const std::function<void(solver::SavedField&)>& spoil) -> std::string {
    solver::SavedState bad = good;
    spoil(bad.at(name));
    solver::Simulation other(c, m, g, {});
    solver::RunState again;
    try {
      solver::restore(other, again, bad);
    } catch (const solver::StateError& e) {
      return e.what();
    }
    return {};
  };
  const auto put = [](auto value, std::size_t at) {
    return [=](solver::SavedField& f) { std::memcpy(f.bytes.data() + at * sizeof value, &value, sizeof value); };
  };
  CHECK(refusal("ux", put(std::numeric_limits<double>::quiet_NaN(), 3)).find("ux") != std::string::npos);
  CHECK(refusal("side_quick", put(std::uint8_t{4}, 0)).find("side_quick") != std::string::npos);
  CHECK(refusal("segment_bond", put(std::uint8_t{255}, 1)).find("allowed: 0 to 3") != std::string::npos);
  CHECK(refusal("point_partner", put(std::int32_t{1 << 20}, 0)).find("point_partner") != std::string::npos);
  CHECK(refusal("point_face", put(std::int32_t{0}, 0)).find("point_face") != std::string::npos);
  CHECK(refusal("slot_element", put(std::int32_t{-1}, 0)).find("slot_element") != std::string::npos);
  CHECK(refusal("active_first_slot", put(std::int64_t{1}, 0)).find("active_first_slot") != std::string::npos);
  CHECK(refusal("patch_from_side", put(std::int32_t{5}, 0)).find("patch_from_side") != std::string::npos);
  CHECK(refusal("phase", put(std::uint8_t{9}, 0)).find("phase") != std::string::npos);
  CHECK(refusal("damage", put(std::numeric_limits<std::int64_t>::min(), 0)).find("damage") != std::string::npos);
  CHECK(refusal("vx", [](auto& f) { f.bytes.resize(8), f.count = 1; }).find("this model has") != std::string::npos);
  solver::SavedState lacking = good;
  lacking.erase("wx");
  solver::Simulation other(c, m, g, {});
  CHECK_THROWS_WITH_AS(solver::restore(other, plan, lacking), "field wx is missing", solver::StateError);
}

TEST_CASE("the hash of a model sees what a case changes") {
  cases::Case c = small_wall(2, 2);
  const auto hash = [&] {
    const cases::Model m = cases::build_model(c);
    return solver::model_hash(solver::Simulation(c, m, {}, {}).world());
  };
  const std::uint64_t first = hash();
  CHECK(hash() == first);
  c.joint_laws["mortar"].tension *= 1.0 + 1e-15;
  CHECK(hash() != first);
}

TEST_CASE("a run whose model has forgotten its joints has the bits of one whose model has them") {
  for (const int multirate : {1, 4}) {
    cases::Case c = everything();
    c.time.multirate = multirate;
    const cases::GroundMotion g;
    cases::Model forgetful = cases::build_model(c);
    const cases::Model m = cases::build_model(c);
    solver::Simulation with(c, m, g, {}), without(c, forgetful, g, {});
    cases::forget_joints(forgetful);
    CHECK(forgetful.assembly.joints.empty());
    for (solver::Simulation* sim : {&with, &without}) {
      sim->start_shaking();
      while (sim->time() < 0.3) sim->step({true, true});
    }
    CHECK(with.damage().tension > 100);
    solver::RunState plan;
    const solver::SavedState a = solver::save(with, plan), b = solver::save(without, plan);
    for (const auto& [name, field] : a) {
      CAPTURE(name);
      CHECK(field.bytes == b.at(name).bytes);
    }
  }
}
