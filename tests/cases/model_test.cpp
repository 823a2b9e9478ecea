// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/model.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "tests/cases/paper_house.h"
#include "tests/cases/refused.h"

using namespace voussoir;
using namespace voussoir::cases;
using voussoir::testing::check_refused;

namespace {

BlockSpec box(std::string name, Vec3 low, Vec3 high) {
  BlockSpec b;
  b.name = std::move(name);
  b.material = "adobe";
  b.box = {low, high};
  return b;
}

/// A brick on the base and a second one on it.
Case two_bricks() {
  Case c = testing::paper_materials();
  c.base = Base{};
  c.blocks = {box("lower", {0, 0, 0}, {0.2, 0.1, 0.1}), box("upper", {0, 0, 0.1}, {0.2, 0.1, 0.2})};
  return c;
}

/// Small, so that a test of a message stays quick.
Case small_house() {
  Case c = testing::paper_flat20();
  c.house->inner_size = {0.8, 0.6};
  c.house->height = 0.4;
  c.house->openings = {testing::opening("front", 0.4, 0.4, 0.0, 0.2, 0.6)};
  return c;
}

const std::string& law_name(const Model& m, std::size_t joint) { return m.laws[static_cast<std::size_t>(m.joint_law[joint])].name; }

/// What the two sides of a joint are: "brick", "lintel", "beam", "same beam" and so on.
std::string sort_of(const Model& m, const geometry::Joint& j) {
  const auto kind = [](const Block& b) {
    return std::string(b.kind == PartKind::beam ? "beam" : b.kind == PartKind::lintel ? "lintel" : "brick");
  };
  const Block& a = m.blocks[static_cast<std::size_t>(j.element_a)];
  if (j.element_b == geometry::kBase) return kind(a) + "-base";
  const Block& b = m.blocks[static_cast<std::size_t>(j.element_b)];
  if (a.member >= 0 && a.member == b.member) return "same " + kind(a);
  return std::min(kind(a), kind(b)) + "-" + std::max(kind(a), kind(b));
}

std::map<std::string, std::set<std::string>> laws_by_sort(const Model& m) {
  std::map<std::string, std::set<std::string>> laws;
  for (std::size_t i = 0; i < m.assembly.joints.size(); ++i) laws[sort_of(m, m.assembly.joints[i])].insert(law_name(m, i));
  return laws;
}

}  // namespace

TEST_CASE("laws of a house are its own keys'") {
  Case c = testing::paper_flat40();  // its lintels have two rows
  c.joint_laws["beams"] = c.joint_laws["normal"];
  c.joint_laws["members"] = c.joint_laws["normal"];
  c.house->roof.between_beams = "beams";
  c.house->wood.between_members = "members";
  c.joints.default_law = "weak";
  c.joints.between = {{{"wood", "wood"}, "strong"}, {{"adobe", "base"}, "strong"}};
  using Laws = std::map<std::string, std::set<std::string>>;
  CHECK(laws_by_sort(build_model(c)) == Laws{{"brick-brick", {"normal"}},
                                             {"brick-base", {"normal"}},
                                             {"brick-lintel", {"members"}},
                                             {"beam-brick", {"members"}},
                                             {"same lintel", {"wood"}},
                                             {"same beam", {"wood"}},
                                             {"beam-beam", {"beams"}},
                                             {"lintel-lintel", {"members"}}});
}

TEST_CASE("beams at the edges of a flat roof may be joined by a law of their own") {
  Case c = testing::paper_flat20();
  c.house->copies = {2, 1};
  c.house->spacing = {9.0, 9.0};
  c.joint_laws["edges"] = c.joint_laws["normal"];
  c.house->roof.edge_beams = "edges";
  const Model m = build_model(c);
  std::map<std::set<std::string>, int> edges;  // joints, by the tags of the two beams
  for (std::size_t i = 0; i < m.assembly.joints.size(); ++i) {
    const geometry::Joint& joint = m.assembly.joints[i];
    if (law_name(m, i) != "edges") continue;
    ++edges[{m.blocks[static_cast<std::size_t>(joint.element_a)].tag, m.blocks[static_cast<std::size_t>(joint.element_b)].tag}];
  }
  // 17 elements a beam, two houses.
  CHECK(edges == std::map<std::set<std::string>, int>{{{"roof beam 0", "roof beam 1"}, 34}, {{"roof beam 25", "roof beam 26"}, 34}});
}

