// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/results/base_motion.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "cases/case.h"
#include "io/input/files/hdf5_file.h"
#include "io/input/motion/synthetic/bam_like.h"
#include "tests/io/results_fixture.h"

using namespace voussoir;
using namespace voussoir::io::test;
using io::BaseRow;

namespace {

std::vector<BaseRow> base_motion(const cases::GroundMotion& motion, double dt, std::int64_t every, std::int64_t last) {
  std::vector<BaseRow> rows;
  io::base_motion(motion, dt, every, last, [&](const BaseRow& row) { rows.push_back(row); });
  return rows;
}

}  // namespace

TEST_CASE("base motion: integrals of a ramp, between the samples too, and rest or drift after the end") {
  cases::GroundMotion m;
  m.axis[1] = {"y", 0.5, {0.0, 1.0, 2.0}};  // a = 2 t up to 1 s, then zero
  const std::vector<BaseRow> b = base_motion(m, 0.05, 2, 30);
  REQUIRE(b.size() == 16);
  for (std::size_t i = 0; i < b.size(); ++i) {
    const double t = b[i].time, in = std::min(t, 1.0);
    CAPTURE(t);
    CHECK(t == doctest::Approx(0.1 * static_cast<double>(i)));
    CHECK(b[i].acceleration.y == doctest::Approx(t < 1.0 + 1e-9 ? 2.0 * t : 0.0));
    CHECK(b[i].velocity.y == doctest::Approx(in * in).epsilon(1e-12));
    CHECK(b[i].displacement.y == doctest::Approx(in * in * in / 3.0 + (t - in) * 1.0).epsilon(1e-12));
    CHECK(b[i].velocity.x == 0.0);
    CHECK(b[i].displacement.z == 0.0);
  }
}

TEST_CASE("base motion: the velocity of a record is the integral of what the solver takes") {
  cases::GroundMotion m;
  m.axis[0] = io::bam_like_1()[0];
  const std::vector<BaseRow> b = base_motion(m, 1e-4, 10, 100000);
  double velocity = 0.0;
  for (std::size_t i = 1; i < b.size(); ++i) {
    for (int k = 0; k < 10; ++k) {  // ten steps of the midpoint rule, exact where the motion is linear over each
      velocity += 1e-4 * cases::acceleration_at(m.axis[0], (static_cast<double>(i - 1) * 10.0 + k + 0.5) * 1e-4);
    }
    REQUIRE(std::abs(b[i].velocity.x - velocity) < 1e-9);
  }
}

TEST_CASE("base motion: stands in run.h5 and says what was done to the record; a case without motion has none") {
  const TempFolder folder;
  cases::Case c;
  CHECK(io::motion_datasets(c, {}, 1e-3, 1).empty());
  c.motion.emplace();
  c.motion->treatment.from = 2.0;
  c.time.duration = 0.5;
  cases::GroundMotion m;
  m.axis[2] = {"z", 0.5, {1.0, 1.0}};
  io::ResultsOptions options = by_hand();
  options.motion = io::motion_datasets(c, m, 5e-4, 1);
  const io::ResultsWriter results(folder.path(), two_cubes(), kCase, kNames, {}, options);
  const io::Hdf5File run = io::Hdf5File::open(folder.file("run.h5"));
  CHECK(run.shape("/motion/time") == io::Shape{501});
  CHECK(run.shape("/motion/velocity") == io::Shape{501, 3});
  CHECK(run.read<double>("/motion/velocity")[3 * 400 + 2] == doctest::Approx(0.4));
  CHECK(run.read<double>("/motion/displacement")[3 * 500 + 2] == doctest::Approx(0.125));
  CHECK(run.attribute_text("/motion/acceleration", "description").find("from 2 s on") != std::string::npos);
  CHECK(run.attribute_text("/motion/acceleration", "unit") == "m/s2");
  CHECK(!run.exists("/motion/factors"));
  c.analysis.kind = cases::AnalysisKind::pushover;  // leaves the motion out
  CHECK(io::motion_datasets(c, {}, 5e-4, 1).empty());
}

TEST_CASE("base motion: of a case that states an intensity the factor stands in run.h5, and in words") {
  const TempFolder folder;
  cases::Case c;
  c.motion.emplace();
  c.motion->intensity = {cases::IntensityMeasure::pga, 3.0, {}};
  c.time.duration = 0.5;
  cases::GroundMotion m;
  m.axis[0] = {"x", 0.5, {3.0, 1.0}};
  m.factor = {0.25, 0.5, 2.0};
  io::ResultsOptions options = by_hand();
  options.motion = io::motion_datasets(c, m, 5e-4, 1);
  const io::ResultsWriter results(folder.path(), two_cubes(), kCase, kNames, {}, options);
  const io::Hdf5File run = io::Hdf5File::open(folder.file("run.h5"));
  CHECK(run.read<double>("/motion/factors") == std::vector{0.25, 0.5, 2.0});
  CHECK(run.attribute_text("/motion/acceleration", "description").find("multiplied by 0.25, 0.5 and 2 to reach PGA = 3 m/s2") !=
        std::string::npos);
}

TEST_CASE("base motion: rows are whole cycles of multi-rate stepping apart, as those of /history are") {
  cases::Case c;
  c.motion.emplace();
  c.time.duration = 0.02;
  cases::GroundMotion m;
  m.axis[0] = {"x", 0.01, {0.0, 1.0, 0.0}};
  const std::vector<io::StaticDataset> sets = io::motion_datasets(c, m, 5e-5, 8);  // 1 ms: 20 steps, three cycles
  CHECK(sets.at(0).shape == io::Shape{17});                                        // to step 384 of 400
  std::vector<double> time;
  sets.at(0).source([&](std::span<const double> some) { time.insert(time.end(), some.begin(), some.end()); });
  REQUIRE(time.size() == 17);
  CHECK(time[1] == doctest::Approx(1.2e-3));
}

TEST_CASE("base motion: of a long run the rows are made piece by piece, and every time anew") {
  const TempFolder folder;
  cases::Case c;
  c.motion.emplace();
  c.time.duration = 100.0;
  cases::GroundMotion m;
  m.axis[2] = {"z", 0.5, {1.0, 1.0}};  // a velocity of 0.5 m/s at its end, and from there on
  io::ResultsOptions options = by_hand();
  options.motion = io::motion_datasets(c, m, 5e-4, 1);
  std::size_t largest = 0, values = 0;
  options.motion.at(2).source([&](std::span<const double> some) { largest = std::max(largest, some.size()), values += some.size(); });
  CHECK(values == 3 * 100001);
  CHECK(largest * sizeof(double) <= 256 * 1024);
  CHECK(largest % 3 == 0);
  io::ResultsWriter results(folder.path(), two_cubes(), kCase, kNames, {}, options);
  results.failure("to be written again");
  results.flush();
  const io::Hdf5File run = io::Hdf5File::open(folder.file("run.h5"));
  const auto time = run.read<double>("/motion/time"), velocity = run.read<double>("/motion/velocity");
  REQUIRE(velocity.size() == 3 * 100001);
  for (std::size_t i = 0; i <= 100000; i += 100) {
    CHECK(time[i] == doctest::Approx(1e-3 * static_cast<double>(i)));
    CHECK(velocity[3 * i + 2] == doctest::Approx(std::min(time[i], 0.5)).epsilon(1e-12));
    CHECK(velocity[3 * i] == 0.0);
  }
}
