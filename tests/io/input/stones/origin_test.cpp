// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/solids/origin.h"

#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "solver/run/run.h"
#include "solver/state/field_table.h"
#include "tests/io/input/stones/written_files.h"
#include "tests/solver/row_hash.h"

// A model is the same wherever it stands: inside, coordinates count from an origin near it.

namespace {

using namespace stones;
namespace solver = voussoir::solver;
namespace cases = voussoir::cases;
namespace geometry = voussoir::geometry;

std::string triple(Vec3 v) { return "[" + number(v.x) + ", " + number(v.y) + ", " + number(v.z) + "]"; }

/// Two blocks, one upon the other, with one of everything that has a place; at `by`.
std::string everything(Vec3 by) {
  const auto at = [&](double x, double y, double z) { return triple(Vec3{x, y, z} + by); };
  const auto range = [](double from, double low, double high) { return "[" + number(from + low) + ", " + number(from + high) + "]"; };
  return kMaterial + "[base]\nz = " + number(by.z) + "\n[[base.part]]\nx = " + range(by.x, 2.0, 3.0) + "\ny = " + range(by.y, 0.0, 1.0) +
         "\nlevel = 0.25\n" + "[[block]]\nname = \"low\"\nmaterial = \"stone\"\nbox = [" + at(0.0, 0.0, 0.0) + ", " + at(0.5, 0.25, 0.25) +
         "]\n" + "[[block]]\nname = \"high\"\nmaterial = \"stone\"\nbox = [" + at(0.0, 0.0, 0.25) + ", " + at(0.5, 0.25, 0.5) + "]\n" +
         "[[load]]\nblock = \"high\"\nforce = [1.0, 0.0, 0.0]\nat = " + at(0.25, 0.125, 0.5) +
         "\n[[tie]]\nname = \"rod\"\nfrom = " + at(0.125, 0.125, 0.125) + "\nto = " + at(0.125, 0.125, 0.375) +
         "\narea = 1e-5\nyoung = 2e11\n" + "[[output.history]]\nname = \"top\"\npoint = " + at(0.25, 0.125, 0.375) +
         "\n[[output.cut]]\nname = \"bed\"\npoint = " + at(0.0, 0.0, 0.25) + "\n";
}

cases::Case read(const std::string& text) {
  cases::Case c = voussoir::io::read_case({"test.toml", text}).value;
  voussoir::io::load_stones(c);
  return c;
}

std::string refusal_of(const std::string& text) {
  try {
    voussoir::cases::build_model(read(text));
  } catch (const std::exception& e) {
    return e.what();
  }
  return "";
}

/// Hashes of all rows that a run of so many seconds writes, and of its state in the end.
std::vector<std::uint64_t> bits_of(cases::Case c, double duration) {
  c.gravity.ramp = 0.02, c.gravity.settle_limit = 0.02;
  c.motion.reset();
  c.time.duration = duration;
  const cases::Model model = model_of(c);
  solver::Options options;
  options.threads = 1;
  solver::Simulation sim(c, model, {}, options);
  solver::RunState plan;
  voussoir::testing::RowHash rows;
  solver::run(sim, plan, c, duration, rows, [](const solver::RunStatus&) { return true; });
  const auto hashes = rows.values();
  std::vector<std::uint64_t> all(hashes.begin(), hashes.end());
  CHECK(rows.rows[5] > 0);  // frames
  all.push_back(solver::state_hash(sim.world()));
  return all;
}

constexpr std::array kFar{Vec3{1000.0, 0.0, 0.0}, Vec3{-137.0, 4999.0, 0.0}, Vec3{0.0, 0.0, 312.0}, Vec3{650001.0, 4820000.0, 312.0},
                          Vec3{9999990.0, -9999999.0, 9999999.0}};

}  // namespace