TEST_CASE("between two houses, and between a house and a block, the rules of the case hold") {
  Case c = small_house();
  c.house->openings.clear();
  c.house->roof.kind = RoofKind::none;
  c.house->copies = {2, 1};
  c.house->spacing = {1.2, 0.0};
  c.joints.default_law = "strong";
  c.joints.between = {{{"wood", "adobe"}, "weak"}};
  BlockSpec beam = box("prop", {0.0, -0.2, 0.0}, {0.2, 0.0, 0.2});
  beam.material = "wood";
  c.blocks = {beam};
  const Model m = build_model(c);
  std::set<std::string> between_houses, with_prop;
  for (std::size_t i = 0; i < m.joint_law.size(); ++i) {
    const geometry::Joint& j = m.assembly.joints[i];
    if (j.element_b == geometry::kBase) continue;
    const int a = m.blocks[static_cast<std::size_t>(j.element_a)].house, b = m.blocks[static_cast<std::size_t>(j.element_b)].house;
    if (a != b) (a < 0 || b < 0 ? with_prop : between_houses).insert(law_name(m, i));
  }
  CHECK(between_houses == std::set<std::string>{"strong"});
  CHECK(with_prop == std::set<std::string>{"weak"});
}

TEST_CASE("the first rule that applies wins, the materials in either order") {
  Case c = two_bricks();
  c.joints.between = {{{"base", "adobe"}, "weak"}, {{"adobe", "adobe"}, "dry"}, {{"adobe", "adobe"}, "strong"}};
  const Model m = build_model(c);
  REQUIRE(m.joint_law.size() == 2);
  CHECK(m.laws[0].name == "dry");
  for (std::size_t i = 0; i < 2; ++i) CHECK(law_name(m, i) == (m.assembly.joints[i].element_b == geometry::kBase ? "weak" : "dry"));
}

TEST_CASE("names are resolved before anything is built") {
  check_refused(
      two_bricks(), [](Case& c) { c.joints.default_law = "glue"; }, "joints.default",
      "unknown joint law \"glue\"; known: dry, normal, strong, weak, wood");
  check_refused(
      two_bricks(),
      [](Case& c) {
        c.joints.between = {{{"adobe", "base"}, "glue"}};
      },
      "joints.between[0].law", "unknown joint law");
  check_refused(
      two_bricks(),
      [](Case& c) {
        c.joints.between = {{{"adobe", "mud"}, "dry"}};
      },
      "joints.between[0].materials", "unknown material");
  check_refused(
      two_bricks(), [](Case& c) { c.materials["base"] = c.materials["wood"]; }, "materials.base", "another name");
  check_refused(
      two_bricks(), [](Case& c) { c.joint_laws["dry"] = {}; }, "joint_laws.dry", "another name");
  check_refused(
      two_bricks(), [](Case& c) { c.joint_laws["weak"].young = 0.0; }, "joint_laws.weak.young", "needs its modulus");
  check_refused(
      two_bricks(), [](Case& c) { c.materials["wood"].density = 0.0; }, "materials.wood.density", "above 0");
  check_refused(
      small_house(), [](Case& c) { c.house->joint = "glue"; }, "house.joint", "unknown joint law");
  check_refused(
      small_house(), [](Case& c) { c.house->wood.within_member = "glue"; }, "house.wood.within_member", "unknown joint law");
  check_refused(
      small_house(), [](Case& c) { c.house->wood.between_members = "glue"; }, "house.wood.between_members", "unknown joint law");
  check_refused(
      small_house(), [](Case& c) { c.house->roof.between_beams = "glue"; }, "house.roof.between_beams", "unknown joint law");
  check_refused(
      small_house(), [](Case& c) { c.house->roof.edge_beams = "glue"; }, "house.roof.edge_beams", "unknown joint law");
  check_refused(
      small_house(), [](Case& c) { c.house->material = "mud"; }, "house.material", "known: adobe, wood");
}

