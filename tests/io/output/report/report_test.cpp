// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "io/app/commands/report_command.h"
#include "io/input/files/errors.h"
#include "io/input/files/packed_text.h"
#include "io/input/files/text_file.h"
#include "io/input/files/whole_file.h"
#include "io/output/measures/debris/bodies.h"
#include "io/output/replay/covered_faces.h"
#include "io/output/replay/joint_cracks.h"
#include "io/output/replay/joint_openings.h"
#include "io/output/replay/opened_faces.h"
#include "io/output/report/report_model.h"
#include "io/output/report/report_page.h"
#include "tests/io/results_fixture.h"

namespace voussoir::io {
namespace {

using namespace test;

std::string base64_of(const std::string& text) { return base64({reinterpret_cast<const unsigned char*>(text.data()), text.size()}); }

/// What stands in the element of the page with this id.
std::string element(const std::string& page, const std::string& id) {
  const std::string mark = "id=\"" + id + "\">";
  const std::size_t from = page.find(mark, report_page().head.size());
  REQUIRE(from != std::string::npos);
  return page.substr(from + mark.size(), page.find("</script>", from) - from - mark.size());
}

/// The bytes of a packed element of the page, of which there must be `size`.
std::vector<unsigned char> unpacked(const std::string& page, const std::string& id, std::size_t size) {
  const std::vector<std::byte> packed_bytes = from_base64(element(page, id));
  std::vector<unsigned char> bytes(size + 1);
  uLongf length = bytes.size();
  REQUIRE(uncompress(bytes.data(), &length, reinterpret_cast<const Bytef*>(packed_bytes.data()), packed_bytes.size()) == Z_OK);
  REQUIRE(length == size);
  bytes.pop_back();
  return bytes;
}

/// A run of two cubes with `rows` rows; the quaternions of the fixture are no rotations, but numbers that can be checked.
void write_run(const TempFolder& folder, std::uint64_t rows) {
  ResultsWriter results(folder.path(), two_cubes(), kCase, kNames, {}, by_hand());
  for (std::uint64_t i = 0; i < rows; ++i) record(results, i);
  results.finish();
}

ReportOptions page_of(const TempFolder& folder, const std::string& file = {}) {
  ReportOptions o;
  o.folders = {folder.path()};
  o.output = file;
  return o;
}

/// Adds up the steps of component `channel` of both cubes over `frames` frames of 15 bytes an element.
std::vector<std::array<int, 2>> component(const std::vector<unsigned char>& bytes, std::size_t channel, std::size_t frames) {
  std::vector<std::array<int, 2>> values(frames);
  std::array<int, 2> sum{};
  for (std::size_t f = 0; f < frames; ++f)
    for (std::size_t e = 0; e < 2; ++e) {
      const std::size_t low = 30 * f + 4 * channel + e;
      const int zigzag = bytes[low] + 256 * bytes[low + 2];
      sum[e] += zigzag % 2 == 0 ? zigzag / 2 : -(zigzag + 1) / 2;
      values[f][e] = sum[e];
    }
  return values;
}

TEST_CASE("base64 is that of RFC 4648, section 10") {
  CHECK(base64_of("").empty());
  CHECK(base64_of("f") == "Zg==");
  CHECK(base64_of("fo") == "Zm8=");
  CHECK(base64_of("foo") == "Zm9v");
  CHECK(base64_of("foobar") == "Zm9vYmFy");
  const std::vector<std::byte> back = from_base64("Zm9vYg==");
  CHECK(std::string(reinterpret_cast<const char*>(back.data()), back.size()) == "foob");
}

TEST_CASE("steps of 16 bits: small ones of either sign are small numbers, and the ends meet") {
  CHECK(zigzag_step(5, 5) == 0);
  CHECK(zigzag_step(5, 4) == 1);
  CHECK(zigzag_step(5, 6) == 2);
  CHECK(zigzag_step(32767, -32768) == 2);  // one further, modulo 2^16
  CHECK(quantised(0.26, 0.1) == 3);
  CHECK(quantised(1e9, 0.1) == 32767);
}

TEST_CASE("the page holds the frames of the run within half a quantum") {
  const TempFolder folder;
  constexpr std::size_t rows = 5;
  write_run(folder, rows);
  const std::string file = folder.file("page.html");
  CHECK(report_command(page_of(folder, file)) == 0);

  const std::string page = read_text_file(file, 1U << 24U);
  CHECK(page.starts_with("<!DOCTYPE html>"));
  CHECK(page.ends_with(report_page().tail));
  CHECK(page.find("http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'") != std::string::npos);  // no request can leave it
  CHECK(element(page, "facts").find("two cubes") != std::string::npos);

  const std::vector<unsigned char> frames = unpacked(page, "frames", 15 * 2 * rows);
  // In frame f the fixture has moved the first cube by x = f and the second by (3, 4, -f).
  const double largest = std::max(4.0, double(rows - 1));
  const double quantum = largest / 32767;
  const auto x = component(frames, 0, rows), z = component(frames, 2, rows), w = component(frames, 3, rows);
  for (std::size_t f = 0; f < rows; ++f) {
    CHECK(std::abs(quantum * x[f][0] - double(f)) <= 0.5001 * quantum);
    CHECK(std::abs(quantum * z[f][1] - -double(f)) <= 0.5001 * quantum);
    CHECK(w[f][0] == std::lround(2048 * turn_of(f + 1)));  // 2048 steps of 16/32767: 1
    CHECK(w[f][1] == 0);
  }
  // A corner, 0.0866 m from the centroid: steps of a quaternion may be quantum / (2 · 0.0866 m), 23 times 1/32767 and so 16 times.
  CHECK(unpacked(page, "turn-shifts", 2) == std::vector<unsigned char>{4, 4});
  const std::vector<unsigned char> vertices = unpacked(page, "vertices", 16 * 3 * sizeof(float));
  float corner = 0;
  std::memcpy(&corner, vertices.data() + 9 * 3 * sizeof(float), sizeof corner);
  CHECK(corner == 0.2F);  // x of the second corner of the second cube
}

TEST_CASE("faces of elements of several cells are given as they are: a prism over five corners has seven") {
  const TempFolder folder;
  cases::Model m = two_cubes();
  const std::array<std::array<double, 2>, 5> house{{{0, 0}, {0.1, 0}, {0.1, 0.1}, {0.05, 0.15}, {0, 0.1}}};
  m.blocks[1].shape = geometry::make_prism(house, 0.1, 0.2);
  m.assembly =
      geometry::assemble(std::array{geometry::Part{&m.blocks[0].shape, 0.025, true}, geometry::Part{&m.blocks[1].shape, 0.025, true}}, {});
  m.joint_law.assign(m.assembly.joints.size(), 1);
  m.joint_strength.assign(m.assembly.joints.size(), 1.0);
  ResultsWriter(folder.path(), m, kCase, kNames, {}, by_hand()).finish();
  const std::vector<std::int32_t> loops = polyhedron_loops(Hdf5File::open(folder.file("run.h5")));
  std::multiset<std::int32_t> corners;
  for (std::size_t i = 0; i < loops.size(); i += 2 + static_cast<std::size_t>(loops[i + 1])) {
    CHECK(loops[i] == 1);  // the cube is one cell
    corners.insert(loops[i + 1]);
  }
  CHECK(corners == std::multiset<std::int32_t>{4, 4, 4, 4, 4, 5, 5});
}

TEST_CASE("a face is covered where bonded joints take all of its area") {
  const auto covered = [](const cases::Model& m, DryJoints dry = DryJoints::open) {
    const TempFolder folder;
    ResultsWriter(folder.path(), m, kCase, kNames, {}, by_hand()).finish();
    return covered_faces(Hdf5File::open(folder.file("run.h5")), dry);
  };
  cases::Model m = two_cubes();  // faces of 0.01 m2, of which one of each cube is a joint
  CHECK(covered(m).element == std::vector<std::int32_t>{0, 1});
  CHECK(covered(m).normal == std::vector<float>{1, 0, 0, -1, 0, 0});
  m.assembly.joints[0].area = 0.005;
  CHECK(covered(m).element.empty());
  m.assembly.joints.push_back(m.assembly.joints[0]);  // the other half
  m.joint_law.push_back(1);
  CHECK(covered(m).element == std::vector<std::int32_t>{0, 1});
  m.joint_law[1] = 0;  // dry
  CHECK(covered(m).element.empty());
  CHECK(covered(m, DryJoints::cover).element == std::vector<std::int32_t>{0, 1});
  m.assembly.joints[1] = m.assembly.joints[0];
  m.joint_law[1] = 1;
  m.assembly.joints[1].element_b = -1;  // the base: the face of the first cube alone
  CHECK(covered(m).element == std::vector<std::int32_t>{0});
  m.assembly.joints[1].face_a = 99;
  CHECK_THROWS_WITH_AS(covered(m), doctest::Contains("/model/joint: row 1 refers to no face"), FileError);
}

TEST_CASE("a face is open once the springs of half of a joint on it are broken") {
  const auto opened = [](const std::vector<solver::CrackRow>& cracks) {
    const TempFolder folder;
    const cases::Model m = two_cubes();
    ResultsWriter writer(folder.path(), m, kCase, kNames, {}, by_hand());
    writer.cracks(cracks);
    writer.finish();
    const Hdf5File run = Hdf5File::open(folder.file("run.h5"));
    return opened_faces(run, joint_opening_times(run));
  };
  const auto crack = [](double time, std::int32_t from, double area) {
    return solver::CrackRow{time, 0, from, 1 - from, {}, {}, area, solver::FailureMode::tension, solver::FailureMode::tension, time};
  };
  // The joint of 0.01 m2 is open at 3 s: at 2 s both sides together have lost 0.004 m2.
  const OpenedFaces faces = opened({crack(1.0, 0, 0.002), crack(2.0, 1, 0.002), crack(3.0, 0, 0.001), crack(4.0, 1, 0.003)});
  CHECK(faces.element == std::vector<std::int32_t>{0, 1});
  CHECK(faces.normal == std::vector<float>{1, 0, 0, -1, 0, 0});
  CHECK(faces.time == std::vector<float>{3.0F, 3.0F});
  CHECK(opened({crack(1.0, 0, 0.004)}).element.empty());
  CHECK_THROWS_WITH_AS(opened({{1.0, 7, 0, 1, {}, {}, 0.01, solver::FailureMode::tension, solver::FailureMode::tension, 1.0}}),
                       doctest::Contains("/cracks/joint: row 0 refers to no joint"), FileError);
}

TEST_CASE("a crack is an edge on the surface, and its level says how wide it is") {
  CHECK(crack_level(0) == 1);
  CHECK(crack_level(0.1e-3) == 3);
  CHECK(crack_level(0.99e-3) == 5);
  CHECK(crack_level(1e-3) == 6);
  CHECK(crack_level(5e-3) == 8);
  CHECK(crack_level(10.0) == 13);

  const TempFolder folder;
  cases::Model m = two_cubes();  // cubes of 0.1 m side by side along x; the joint between them covers their faces whole
  ResultsWriter writer(folder.path(), m, kCase, kNames, {}, by_hand());
  const std::array<float, 8> upright{1, 0, 0, 0, 1, 0, 0, 0};
  const std::array<float, 2> broken{};
  const auto frame = [&](double time, float apart) {
    const std::array<float, 6> displacement{0, 0, 0, apart, 0, 0};
    writer.frame({time, displacement, upright, broken});
  };
  frame(0.0, 0.002F);  // not open yet: no spring is broken
  frame(2.0, 0.002F);
  frame(3.0, 0.006F);
  writer.cracks(
      std::vector<solver::CrackRow>{{1.0, 0, 0, 1, {}, {}, 0.01, solver::FailureMode::tension, solver::FailureMode::tension, 1.0}});
  writer.finish();
  const Hdf5File run = Hdf5File::open(folder.file("run.h5"));
  const JointCracks cracks = joint_cracks(run, FrameReader(run));
  CHECK(cracks.elements == std::vector<std::int32_t>{0, 1});
  CHECK(cracks.level == std::vector<std::uint8_t>{0, 7, 8});
  CHECK(cracks.shown == std::vector<double>{3.0});
  REQUIRE(cracks.edges == std::vector<std::uint8_t>{4});  // of the square, all on the outside
  float length = 0;
  for (std::size_t e = 0; e < 4; ++e) {
    for (const std::size_t end : {6 * e, 6 * e + 3}) CHECK(cracks.ends[end] == doctest::Approx(0.1));  // x of the joint
    length += std::hypot(cracks.ends[6 * e + 4] - cracks.ends[6 * e + 1], cracks.ends[6 * e + 5] - cracks.ends[6 * e + 2]);
  }
  CHECK(length == doctest::Approx(0.4));
}

TEST_CASE("an edge along a face that a joint covers is inside the masonry") {
  const TempFolder folder;
  cases::Model m = two_cubes();
  geometry::Joint on_top = m.assembly.joints[0];  // of the base under the first cube: its lower face is covered
  on_top.element_b = -1, on_top.face_a = 4;
  on_top.centre = {0.05, 0.05, 0};
  m.assembly.joints.push_back(on_top);
  m.joint_law.push_back(1);
  ResultsWriter(folder.path(), m, kCase, kNames, {}, by_hand()).finish();
  const Hdf5File run = Hdf5File::open(folder.file("run.h5"));
  CHECK(joint_edges(run, {0})[0].size() == 4);  // the lower edge is still on the surface of the second cube
}

TEST_CASE("a body that goes straight down or up sinks or rises; it slides along nothing") {
  Building building;
  building.mass = {1.0, 9.0};
  Body body;
  body.mass = 1.0;
  body.box.low = {0.0, 0.0, 0.0}, body.box.high = {1.0, 0.2, 1.0};
  const auto named = [&](Vec3 displacement) {
    body.displacement = displacement;
    return body_name(body, building);
  };
  CHECK(named({0.001, 0.0, -0.03}).ends_with(", sinks"));
  CHECK(named({0.001, 0.0, 0.03}).ends_with(", rises"));
  CHECK(named({0.03, 0.0, -0.001}).ends_with(", slides"));
  Wall& wall = building.walls.emplace_back();
  wall.name = "front wall", wall.box = body.box, wall.across = 1, wall.outward = -1.0;
  body.wall = 0;
  CHECK(named({0.001, -0.001, -0.03}) == "front wall, sinks");
  CHECK(named({0.001, -0.03, -0.01}) == "front wall, moves out");
  CHECK(named({0.03, 0.0, -0.01}) == "front wall, slides along");
}

TEST_CASE("two elements move as one until their joint is open by a millimetre, and a hinge is where they turn") {
  const TempFolder folder;
  cases::Model m = two_cubes();
  m.blocks[1].fixed = false;
  for (geometry::Element& e : m.assembly.elements) e.mass.volume = 1e-3;
  ResultsWriter writer(folder.path(), m, kCase, kNames, {}, by_hand());
  const std::array<float, 8> upright{1, 0, 0, 0, 1, 0, 0, 0};
  writer.frame({0.0, std::array<float, 6>{}, upright, std::array<float, 2>{}});
  writer.cracks(
      std::vector<solver::CrackRow>{{1.0, 0, 0, 1, {}, {}, 0.01, solver::FailureMode::tension, solver::FailureMode::tension, 1.0}});
  writer.finish();
  const Hdf5File run = Hdf5File::open(folder.file("run.h5"));
  const Building building = building_of(run);
  const std::vector<Pose> start = first_poses(FrameReader(run));
  BodyFinder finder(run, building, start);
  std::vector<Pose> moved = start;
  moved[1].centre.x += 0.9e-3;
  CHECK(finder.find(2.0, moved).id == std::vector<std::uint8_t>{1, 1});
  moved[1].centre.x += 0.2e-3;
  CHECK(finder.find(0.5, moved).id == std::vector<std::uint8_t>{1, 1});  // not open yet
  const BodiesInFrame two = finder.find(2.0, moved);
  CHECK(std::set<std::uint8_t>(two.id.begin(), two.id.end()) == std::set<std::uint8_t>{1, 2});
  CHECK(two.bodies[0].displacement.x + two.bodies[1].displacement.x == doctest::Approx(1.1e-3));
  CHECK(body_name(two.bodies[0], building).find("stays in place") != std::string::npos);
  CHECK(finder.find(3.0, moved).id == two.id);  // they keep their numbers
  BodyFinder told(run, building, start);        // from a time on the bodies are those of a mechanism, however little is open
  told.take({0, 1}, 1.0);
  CHECK(told.find(0.9, start).id == std::vector<std::uint8_t>{1, 1});
  const BodiesInFrame given = told.find(1.0, start);
  CHECK(std::set<std::uint8_t>(given.id.begin(), given.id.end()) == std::set<std::uint8_t>{1, 2});
  told.take({-1, 1}, 1.0);  // -1: it stands with the base
  const BodiesInFrame standing = told.find(1.1, start);
  CHECK(std::ranges::count_if(standing.bodies, &Body::on_ground) == 1);
}

TEST_CASE("a hinge between two bodies goes with the elements at its ends") {
  const TempFolder folder;
  cases::Model m = two_cubes();
  m.blocks[1].fixed = false;
  for (geometry::Element& e : m.assembly.elements) e.mass.volume = 1e-3;
  // Three joints along y on the face between the cubes, 0.4 m from end to end.
  const geometry::Joint joint = m.assembly.joints[0];
  m.assembly.joints.assign(3, joint);
  m.joint_law.assign(3, m.joint_law[0]);
  for (int i = 0; i < 3; ++i) m.assembly.joints[static_cast<std::size_t>(i)].centre.y = 0.05 + 0.2 * (i - 1);
  ResultsWriter writer(folder.path(), m, kCase, kNames, {}, by_hand());
  const std::array<float, 8> upright{1, 0, 0, 0, 1, 0, 0, 0};
  writer.frame({0.0, std::array<float, 6>{}, upright, std::array<float, 2>{}});
  std::vector<solver::CrackRow> cracks;
  for (std::int32_t j = 0; j < 3; ++j)
    cracks.push_back({1.0, j, 0, 1, {}, {}, 0.01, solver::FailureMode::tension, solver::FailureMode::tension, 1.0});
  writer.cracks(cracks);
  writer.finish();
  const Hdf5File run = Hdf5File::open(folder.file("run.h5"));
  const Building building = building_of(run);
  const std::vector<Pose> start = first_poses(FrameReader(run));
  BodyFinder finder(run, building, start);
  // The second turns by a tenth about y, about the upper edge of the joint: x = 0.1, z = 0.1.
  std::vector<Pose> turned = start;
  const double angle = 0.1, half = 0.5 * angle;
  turned[1].rotation = rotation({std::cos(half), 0, std::sin(half), 0});
  const Vec3 hinge{0.1, 0.05, 0.1};
  turned[1].centre = hinge + turned[1].rotation * (start[1].centre - hinge);
  const BodiesInFrame found = finder.find(2.0, turned);
  REQUIRE(found.hinges.size() == 1);
  const Hinge& h = found.hinges[0];
  CHECK(h.from.x == doctest::Approx(0.1).epsilon(0.01));
  CHECK(h.from.z == doctest::Approx(0.1).epsilon(0.05));
  CHECK(std::abs(h.to.y - h.from.y) == doctest::Approx(0.4));
  CHECK(std::set<std::int32_t>(h.at_from.begin(), h.at_from.end()) == std::set<std::int32_t>{0, 1});
  CHECK(found.id[static_cast<std::size_t>(h.at_from[0])] < found.id[static_cast<std::size_t>(h.at_from[1])]);
  CHECK_FALSE(h.slides);
  // It slides along the joint, 5 mm, and more than it goes away.
  std::vector<Pose> slid = start;
  slid[1].centre = slid[1].centre + Vec3{0.004, 0.003, 0.004};
  const BodiesInFrame sliding = finder.find(3.0, slid);
  REQUIRE(sliding.hinges.size() == 1);
  CHECK(sliding.hinges[0].slides);
  CHECK(std::abs(sliding.hinges[0].to.y - sliding.hinges[0].from.y) == doctest::Approx(0.4));
  slid[1].centre.x += 0.002;  // now it goes away by 6 mm
  CHECK(finder.find(4.0, slid).hinges.empty());
}

TEST_CASE("two runs stand in one page, each under its own names") {
  const TempFolder a, b;
  write_run(a, 2);
  write_run(b, 3);
  ReportOptions o = page_of(a);
  o.folders.push_back(b.path());
  CHECK(report_command(o) == 0);
  const std::string page = read_text_file(a.file("comparison.html"), 1U << 24U);
  CHECK(unpacked(page, "frames", 15 * 2 * 2).size() == 60);
  CHECK(unpacked(page, "second-frames", 15 * 2 * 3).size() == 90);
}

TEST_CASE("an existing page stays unless it may be replaced") {
  const TempFolder folder;
  write_run(folder, 2);
  write_text_file(folder.file("report.html"), "<!DOCTYPE html>");
  CHECK_THROWS_WITH_AS(report_command(page_of(folder)), doctest::Contains("--overwrite"), FileError);
  CHECK(read_text_file(folder.file("report.html"), 100) == "<!DOCTYPE html>");
  ReportOptions again = page_of(folder);
  again.overwrite = true;
  CHECK(report_command(again) == 0);
  CHECK(read_text_file(folder.file("report.html"), 1U << 24U).size() > report_page().head.size());
}

TEST_CASE("a folder without a run and a frame without numbers are refused, and no page is left") {
  const TempFolder folder;
  CHECK_THROWS_AS(report_command(page_of(folder)), FileError);
  {
    ResultsWriter results(folder.path(), two_cubes(), kCase, kNames, {}, by_hand());
    const std::array<float, 6> displacement{std::numeric_limits<float>::quiet_NaN(), 0, 0, 0, 0, 0};
    const std::array<float, 8> quaternion{1, 0, 0, 0, 1, 0, 0, 0};
    const std::array<float, 2> broken{};
    results.frame({0.0, displacement, quaternion, broken});
    results.finish();
  }
  CHECK_THROWS_WITH_AS(report_command(page_of(folder)), doctest::Contains("/frames/displacement: row 0"), FileError);
  CHECK_FALSE(std::filesystem::exists(folder.file("report.html")));
}

}  // namespace
}  // namespace voussoir::io
