// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "io/input/case_file/case_file.h"
#include "io/output/assess/assess_words.h"
#include "io/output/assess/assessment.h"
#include "io/output/assess/crack_map.h"
#include "io/output/assess/floor_spectra.h"
#include "io/output/measures/measures.h"
#include "io/output/measures/point_accelerations.h"
#include "io/output/results/case_of_run.h"
#include "tests/cases/paper_house.h"
#include "tests/io/results_fixture.h"

// What engineers read off a run, from runs written by hand: every displacement, crack and force is known.
namespace voussoir::io {
namespace {

using namespace test;

constexpr double kBed = 1.0;  // m: a bed joint all through the front wall, half way up its window

/// A front wall of 5.4 × 2.4 m and 0.2 m, in running bond, with a window of 1.0 × 1.0 m at 2.0 m from its left end and 0.6 m up.
cases::Case wall_with_window() {
  cases::Case c = testing::paper_materials();
  c.title = "wall";
  c.damping = {};
  c.base = cases::Base{};
  c.house = cases::House{};
  c.house->walls = {"front"};
  c.house->bond = cases::Bond::running;
  c.house->roof.kind = cases::RoofKind::none;
  c.house->openings = {testing::opening("front", 2.0, 1.0, 0.6, 1.0)};
  c.output.history.push_back({"top", {1.0, 0.1, 2.3}});
  cases::Cut cut;
  cut.name = "bed", cut.point = {0.0, 0.0, kBed}, cut.normal = {0, 0, 2};
  c.output.cuts.push_back(cut);
  return c;
}

/// A run whose every frame moves what lies above the bed joint, at this height [m], as a whole.
class Shifted {
 public:
  explicit Shifted(const cases::Case& c, double bed = kBed) : case_(c), model_(cases::build_model(c)), bed_(bed) {
    ResultsOptions options = by_hand();
    for (const cases::Cut& cut : c.output.cuts) options.cuts.push_back(cut.name);
    const std::vector<std::string> names{"top"};
    results_.emplace(folder_.path(), model_, resolved_toml(c), names, Provenance{}, options);
  }
  [[nodiscard]] bool above(std::int32_t e) const {
    return e >= 0 && model_.assembly.elements[static_cast<std::size_t>(e)].mass.centroid.z > bed_;
  }
  [[nodiscard]] const cases::Model& model() const { return model_; }
  ResultsWriter& results() { return *results_; }

  /// All springs of the joints in the bed break.
  std::set<std::size_t> crack_bed(double time) {
    std::vector<solver::CrackRow> rows;
    std::set<std::size_t> joints;
    for (std::size_t j = 0; j < model_.assembly.joints.size(); ++j) {
      const geometry::Joint& joint = model_.assembly.joints[j];
      if (above(joint.element_a) == above(joint.element_b)) continue;
      joints.insert(j);
      rows.push_back({time, static_cast<std::int32_t>(j), joint.element_a, joint.element_b, joint.centre, joint.frame().normal, joint.area,
                      solver::FailureMode::tension, solver::FailureMode::tension, time});
    }
    results_->cracks(rows);
    return joints;
  }
  void frame(double time, Vec3 shift) {
    std::vector<float> displacement, quaternion, broken(model_.blocks.size());
    for (std::size_t e = 0; e < model_.blocks.size(); ++e) {
      const Vec3 u = above(static_cast<std::int32_t>(e)) ? shift : Vec3{};
      for (const double v : {u.x, u.y, u.z}) displacement.push_back(static_cast<float>(v));
      quaternion.insert(quaternion.end(), {1, 0, 0, 0});
    }
    results_->frame({time, displacement, quaternion, broken});
  }
  Hdf5File done() {
    results_->finish();
    return Hdf5File::open(folder_.file("run.h5"));
  }