TEST_CASE("a case must describe something, and a house needs ground") {
  check_refused(
      testing::paper_materials(), [](Case&) {}, "", "nothing to simulate");
  check_refused(
      small_house(), [](Case& c) { c.base.reset(); }, "base", "needs ground");
  Case c = small_house();
  c.base.reset();
  BlockSpec slab = box("slab", {-1, -1, -0.2}, {3, 3, 0});
  slab.fixed = true;
  c.blocks = {slab};
  CHECK(build_model(c).blocks.back().name == "slab");
  c.base = Base{-0.2, {}};
  CHECK_THROWS_WITH_AS(build_model(c), doctest::Contains("overlaps"), InputError);  // the house now stands at -0.2 m, in the slab
}

TEST_CASE("segments that would fill the memory are refused by their key") {
  check_refused(
      small_house(), [](Case& c) { c.segment_size = 1e-5; }, "segments.size", "a larger segments.size makes fewer");
  check_refused(
      testing::paper_materials(),
      [](Case& c) {
        c.base = Base{};
        c.blocks = {box("slab", {0, 0, 0}, {2, 2, 1e-4})};
      },
      "block[0]", "of 2.5e-05 m (a quarter of its shortest edge)");
}

TEST_CASE("an overlap names the right block, also if a name reads like a number of geometry's") {
  check_refused(
      testing::paper_materials(),
      [](Case& c) {
        c.base = Base{};
        c.blocks = {box("block 1", {0, 0, 0}, {0.2, 0.1, 0.1}), box("block 2", {0.1, 0, 0}, {0.3, 0.1, 0.1})};
      },
      "block[1]", "block \"block 1\" (element 0): overlaps block \"block 2\" (element 1)");
}

TEST_CASE("a house stands on the base, at any height") {
  Case c = small_house();
  c.base->z = 1.25;
  const Model m = build_model(c);
  CHECK(geometry::bounds(m.blocks.front().shape).low.z == doctest::Approx(1.25));
  CHECK(std::any_of(m.assembly.joints.begin(), m.assembly.joints.end(),
                    [](const geometry::Joint& j) { return j.element_b == geometry::kBase; }));
}

TEST_CASE("free blocks: shapes, segment size, state") {
  Case c = testing::paper_materials();
  BlockSpec wedge;
  wedge.name = "wedge", wedge.material = "wood", wedge.free = true;
  wedge.polygon = {{0.0, 0.0}, {0.3, 0.0}, {0.0, 0.4}};
  wedge.extrude = {1.0, 2.0};
  wedge.velocity = {1, 2, 3};
  BlockSpec hexahedron;
  hexahedron.name = "hexahedron", hexahedron.material = "adobe", hexahedron.free = true;
  hexahedron.vertices = {{5, 0, 0}, {6, 0, 0}, {6, 1, 0}, {5, 1, 0}, {5, 0, 1}, {6, 0, 1}, {6, 1, 1}, {5, 1, 1}};
  BlockSpec tilted = box("tilted", {10.2, 0.1, 0.1}, {10, 0, 0});  // corners in any order
  tilted.free = true;
  tilted.rotate = Rotation{{0, 2, 0}, 90.0, {10, 0, 0}};
  c.blocks = {wedge, hexahedron, tilted};
  const Model m = build_model(c);
  CHECK(m.assembly.elements[0].mass.volume == doctest::Approx(0.06));
  CHECK(m.blocks[0].segment_size == doctest::Approx(0.075));
  CHECK(m.blocks[0].velocity == Vec3{1, 2, 3});
  CHECK(m.materials[static_cast<std::size_t>(m.blocks[0].material)].name == "wood");
  CHECK(m.blocks[1].segment_size == doctest::Approx(0.25));
  const geometry::Box3 b = geometry::bounds(m.blocks[2].shape);  // x goes to -z
  CHECK(b.low.z == doctest::Approx(-0.2));
  CHECK(b.high.x == doctest::Approx(10.1));
  c.segment_size = 0.05;
  for (const Block& block : build_model(c).blocks) CHECK(block.segment_size == 0.05);
}