TEST_CASE("a model near the origin of its axes keeps its coordinates; one far off has them from its corner, whole metres off") {
  const auto origin = [](const std::string& text) { return *read(text).origin; };
  for (const Vec3 by : {Vec3{}, Vec3{1, 0, 0}, Vec3{-3.5, 99.0, 0.0}}) CHECK(origin(everything(by)) == Vec3{});
  CHECK(origin(everything({1000.25, -2000.25, 0.0})) == Vec3{1000, -2000, 0});
  // A model that reaches from here to there is not far from anything.
  const std::string far_block = "[[block]]\nname = \"far\"\nmaterial = \"stone\"\nbox = [[900.0, 0, 0], [901.0, 1, 1]]\n";
  CHECK(origin(everything({150.0, 0.0, 0.0}) + far_block) == Vec3{});
  const auto boxes = std::array{geometry::Box3{{5000.5, -1, 0}, {5001.5, 1, 2}}};
  CHECK(cases::suitable_origin({}, boxes) == Vec3{5001, 0, 0});
}

TEST_CASE("all that has a place in a case goes with the origin, and comes back bit for bit") {
  const cases::Case near = read(everything({}));
  REQUIRE(near.origin == Vec3{});
  const std::string text = voussoir::io::resolved_toml(near);
  for (const Vec3 by : kFar) {
    CAPTURE(by.x);
    const cases::Case far = read(everything(by));
    REQUIRE(*far.origin == by);
    cases::Case relative = far;
    relative.origin = Vec3{};  // written as it is
    CHECK(voussoir::io::resolved_toml(relative) == text);
    const cases::Case given = voussoir::io::read_case({"test.toml", everything(by)}).value;
    CHECK(voussoir::io::resolved_toml(far) == voussoir::io::resolved_toml(given));
  }
}

TEST_CASE("blocks of any coordinates come back bit for bit") {
  const std::string head = kMaterial + "[base]\nz = 0.0\n[[block]]\nname = \"b\"\nmaterial = \"stone\"\nbox = [";
  for (const double x : {123.4, -123.4, 650001.3751234, -9999998.7, 4820000.1}) {
    const std::string text = head + triple({x, -0.3, 0.0}) + ", " + triple({x + 7.7, 0.4, 1.1}) + "]\n";
    const cases::Case given = voussoir::io::read_case({"test.toml", text}).value, used = read(text);
    CHECK(used.origin->x != 0.0);
    CHECK(cases::as_in_file(used).blocks[0].box == given.blocks[0].box);
    CHECK((*used.blocks[0].box)[1].x - (*used.blocks[0].box)[0].x == (*given.blocks[0].box)[1].x - (*given.blocks[0].box)[0].x);
  }
}

TEST_CASE("blocks far off settle to the bits of those at the origin") {
  const std::vector<std::uint64_t> here = bits_of(read(everything({})), 0.02);
  for (const Vec3 by : kFar) {
    CAPTURE(by.x);
    CHECK(bits_of(read(everything(by)), 0.02) == here);
  }
}

TEST_CASE("an arch of a file far off is the arch at the origin: its joints, its mass, and how it settles") {
  const TempFolder folder;
  const auto written = [&](Vec3 by) {
    std::vector<Named> all = arch(9, 1.5, 1.75, 0.5);
    for (Named& n : all) {
      for (Vec3& v : n.mesh.vertices) v = v + by;
    }
    return load(folder.write("arch.obj", obj(all)), "supports = \"ground\"");
  };
  const cases::Case near = written({});
  const cases::Model here = model_of(near);
  REQUIRE(here.origin == Vec3{});
  for (const Vec3 by : {Vec3{1.0, 0, 0}, Vec3{1001.375, 0, 0}, Vec3{650001.375, 4820000.0, 312.0}, Vec3{-9e6, 9e6 + 1, 0}}) {
    CAPTURE(by.x);
    const cases::Case far = written(by);
    const cases::Model there = model_of(far);
    CHECK(norm(there.origin - by) < (std::abs(by.x) > 100.0 ? 4.0 : 2.0));
    REQUIRE(there.assembly.joints.size() == here.assembly.joints.size());
    const double rounding = 1e-9;  // m, of coordinates of 1e7 m, by half
    for (std::size_t j = 0; j < here.assembly.joints.size(); ++j)
      CHECK(std::abs(there.assembly.joints[j].area - here.assembly.joints[j].area) < 10.0 * rounding);
    double mass_here = 0.0, mass_there = 0.0;
    for (const auto& e : here.assembly.elements) mass_here += e.mass.volume;
    for (const auto& e : there.assembly.elements) mass_there += e.mass.volume;
    CHECK(mass_there == doctest::Approx(mass_here).epsilon(1e-7));
  }
  // Placed by the case, it is the same arch to the bit.
  const std::string file = folder.write("arch.obj", obj(arch(9, 1.5, 1.75, 0.5)));
  const cases::Case placed = load(file, "supports = \"ground\"\nplace = [0.0, 650001.0, 0.0]");
  CHECK(placed.origin == Vec3{0, 650001, 0});
}

