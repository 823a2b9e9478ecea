// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/damage/worst_moment.h"

#include <nlohmann/json.hpp>

#include "io/output/replay/frame_reader.h"
#include "io/output/report/damage/report_cracks.h"
#include "io/output/results/case_of_run.h"
#include "tests/io/output/measures/hut.h"

// The moment at which the page opens, and the cracks in it.

namespace voussoir::io {
namespace {

using namespace test;

/// The worst moment of a hut whose front wall's top leans out by so much [m] in each frame, 0.1 s apart.
std::optional<WorstMoment> worst_of(const std::vector<double>& leans, const Capacity* capacity = nullptr) {
  Hut hut;
  for (std::size_t f = 0; f < leans.size(); ++f)
    hut.frame(0.1 * static_cast<double>(f), [&](std::size_t e, Vec3 x) {
      return hut.tag(e) == "front wall" && x.z > 0.3 ? x + Vec3{0.0, -leans[f], 0.0} : x;
    });
  const Measures m = hut.measures();
  const Hdf5File file = Hdf5File::open(hut.file());
  return worst_moment(m, capacity, FrameReader(file));
}

}  // namespace

TEST_CASE("the page opens at the largest drift of a wall that does not fall yet, and says so") {
  const auto worst = worst_of({0.0, 0.004, 0.02, 0.01, 0.2});  // a drift of 50 % is that of a falling wall
  REQUIRE(worst);
  CHECK(worst->time == doctest::Approx(0.2));
  CHECK(worst->name == "largest drift");
  CHECK(worst->what == "5 % out of plane, front wall");
}

TEST_CASE("the page opens at the largest base shear of a pushover, at the collapse of a building, nowhere without frames") {
  Capacity capacity;
  capacity.peak_time = 0.1, capacity.peak_shear = 12.3e3;
  auto worst = worst_of({0.0, 0.004, 0.02}, &capacity);
  REQUIRE(worst);
  CHECK(worst->time == 0.1);
  CHECK(worst->name == "largest base shear");
  CHECK(worst->what == "12.3 kN");
  CHECK(!worst_of({}));

  Hut fallen;
  fallen.frame(0.0, stays);
  fallen.frame(0.1, [&](std::size_t e, Vec3 x) { return fallen.is_beam(e) ? x - Vec3{0.0, 0.0, 0.35} : x; });
  const Measures m = fallen.measures();
  const Hdf5File file = Hdf5File::open(fallen.file());
  worst = worst_moment(m, nullptr, FrameReader(file));
  REQUIRE(worst);
  CHECK(worst->time == 0.1);
  CHECK(worst->name == "collapse");
}

TEST_CASE("the page opens at the largest displacement of a model without walls") {
  TempFolder folder;
  ResultsWriter results(folder.path(), two_cubes(), kCase, kNames, {}, by_hand());
  for (const float way : {0.0F, 0.3F, 0.1F})
    results.frame({0.1 * static_cast<double>(way == 0.0F  ? 0
                                             : way > 0.2F ? 1
                                                          : 2),
                   std::array<float, 6>{0, way, 0, 0, 0, 0}, std::array<float, 8>{1, 0, 0, 0, 1, 0, 0, 0}, std::array<float, 2>{}});
  results.finish();
  const Hdf5File file = Hdf5File::open(folder.file("run.h5"));
  const auto worst = worst_moment(measure(file), nullptr, FrameReader(file));
  REQUIRE(worst);
  CHECK(worst->time == doctest::Approx(0.1));
  CHECK(worst->name == "largest displacement");
  CHECK(worst->what == "0.3 m");
}

TEST_CASE("the page lists the cracks at the end with their widths in every frame, and has the maps of their walls") {
  Hut hut;
  const cases::Model& m = hut.model();
  for (std::size_t j = 0; j < m.assembly.joints.size(); ++j) {
    const geometry::Joint& joint = m.assembly.joints[j];
    const auto tag = [&](std::int32_t e) { return e < 0 ? std::string() : hut.tag(static_cast<std::size_t>(e)); };
    if (std::abs(joint.frame().normal.z) > 0.9 && std::abs(joint.centre.z - 0.2) < 1e-6 && tag(joint.element_a) == "front wall" &&
        tag(joint.element_b) == "front wall")
      hut.crack_whole_joint(0.05, j);
  }
  for (const double width : {0.0, 0.004, 0.003})
    hut.frame(width == 0.0     ? 0.0
              : width > 0.0035 ? 0.1
                               : 0.2,
              [&](std::size_t e, Vec3 x) {
                return hut.tag(e) == "front wall" && x.z > 0.2 ? x + Vec3{0.0, 0.0, width} : x;
              });
  hut.measures();
  const Hdf5File file = Hdf5File::open(hut.file());
  const auto page = nlohmann::json::parse(report_cracks(file, case_of_run(file), FrameReader(file)));
  REQUIRE(page["cracks"].size() == 1);
  const auto& crack = page["cracks"][0];
  CHECK(crack["wall"] == "front wall");
  CHECK(crack["length"].get<double>() == doctest::Approx(1.0).epsilon(0.5));
  CHECK(crack["peak_time"] == 0.1);
  CHECK(crack["at_end"].get<double>() == doctest::Approx(0.003).epsilon(1e-3));
  CHECK(crack["widths"] == nlohmann::json{0.0, 4.0, 3.0});
  REQUIRE(page["maps"].size() == 1);
  CHECK(page["maps"][0]["wall"] == "front wall");
  CHECK(page["maps"][0]["svg"].get<std::string>().find(">1: 3<") != std::string::npos);
}

}  // namespace voussoir::io