TEST_CASE("faults of free blocks are refused with their key") {
  check_refused(
      two_bricks(), [](Case& c) { c.blocks[1].name = "lower"; }, "block[1].name", "\"lower\" is already the name of block[0]");
  check_refused(
      two_bricks(), [](Case& c) { c.blocks[1].name.clear(); }, "block[1].name", "missing");
  check_refused(
      two_bricks(), [](Case& c) { c.blocks[1].material = "mud"; }, "block[1].material", "unknown material \"mud\"; known: adobe, wood");
  check_refused(
      two_bricks(), [](Case& c) { c.blocks[0].box.reset(); }, "block[0]", "has no shape; give exactly one of");
  check_refused(
      two_bricks(),
      [](Case& c) {
        c.blocks[0].polygon = {{0, 0}, {1, 0}, {0, 1}};
      },
      "block[0]", "more than one shape");
  check_refused(
      two_bricks(),
      [](Case& c) {
        c.blocks[0].box.reset(), c.blocks[0].polygon = {{0, 0}, {1, 0}, {0, 1}};
      },
      "block[0].extrude", "missing");
  check_refused(
      two_bricks(),
      [](Case& c) {
        c.blocks[0].box.reset(), c.blocks[0].extrude = {0, 1};
      },
      "block[0].polygon", "missing");
  check_refused(
      two_bricks(), [](Case& c) { (*c.blocks[0].box)[1].z = 0.0; }, "block[0]", "");
  check_refused(
      two_bricks(),
      [](Case& c) {
        c.blocks[0].rotate = Rotation{{0, 0, 0}, 10.0, {}};
      },
      "block[0].rotate.axis", "no direction");
  check_refused(
      two_bricks(),
      [](Case& c) {
        c.blocks[0].motion = SupportMotion{Vec3{}, {}};
      },
      "block[0].motion", "only a fixed block");
  check_refused(
      two_bricks(), [](Case& c) { c.blocks[0].fixed = true, c.blocks[0].motion = SupportMotion{}; }, "block[0].motion", "exactly one of");
  check_refused(
      two_bricks(), [](Case& c) { c.blocks[0].fixed = true, c.blocks[0].velocity.x = 1; }, "block[0].velocity", "no initial velocity");
  check_refused(
      two_bricks(), [](Case& c) { c.blocks[0].fixed = c.blocks[0].free = true; }, "block[0].free", "both fixed and free");
}

TEST_CASE("faults of geometry name the blocks as the user does") {
  check_refused(
      two_bricks(), [](Case& c) { (*c.blocks[1].box)[0].z = 0.05; }, "block[1]", "block \"lower\" (element 0)");
  check_refused(
      two_bricks(), [](Case& c) { (*c.blocks[1].box)[0].z = 0.05; }, "block[1]", "block \"upper\" (element 1)");
  check_refused(
      two_bricks(), [](Case& c) { (*c.blocks[1].box)[0].z = 0.15; }, "block[1]", "block \"upper\" (element 1): touches nothing");
  check_refused(
      two_bricks(), [](Case& c) { (*c.blocks[0].box)[0].z = -0.1; }, "block[0]", "below the base");
  Case c = small_house();
  c.blocks = {box("far", {9, 9, 0}, {10, 10, 1}), box("rock", {-0.1, 0.05, 0.0}, {0.05, 0.1, 0.05})};
  check_refused(
      c, [](Case&) {}, "block[1]", "front wall (element 0)");
}

TEST_CASE("supports move with a velocity, or by a file that io reads") {
  Case c = two_bricks();
  c.blocks[0].fixed = true;
  c.blocks[0].motion = SupportMotion{Vec3{0.001, 0, 0}, {}};
  Model m = build_model(c);
  REQUIRE(m.blocks[0].support_motion == 0);
  CHECK(m.blocks[1].support_motion == -1);
  CHECK(m.support_motions[0].open_ended);
  CHECK(m.support_motions[0].displacement.back() == Vec3{0.001, 0, 0});
  CHECK(m.support_motions[0].time.back() == 1.0);
  c.blocks[0].motion = SupportMotion{{}, "lift.csv"};
  m = build_model(c);
  CHECK(m.support_motions[0].file == "lift.csv");
  CHECK(m.support_motions[0].time.empty());
  CHECK(m.support_motions[0].key == "block[0].motion.file");
  c.blocks[0].motion = SupportMotion{.to = Vec3{0, 0, -0.01}, .turn = Vec3{0, 90, 0}};
  m = build_model(c);
  CHECK(m.support_motions[0].displacement == std::vector<Vec3>{{}, {0, 0, -0.01}});
  CHECK(m.support_motions[0].rotation.at(1).y == doctest::Approx(1.5707963267948966));
  CHECK_FALSE(m.support_motions[0].open_ended);
}