 private:
  cases::Case case_;
  cases::Model model_;
  double bed_;  // m
  TempFolder folder_;
  std::optional<ResultsWriter> results_;
};

Assessment assessed(const Hdf5File& run, std::optional<double> time, const std::vector<double>& levels) {
  return assess(run, case_of_run(run), building_of(run), time, levels);
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("assess: corners of openings, as seen from outside") {
  for (const auto& [side, left] : std::map<std::string, double>{{"front", 2.0}, {"rear", 3.0}}) {
    cases::Case c = wall_with_window();
    c.house->walls = {side};
    c.house->openings[0].wall = side;
    c.output.cuts.clear();
    Shifted run(c);
    run.frame(0.0, {});
    const Hdf5File file = run.done();
    const std::vector<OpeningCorner> corners = opening_corners(building_of(file), 0);
    REQUIRE(corners.size() == 4);
    const double right = side == "front" ? left + 1.0 : left - 1.0;  // x runs to the left before a rear wall
    const std::array<std::pair<const char*, std::pair<double, double>>, 4> expected{{{"opening 1, lower left", {left, 0.6}},
                                                                                     {"opening 1, lower right", {right, 0.6}},
                                                                                     {"opening 1, upper left", {left, 1.6}},
                                                                                     {"opening 1, upper right", {right, 1.6}}}};
    for (std::size_t k = 0; k < 4; ++k) {
      INFO(side << ": " << corners[k].name);
      CHECK(corners[k].name == expected[k].first);
      CHECK(corners[k].along == doctest::Approx(expected[k].second.first));
      CHECK(corners[k].z == doctest::Approx(expected[k].second.second));
    }
  }
}

TEST_CASE("assess: widths of a crack that opens by 1 mm and slides by 2 mm; its map") {
  Shifted run(wall_with_window());
  run.frame(0.0, {});
  const std::set<std::size_t> bed = run.crack_bed(0.5);
  run.frame(1.0, {2e-3, 0.0, 1e-3});
  run.frame(2.0, {0.0, 0.0, 0.05e-3});  // all but closed
  const Hdf5File file = run.done();
  const Building building = building_of(file);
  const Assessment a = assessed(file, 1.1, {});
  CHECK(a.time == 1.0);
  REQUIRE(a.walls.size() == 1);
  const CrackFigures& f = a.walls[0].cracks;
  CHECK(f.joints == bed.size());
  CHECK(f.largest == doctest::Approx(std::hypot(1e-3, 2e-3)).epsilon(1e-3));
  CHECK(f.mean == doctest::Approx(f.largest).epsilon(1e-3));
  CHECK(f.largest_opening == doctest::Approx(1e-3).epsilon(2e-3));
  CHECK(f.largest_sliding == doctest::Approx(2e-3).epsilon(2e-3));
  std::map<std::string, std::size_t> near;
  for (const auto& [corner, figures] : a.corners) near[corner.name] = figures.joints;
  REQUIRE(near.size() == 4);
  for (const auto& [name, joints] : near) {
    INFO(name);
    if (name.find("lower") != std::string::npos) CHECK(joints > 0);
    if (name.find("upper") != std::string::npos) CHECK(joints == 0);  // 0.6 m from the bed
    CHECK(joints < bed.size() / 2);
  }
  CHECK(assessed(file, {}, {}).walls[0].cracks.joints == 0);   // under a hair crack's width
  CHECK(assessed(file, 0.0, {}).walls[0].cracks.joints == 0);  // not open yet
  // Left and right of the window, which is 2.0 m from the left end and 1.0 m wide.
  REQUIRE(a.cracks.size() == 2);
  const std::size_t left = a.cracks[0].along[0] < 1.0 ? 0 : 1;
  for (const std::size_t i : {left, 1 - left}) {
    const Crack& crack = a.cracks[i];
    CHECK(crack.wall == 0);
    CHECK(crack.along[0] == doctest::Approx(i == left ? 0.0 : 3.0));
    CHECK(crack.along[1] == doctest::Approx(i == left ? 2.0 : 5.4));
    CHECK(crack.z[0] == doctest::Approx(kBed));
    CHECK(crack.z[1] == doctest::Approx(kBed));
    CHECK(crack.length == doctest::Approx(i == left ? 2.0 : 2.4));
    CHECK(crack.extent() == doctest::Approx(i == left ? 2.0 : 2.4));
    CHECK(crack.width == doctest::Approx(f.largest).epsilon(1e-3));
    CHECK(crack.peak == doctest::Approx(f.largest).epsilon(1e-3));
    CHECK(crack.peak_time == 1.0);
    CHECK(crack.at_end == doctest::Approx(0.05e-3).epsilon(2e-2));
  }
  CHECK(nlohmann::json::parse(assessment_json(a, {}, {}))["cracks"].size() == 2);
  CHECK(assessment_text(a, {}, {}).find("branches, the sum of their lengths") != std::string::npos);
  Crack net;
  net.along = {1.0, 4.0}, net.z = {2.0, 6.0}, net.length = 28.0;  // m: branches make it longer than it is wide and high
  CHECK(net.extent() == doctest::Approx(5.0));
  const std::string map = crack_map(file, "wall", building, 0, a.time, a.joints, a.fallen, a.cracks);
  for (const char* label : {">1: 2.2<", ">2: 2.2<"}) CHECK(count(map, label) == 1);
  const std::string colour = std::string("stroke=\"") + kCrackClasses[2].colour;  // 1 to 5 mm
  CHECK(count(map, colour) == 1 + [&] {
    std::size_t on_face = 0;  // one edge a joint lies on the outer face, and one in the legend
    for (const std::size_t j : bed) on_face += run.model().assembly.joints[j].centre.y < 0.11 ? 1 : 0;
    return on_face;
  }());
  CHECK(map.find("cracks at 1.000 s, seen from outside") != std::string::npos);
  CHECK(map.find(">1 m<") != std::string::npos);
  CHECK(count(map, std::string("stroke=\"") + kCrackClasses[5].colour) == 1);
}

TEST_CASE("assess: the slip of beams on a wall is no crack of the wall, in table, map and measures") {
  cases::Case c = testing::paper_flat20();
  c.output.history.resize(1), c.output.history[0].name = "top";
  Shifted run(c, 2.4);  // m: the walls' top
  run.frame(0.0, {});
  CHECK(run.crack_bed(0.5).size() > 20);
  run.frame(1.0, {0.0, 0.154, 0.0});
  const Hdf5File file = run.done();
  const Assessment a = assessed(file, {}, {});
  REQUIRE(a.walls.size() == 4);
  std::size_t seats = 0;
  for (std::size_t w = 0; w < 4; ++w) {
    INFO(a.walls[w].name);
    CHECK(a.walls[w].cracks.joints == 0);
    CHECK(a.walls[w].cracks.largest == 0.0);
    CHECK(a.walls[w].parted == 0);
    seats += a.walls[w].seats.joints;
    if (a.walls[w].seats.joints > 0) CHECK(a.walls[w].seats.largest == doctest::Approx(0.154).epsilon(1e-4));
    const std::string map = crack_map(file, "house", building_of(file), static_cast<std::int32_t>(w), a.time, a.joints, a.fallen, a.cracks);
    CHECK(map.find("widest") == std::string::npos);
    CHECK(count(map, std::string("stroke=\"") + kCrackClasses[5].colour) == 1);  // the legend's
  }
  CHECK(seats > 20);
  const std::string words = assessment_text(a, {}, {});
  CHECK(count(words, "slip of timber on walls [mm]") == 1);
  CHECK(nlohmann::json::parse(assessment_json(a, {}, {}))["walls"][0]["cracks"]["joints"] == 0);
  const Measures m = measure(file);
  CHECK(m.damage_grade == 0);
  for (const WallMeasures& w : m.walls) {
    CHECK(w.crack_extent == 0.0);
    CHECK(w.opened_extent == 0.0);
  }
}

TEST_CASE("assess: what has parted by more than a crack's width is told apart; table and map name one width") {
  Shifted run(wall_with_window());
  run.frame(0.0, {});
  const std::size_t bed = run.crack_bed(0.5).size();
  run.frame(1.0, {0.017, 0.0, 0.0});
  run.frame(2.0, {0.25, 0.0, 0.0});
  const Hdf5File file = run.done();
  const Assessment cracked = assessed(file, 1.0, {}), parted = assessed(file, 2.0, {});
  CHECK(cracked.walls[0].parted == 0);
  CHECK(parted.walls[0].parted == bed);
  CHECK(parted.walls[0].cracks.joints == 0);
  CHECK(parted.walls[0].cracks.largest == 0.0);
  const auto map = [&](const Assessment& a) { return crack_map(file, "wall", building_of(file), 0, a.time, a.joints, a.fallen, a.cracks); };
  CHECK(map(cracked).find("; widest 17.00 mm<") != std::string::npos);
  CHECK(assessment_text(cracked, {}, {}).find(" 17.00 ") != std::string::npos);
  CHECK(map(parted).find("widest") == std::string::npos);
  CHECK(assessment_text(parted, {}, {}).find("have parted by more than 200 mm") != std::string::npos);
}

TEST_CASE("assess: out of plane over the thickness, storey drift, what has fallen does not count") {
  Shifted run(wall_with_window());
  run.frame(0.0, {});
  run.frame(1.0, {0.024, -0.1, 0.0});
  run.frame(2.0, {-0.012, 0.05, 0.0});
  run.frame(3.0, {0.0, -1.2, 0.0});   // it has left its place
  run.frame(4.0, {0.0, -0.1, -0.9});  // its lower half is down
  const Hdf5File file = run.done();
  const Assessment a = assessed(file, 2.0, {});
  REQUIRE(a.walls.size() == 1);
  CHECK(a.walls[0].thickness == doctest::Approx(0.2));
  CHECK(a.walls[0].out_of_plane.value == doctest::Approx(0.5).epsilon(1e-5));  // outward: before the house
  CHECK(a.walls[0].out_of_plane.time == 1.0);
  CHECK(a.walls[0].out_of_plane_now == doctest::Approx(-0.25).epsilon(1e-5));
  REQUIRE(a.storeys.size() == 1);
  CHECK(a.storeys[0].low == 0.0);
  CHECK(a.storeys[0].high == doctest::Approx(2.4));
  CHECK(a.storeys[0].peak[0].value == doctest::Approx(0.01).epsilon(1e-4));
  CHECK(a.storeys[0].peak[1].value == doctest::Approx(-0.1 / 2.4).epsilon(1e-5));
  CHECK(a.storeys[0].now[0] == doctest::Approx(-0.005).epsilon(1e-4));
  for (const double time : {3.0, 4.0}) {
    INFO(time);
    const Assessment gone = assessed(file, time, {});
    REQUIRE(gone.fallen.size() == run.model().blocks.size());
    std::size_t fallen = 0;
    for (std::size_t e = 0; e < gone.fallen.size(); ++e) {
      const bool moved = run.above(static_cast<std::int32_t>(e));
      if (!moved) CHECK(gone.fallen[e] == 0);
      fallen += moved && gone.fallen[e] != 0 ? 1U : 0U;
    }
    CHECK(fallen > 10);
    const std::string map = crack_map(file, "wall", building_of(file), 0, gone.time, gone.joints, gone.fallen, gone.cracks);
    CHECK(count(map, "#c9c9c9") > 10);
  }
  CHECK(count(crack_map(file, "wall", building_of(file), 0, a.time, a.joints, a.fallen, a.cracks), "#c9c9c9") <= 1);
  REQUIRE(assessed(file, 2.0, {0.0, 2.4, 2.4}).storeys.size() == 1);
  CHECK_THROWS_AS((void)assessed(file, 2.0, {0.0, 5.2}), cases::InputError);  // above the walls
  CHECK_THROWS_AS((void)assessed(file, 99.0, {}), cases::InputError);         // after the last frame
  const Assessment two = assessed(file, 2.0, {0.0, 0.8, 2.4});
  REQUIRE(two.storeys.size() == 2);
  CHECK(two.storeys[0].peak[0].value == doctest::Approx(0.0));
  CHECK(two.storeys[1].peak[0].value == doctest::Approx(0.024 / 1.6).epsilon(1e-4));
}

TEST_CASE("assess: base shear over the weight, forces through cuts") {
  Shifted run(wall_with_window());
  run.frame(0.0, {});
  double mass = 0.0;
  for (const geometry::Element& e : run.model().assembly.elements) mass += 1800.0 * e.mass.volume;
  run.results().forces({0.0, {300.0, -400.0, 9.8 * mass}, {}});
  run.results().forces({0.1, {3.0, 4.0, 9.8 * mass}, {}});
  run.results().cuts(0.0, std::array{solver::CutSample{{30.0, 40.0, -900.0}, {6.0, 8.0, -2.0}}});
  run.results().cuts(0.1, std::array{solver::CutSample{{0.0, 0.0, 100.0}, {0.0, 0.0, 3.0}}});
  const Hdf5File file = run.done();
  const Assessment a = assessed(file, {}, {});
  CHECK(a.weight == doctest::Approx(9.8 * mass));
  CHECK(a.base_shear.value == doctest::Approx(500.0));
  CHECK(a.base_shear_over_weight == doctest::Approx(500.0 / (9.8 * mass)));
  REQUIRE(a.cuts.size() == 1);
  CHECK(a.cuts[0].axial.value == -900.0);
  CHECK(a.cuts[0].compression.value == -900.0);
  CHECK(a.cuts[0].shear.value == doctest::Approx(50.0));
  CHECK(a.cuts[0].bending.value == doctest::Approx(10.0));
  CHECK(a.cuts[0].torsion.value == 3.0);
  CHECK(a.cuts[0].torsion.time == doctest::Approx(0.1));
  const auto json = nlohmann::json::parse(assessment_json(a, {}, {}));
  CHECK(json["cuts"][0]["axial"]["value"] == -900.0);
  CHECK(assessment_text(a, {}, {}).find("bed") != std::string::npos);
}

TEST_CASE("assess: the peak base shear is that of summary where the run saw more than its rows") {
  Shifted run(wall_with_window());
  run.frame(0.0, {});
  run.results().forces({0.2, {300.0, -400.0, 0.0}, {}});
  solver::Summary s;
  s.peak_base_shear = 520.0;
  run.results().summary(s);
  const Hdf5File file = run.done();
  const Assessment a = assessed(file, {}, {});
  CHECK(a.base_shear.value == doctest::Approx(520.0));
  CHECK(a.base_shear.time == doctest::Approx(0.2));
  CHECK(assessment_text(a, {}, {}).find("base shear               0.5 kN at most") != std::string::npos);
}

TEST_CASE("assess: peaks of accelerations are those of summary, below 50 Hz, and the words say so") {
  for (const double step : {0.001, 0.02}) {  // the second is too coarse for the low-pass
    CAPTURE(step);
    Shifted run(wall_with_window());
    run.frame(0.0, {});
    for (int i = 0; i <= 1000; ++i) {
      const double t = step * i, ring = 0.01 * std::sin(2.0 * 3.14159265358979 * 200.0 * t);
      run.results().history(t, std::array{solver::HistorySample{{}, {0.3 * std::sin(10.0 * t) + ring, 0.1 * std::sin(10.0 * t), 0.0}, {}}});
    }
    const Hdf5File file = run.done();
    const std::vector<std::string> names{"top"};
    const std::vector<FloorAcceleration> points = floor_accelerations(file, names, {});
    REQUIRE(points.size() == 1);
    const std::string words = assessment_text(assessed(file, {}, {}), points, {});
    const PointAccelerations of_summary = point_accelerations(file);
    CHECK(points[0].low_passed == (step == 0.001));
    if (step > 0.001) {
      CHECK(words.find("points: not filtered") != std::string::npos);
      continue;
    }
    REQUIRE(of_summary.points.size() == 1);
    CHECK(points[0].peak_horizontal == of_summary.points[0].peak_horizontal);
    CHECK(points[0].peak[0] == doctest::Approx(3.1).epsilon(0.06));  // the ringing has 12.6 m/s2
    CHECK(words.find("points: below 50 Hz, as in summary") != std::string::npos);
    CHECK(nlohmann::json::parse(assessment_json(assessed(file, {}, {}), points, {}))["points"][0]["low_pass"] == 50.0);
  }
}

TEST_CASE("assess: acceleration of a point and its spectrum") {
  constexpr double kOmega = 10.0, kSpeed = 0.3, kStep = 0.001;
  Shifted run(wall_with_window());
  run.frame(0.0, {});
  for (int i = 0; i <= 4000; ++i) {
    const double t = kStep * i;
    run.results().history(t, std::array{solver::HistorySample{{}, {kSpeed * std::sin(kOmega * t), 0.0, 0.0}, {}}});
  }
  const Hdf5File file = run.done();
  cases::GroundMotion base;
  base.axis[0].dt = 10.0, base.axis[0].acceleration = {2.0, 2.0};
  base.axis[1] = base.axis[0];
  const std::vector<std::string> names{"top"};
  const std::vector<FloorAcceleration> still = floor_accelerations(file, names, {}), moved = floor_accelerations(file, names, base);
  REQUIRE(still.size() == 1);
  for (const std::size_t i : {100UL, 1234UL, 3999UL}) {
    const double exact = kSpeed * kOmega * std::cos(kOmega * kStep * static_cast<double>(i));
    CHECK(still[0].axis[0].acceleration[i] == doctest::Approx(exact).epsilon(1e-4));
    CHECK(moved[0].axis[0].acceleration[i] == doctest::Approx(exact + 2.0).epsilon(1e-4));
    CHECK(moved[0].axis[1].acceleration[i] == doctest::Approx(2.0));
  }
  // Steady state of a damped oscillator over the peak of what drives it: 1/√((1 − r²)² + (2ζr)²) at r = 1 is 1/2ζ; a stiff one follows, and
  // overshoots where the motion sets in, by exp(−πζ/√(1 − ζ²)).
  const std::vector<double> s = spectrum(still[0].axis[0], {2.0 * 3.14159265358979 / kOmega, 0.02}, 0.2);
  CHECK(s[0] == doctest::Approx(kSpeed * kOmega / 0.4).epsilon(2e-2));
  CHECK(s[1] == doctest::Approx(kSpeed * kOmega * (1.0 + std::exp(-3.14159265358979 * 0.2 / std::sqrt(0.96)))).epsilon(1e-2));
  const std::string csv = spectra_csv(moved, base, {0.05});
  CHECK(csv.starts_with("point,axis,damping,period,acceleration\n\"base\",x,0.05,0.02,"));
  CHECK(count(csv, "\"top\",") == 3 * spectrum_periods().size());
}

}  // namespace voussoir::io