TEST_CASE("a house far off settles to the bits of one at the origin") {
  const auto hut = [](Vec3 by) {
    return read("include = \"flat20w\"\n[base]\nz = " + number(by.z) + "\n[house]\ninner_size = [1.2, 0.8]\nheight = 0.8\n" +
                "brick = [0.4, 0.2, 0.2]\nopening = []\norigin = [" + number(by.x) + ", " + number(by.y) + "]\n[output]\nhistory = []\n");
  };
  const std::vector<std::uint64_t> here = bits_of(hut({}), 0.01);
  for (const Vec3 by : {Vec3{30001.0, 0, 0}, Vec3{-900000.0, 0, 0}, Vec3{650001.0, 4820000.0, 312.0}}) {
    CAPTURE(by.x);
    CHECK(bits_of(hut(by), 0.01) == here);
  }
}

TEST_CASE("what lies farther than 10,000 km from the origin of the axes is refused") {
  CHECK(refusal_of(everything({1e7, 0, 0}))
            .find("block[0].box: x = 10000000.5 m is too far from the origin of the axes; allowed: -10000000 to "
                  "10000000 m") != std::string::npos);
  CHECK(refusal_of(everything({0, 0, -2e7})).find("base.z: z = -20000000 m is too far") != std::string::npos);
  const TempFolder folder;
  const std::string file = folder.write("cube.obj", obj({{"cube", box({2e7, 0, 0}, {2e7 + 1, 1, 1})}}));
  CHECK(refusal(file).find("stones[0].file: stone \"cube\" of \"cube.obj\" reaches to (2e+07, 0, 0) m, too far") != std::string::npos);
  CHECK(refusal(file, "place = [-2e7, 0.0, 0.0]") == "");
}

TEST_CASE("a message names a place in the coordinates of the file, or says what it counts from") {
  const std::string overlap = "[[block]]\nname = \"in\"\nmaterial = \"stone\"\nbox = [[1000.1, 0.1, 0.1], [1000.3, 0.2, 0.2]]\n";
  CHECK(refusal_of(everything({1000, 0, 0}) + overlap).find("; places count from the model's origin (1000, 0, 0) m") != std::string::npos);
  CHECK(refusal_of(everything({}) + "[[tie]]\nname = \"off\"\nfrom = [9.0, 0, 3.0]\nto = [0.1, 0.1, 0.1]\narea = 1e-5\nyoung = 2e11\n")
            .find("[9, 0, 3] m lies in no element, nor on the base (z = 0 m)") != std::string::npos);
  const std::string off = "[[tie]]\nname = \"off\"\nfrom = [1009.0, 0, 3.0]\nto = [1000.1, 0.1, 0.1]\narea = 1e-5\nyoung = 2e11\n";
  CHECK(refusal_of(everything({1000, 0, 0}) + off).find("[1009, 0, 3] m lies in no element, nor on the base (z = 0 m)") !=
        std::string::npos);
}