TEST_CASE("fixed stones move, the pieces of one about its centroid, and all about a point of the file where one is given") {
  Case c = two_bricks();
  c.base.reset();
  c.blocks.clear();
  StonesSpec& spec = c.stones.emplace_back();
  const auto piece = [](Vec3 low, Vec3 high) { return StonePiece{geometry::make_box(low, high), {}}; };
  spec.file = "bench.obj", spec.material = c.materials.begin()->first;
  spec.stones = {{"foot", {}, true, {piece({0, 0, 0}, {0.2, 0.2, 0.2}), piece({0.2, 0, 0}, {0.6, 0.2, 0.1})}, ""},
                 {"top", {}, false, {piece({0, 0, 0.2}, {0.2, 0.2, 0.3})}, ""}};
  spec.motion = SupportMotion{{}, "turn.csv"};
  Model m = build_model(c);
  REQUIRE(m.blocks.size() == 3);
  CHECK((m.blocks[0].support_motion == 0 && m.blocks[1].support_motion == 0 && m.blocks[2].support_motion == -1));
  CHECK(norm(m.support_motions[0].about.value() - Vec3{0.25, 0.1, 0.075}) < 1e-12);
  // The pieces stay together.
  SupportHistory& h = m.support_motions[0];
  h.time = {0.0, 1.0}, h.displacement = {{}, {0.0, 0.0, -0.01}}, h.rotation = {{}, {0.0, 0.5, 0.1}};
  const Vec3 seam{0.2, 0.1, 0.05};
  const auto goes_to = [&](std::size_t i) {
    const Vec3 centroid = m.assembly.elements[i].mass.centroid;
    const SupportPose p = pose_at(h, centroid, 0.7);
    return centroid + p.displacement + rotation(p.orientation) * (seam - centroid);
  };
  CHECK(norm(goes_to(0) - goes_to(1)) < 1e-15);
  CHECK(norm(goes_to(0) - seam) > 0.005);
  c.stones[0].motion->about = Vec3{1, 2, 3};
  CHECK(build_model(c).support_motions[0].about == Vec3{1, 2, 3});
  for (Stone& s : c.stones[0].stones) s.fixed = false;
  c.blocks.push_back(box("floor", {0, 0, -0.1}, {0.6, 0.2, 0.0}));
  c.blocks[0].fixed = true;
  check_refused(
      c, [](Case&) {}, "stones[0].motion", "no stone of \"bench.obj\" is fixed");
}

TEST_CASE("loads act on free blocks that exist") {
  check_refused(
      two_bricks(),
      [](Case& c) {
        c.loads = {Load{"upper", {}, {}, {}, {}}, Load{"top", {}, {}, {}, {}}};
      },
      "load[1].block", "no [[block]] named \"top\"");
  check_refused(
      two_bricks(),
      [](Case& c) {
        c.blocks[0].fixed = true, c.loads = {Load{"lower", {}, {}, {}, {}}};
      },
      "load[0].block", "is fixed");
  check_refused(
      two_bricks(),
      [](Case& c) {
        c.loads = {Load{"upper", {}, {}, {}, {1.0, 0.5}}};
      },
      "load[0].ramp", "after its end");
}

TEST_CASE("the nearest element, the lowest of those equally near") {
  const Case c = testing::paper_flat20();
  const Model m = build_model(c);
  CHECK(nearest_element(m, m.assembly.elements[77].mass.centroid) == 77);
  for (const HistoryPoint& h : c.output.history) {
    const auto nearest = static_cast<std::size_t>(nearest_element(m, h.point));
    const double distance = norm(m.assembly.elements[nearest].mass.centroid - h.point);
    CHECK(distance < 0.08);
    for (std::size_t i = 0; i < nearest; ++i) CHECK(norm(m.assembly.elements[i].mass.centroid - h.point) > distance);
  }
}
