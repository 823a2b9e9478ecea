// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <set>

#include "cases/tables/blocks.h"
#include "cases/tables/loads.h"
#include "cases/tables/motion.h"
#include "cases/tables/output.h"
#include "cases/tables/time.h"
#include "io/input/case_file/case_tables.h"
#include "io/input/case_file/usual_ranges.h"
#include "io/input/document/history_name.h"

namespace voussoir::io {
namespace {

using namespace cases;

Table<Rotation> rotation_table() {
  using S = Rotation;
  return {"turns the block before the start",
          {value<S>("axis", &S::axis, "", any(), "direction of the axis; need not be a unit vector"),
           value<S>("angle", &S::angle, "degrees", any().possibly(0.0, usual::kMostTurn), "angle, by the right hand"),
           value<S>("about", &S::about, "m", any().possibly(0.0, usual::kFarthest), "a point of the axis")},
          [](const S& s, const RuleCheck& check) {
            if (norm(s.axis) < kShortestVector) check.fault("axis", "has no direction");
          }};
}

}  // namespace

Table<SupportMotion> support_motion_table() {
  using S = SupportMotion;
  return {
      "motion of a fixed block, of fixed stones, or of a part of the base: velocity, file, or its end",
      {value<S>("velocity", &S::velocity, "m/s", any().usually(usual::kSpeed), "constant velocity"),
       value<S>(
           "file", &S::file, "", filled(),
           "CSV of t, x, y, z in s and m, from where the support stands; a first row away from zero is a jump. Three more columns rx, ry, "
           "rz turn it: a rotation vector, axis times angle, in rad (turn is in degrees), zero in the first row. In settlement and rest t "
           "gives only the order and proportion in which supports move, not how fast"),
       value<S>("to", &S::to, "m", any().usually(usual::kAmplitude),
                "settlement and rest: how far it moves at the end, straight, in place of file"),
       value<S>("turn", &S::turn, "degrees", any().possibly(0.0, usual::kMostTurn),
                "settlement and rest: how far it turns at the end, a rotation vector (axis times angle), beside or in place of to"),
       value<S>("about", &S::about, "m", any().possibly(0.0, usual::kFarthest),
                "point about which the support turns, in axes of the case; to, or x, y, z of the file, move this point. Needs turn, or a "
                "file with "
                "rx, ry, rz; none: the centroid of the block or stone")},
      [](const S& s, const RuleCheck& check) {
        const bool ends = s.to || s.turn;
        if (s.velocity && (s.file || ends))
          check.fault(s.file ? "file" : s.to ? "to" : "turn", "does not go with velocity; give one of them");
        if (s.file && ends) check.fault(s.to ? "to" : "turn", "does not go with file; give one of them");
        if (!s.velocity && !s.file && !ends)
          check.fault("", "says nothing; give one of: velocity (m/s); file; to (m), turn (degrees) or both");
        if (s.about && !s.file && !s.turn) check.fault("about", "needs turn, or file with the columns rx, ry, rz");
      }};
}

namespace {

void check_shape(const BlockSpec& s, const RuleCheck& check) {
  std::vector<std::string> shapes;
  if (s.box) shapes.emplace_back("box");
  if (!s.vertices.empty()) shapes.emplace_back("vertices");
  if (!s.polygon.empty() || s.extrude) shapes.emplace_back(s.polygon.empty() ? "extrude" : "polygon");
  if (shapes.empty()) return check.fault("", "has no shape; give box, or vertices, or polygon and extrude");
  if (shapes.size() > 1) return check.fault(shapes[1], "does not go with " + shapes[0] + "; a block has one shape");
  if (!s.faces.empty() && s.vertices.empty()) check.fault("faces", "needs vertices = [[x, y, z], ...]");
  if (s.faces.empty() && !s.vertices.empty() && s.vertices.size() != 8)
    check.fault("vertices", "has " + std::to_string(s.vertices.size()) + " points, wanted 8, or faces beside them");
  if (!s.polygon.empty() && !s.extrude) check.fault("polygon", "needs extrude = [x0, x1]");
  if (s.polygon.empty() && s.extrude) check.fault("extrude", "needs polygon = [[y, z], ...]");
  if (!s.polygon.empty() && s.polygon.size() < 3)
    check.fault("polygon", "has " + std::to_string(s.polygon.size()) + " points, wanted 3 or more");
  if (s.extrude && (*s.extrude)[0] >= (*s.extrude)[1]) check.fault("extrude", "must be [x0, x1] with x0 < x1");
  if (s.box) {
    const Vec3 size = (*s.box)[1] - (*s.box)[0];
    if (size.x == 0.0 || size.y == 0.0 || size.z == 0.0) check.fault("box", "has no volume; give two opposite corners");
  }
}

void check_block(const BlockSpec& s, const RuleCheck& check) {
  check_shape(s, check);
  if (s.motion && !s.fixed) check.fault("motion", "needs a fixed block (fixed = true)");
  if (s.fixed && s.free) check.fault("free", "does not go with fixed = true");
  if (s.cells && s.halves) check.fault("cells", "does not go with halves = true, which is cells = [2, 1, 1]");
  if (s.cells && s.fixed) check.fault("cells", "does not go with fixed = true: a fixed block cannot crack");
  if (s.fixed && s.velocity != Vec3{}) check.fault("velocity", "does not go with fixed = true; use [block.motion]");
  if (s.fixed && s.angular_velocity != Vec3{}) check.fault("angular_velocity", "does not go with fixed = true");
}

/// Key `scale`: one factor for all components, or one each for L, T, V.
Key<Motion> scale_key() {
  Key<Motion> key = value<Motion>("scale", &Motion::scale, "", any().usually(usual::kFactor),
                                  "factor of the motion, or one each for L, T, V (for x, y, z if files are given so)");
  key.info.shape = "a number or an array [L, T, V]", key.info.types.push_back({"number", {}});
  key.read = [info = key.info](const Node& node, Motion& motion, Reading& reading, const std::string& path) {
    if (node.as<Node::Array>() != nullptr) {
      read_value(node, motion.scale, info, reading, path);
    } else if (double all = 1.0; read_value(node, all, info, reading, path)) {
      motion.scale.fill(all);
    }
  };
  return key;
}

/// Key `taper`: one length for both ends, or one each.
Key<Motion> taper_key() {
  Key<Motion> key = value<Motion>(
      "taper", [](auto& motion) -> auto& { return motion.treatment.taper; }, "s", at_least(0.0).possibly(0.0, kLongestRun),
      "half a cosine from zero at the start and to zero at the end of each component, after cut and baseline; or one each");
  key.info.shape = "a number or an array [start, end]", key.info.types.push_back({"number", {}});
  key.read = [info = key.info](const Node& node, Motion& motion, Reading& reading, const std::string& path) {
    if (node.as<Node::Array>() != nullptr) {
      read_value(node, motion.treatment.taper, info, reading, path);
    } else if (double both = 0.0; read_value(node, both, info, reading, path)) {
      motion.treatment.taper.fill(both);
    }
  };
  return key;
}

/// Key for a file of one axis; the array is Motion::xyz or Motion::ltv.
template <class Files>
Key<Motion> file_key(const char* name, Files files, std::size_t axis, const char* sentence) {
  return value<Motion>(
      name, [ files, axis ](auto& motion) -> auto& { return std::invoke(files, motion)[axis]; }, "", filled(), sentence);
}

Table<MotionIntensity> intensity_table() {
  using S = MotionIntensity;
  const std::vector<std::pair<std::string, IntensityMeasure>> measures{
      {"PGA", IntensityMeasure::pga}, {"PGV", IntensityMeasure::pgv}, {"Sa", IntensityMeasure::sa}};
  return {
      "a level that the motion is brought to, after scale",
      {required(choice<S>(
           "measure", &S::measure, "", measures,
           "peak ground acceleration, peak ground velocity, or spectral acceleration at `period` with 5 % of damping, of the horizontal "
           "components (L and T, wherever `direction` sends them, or x and y)")),
       required(value<S>("level", &S::level, "", above(0.0).possibly(1e-6, 1e4),
                         "PGA: m/s2 (not g), usually 0.5 to 45; PGV: m/s, usually 0.01 to 5; Sa: m/s2")),
       value<S>("period", &S::period, "s", within(0.01, 20.0), "of the oscillator: of Sa alone"),
       choice<S>("components", &S::components, "",
                 std::vector<std::pair<std::string, IntensityOf>>{{"each", IntensityOf::each},
                                                                  {"geometric mean", IntensityOf::geometric_mean},
                                                                  {"RotD50", IntensityOf::rotd50},
                                                                  {"larger", IntensityOf::larger}},
                 "what is brought to the level. each: both horizontal components, each by a factor of its own, and the vertical one by the "
                 "geometric mean of these factors; design codes prescribe one spectrum for both. The others use one factor for all three "
                 "components, and bring to the level the geometric mean of the two horizontal values, the median over all horizontal "
                 "directions, or the larger value")},
      [](const S& s, const RuleCheck& check) {
        const bool sa = s.measure == IntensityMeasure::sa;
        if (sa && !s.period) check.fault("measure", "needs motion.intensity.period, in s");
        if (!sa && s.period) check.fault("period", "goes with measure = \"Sa\" alone; period = [] takes an inherited one away");
        const bool pgv = s.measure == IntensityMeasure::pgv;
        if (!sa && (s.level < (pgv ? 0.01 : 0.5) || s.level > (pgv ? 5.0 : 45.0)))
          check.doubt("level", pgv ? "is unusual; usually 0.01 to 5 m/s" : "is unusual; usually 0.5 to 45 m/s2 (not g)");
      }};
}

void check_motion(const Motion& s, const RuleCheck& check) {
  const auto first_of = [&](std::array<const char*, 3> keys) -> std::string {
    for (const char* key : keys) {
      if (check.given(key)) return key;
    }
    return "";
  };
  const std::string xyz = first_of({"x", "y", "z"}), ltv = first_of({"L", "T", "V"});
  if (s.record && !xyz.empty()) return check.fault(xyz, "does not go with motion.record; give a record, or files");
  if (s.record && !ltv.empty()) return check.fault(ltv, "does not go with motion.record; give a record, or files");
  if (!xyz.empty() && !ltv.empty()) return check.fault(ltv, "does not go with motion." + xyz + "; give files for x, y, z, or for L, T, V");
  if (!xyz.empty() && s.direction != Motion{}.direction)
    return check.fault("direction", "says where L, T, V go, but files are given for x, y, z; leave it out, or give files for L, T, V");
  if (s.intensity && s.scale != Motion{}.scale && s.scale[0] == s.scale[1] && s.scale[1] == s.scale[2])
    return check.fault("scale",
                       "has no effect beside motion.intensity, by which each component gets its factor; leave one of them "
                       "out. motion.intensity.level says how strong the motion is; in a study the levels of [intensity], in place of "
                       "scales");
  if (s.treatment.to && *s.treatment.to <= s.treatment.from.value_or(0.0))
    return check.fault("to", "must be above motion.from, where the window begins");
  if (!s.record && xyz.empty() && ltv.empty()) check.fault("", "names no motion; give record, or files for x, y, z, or for L, T, V");
}

Table<HistoryPoint> history_table() {
  using S = HistoryPoint;
  return {"an element whose motion is written",
          {required(value<S>("name", &S::name, "", filled(), "its name in the results: /history/<name>")),
           required(value<S>("point", &S::point, "m", any().possibly(0.0, usual::kFarthest),
                             "the element whose centroid is nearest at the start is followed"))},
          [](const S& s, const RuleCheck& check) {
            if (!can_name_history(s.name))
              check.fault("name", "cannot name a group of the results; avoid \"time\", '/' and control characters");
          }};
}

Table<Cut> cut_table() {
  using S = Cut;
  return {"a plane; the force and the moment that pass it are written",
          {required(value<S>("name", &S::name, "", filled(), "its name in the results: /cuts/<name>")),
           required(value<S>("point", &S::point, "m", any().possibly(0.0, usual::kFarthest), "a point of the plane; moments are about it")),
           value<S>("normal", &S::normal, "", any(),
                    "across the plane, need not be a unit vector; what lies there (by centroids) acts on what lies behind"),
           value<S>("box", &S::box, "m", any().possibly(0.0, usual::kFarthest),
                    "two opposite corners: only pairs of elements across the plane with their midpoint in the box count; none: all")},
          [](const S& s, const RuleCheck& check) {
            if (!can_name_history(s.name))
              check.fault("name", "cannot name a group of the results; avoid \"time\", '/' and control characters");
            if (norm(s.normal) < kShortestVector) check.fault("normal", "has no direction");
            if (!s.box) return;
            const auto& [low, high] = *s.box;
            if (!(low.x < high.x && low.y < high.y && low.z < high.z))
              check.fault("box", "has no room in it: each coordinate of the first corner must be below that of the second");
          }};
}

}  // namespace

Table<BlockSpec> block_table() {
  using S = BlockSpec;
  return {
      "a block by itself: box, vertices, or polygon and extrude",
      {required(value<S>("name", &S::name, "", filled(), "a name of its own, for loads and messages")),
       required(value<S>("material", &S::material, "", filled(), "a name of materials")),
       value<S>("part", &S::part, "", any(),
                "the part of a building that it is of: \"front wall\", \"left wall, storey 2\", \"inner wall\", \"right gable\": blocks "
                "of a wall have drift, cracks and damage as a house's have; none: no part"),
       value<S>("box", &S::box, "m", any(), "two opposite corners"),
       value<S>("vertices", &S::vertices, "m", any(),
                "eight corners of a hexahedron, VTK order; with faces, those of any convex polyhedron"),
       value<S>("faces", &S::faces, "", any(), "numbers of vertices, from 0, of each face, counter-clockwise seen from outside"),
       value<S>("polygon", &S::polygon, "m", any(), "section of a prism along x: its corners [y, z]"),
       value<S>("extrude", &S::extrude, "m", any(), "the prism's [x0, x1]"),
       value<S>("halves", &S::halves, "", any(),
                "a box that can crack: two elements name/1 and name/2, cut at mid-length (across the longer horizontal edge), with "
                "the law materials.<name>.inside between them; the same as cells = [2, 1, 1]"),
       value<S>("cells", &S::cells, "", within(1.0, kMostCells),
                "a block that can crack: its number of cells along its length, thickness and height, elements name/1, name/2, ... with "
                "the law materials.<name>.inside between them. A box: along the longer horizontal edge, the other one, z; a polygon of "
                "four corners: along its first edge, x, its second edge; eight vertices: along the edges from the first to the second, "
                "the fourth, the fifth"),
       value<S>("fixed", &S::fixed, "", any(), "does not move, or only by [block.motion]"),
       value<S>("free", &S::free, "", any(), "may float; else touching nothing is an error"),
       value<S>("velocity", &S::velocity, "m/s", any().usually(usual::kSpeed), "at the start"),
       value<S>("angular_velocity", &S::angular_velocity, "rad/s", any().usually(usual::kSpin), "at the start, about global axes"),
       table<S>("rotate", &S::rotate, rotation_table()), table<S>("motion", &S::motion, support_motion_table())},
      check_block};
}

Table<Load> load_table() {
  using S = Load;
  return {
      "a force and a moment on a block, constant after the ramp unless they grow",
      {value<S>("block", &S::block, "", any(),
                "name of the block; empty: the first one that the force meets from `at` on, or from the points of `path`"),
       value<S>("force", &S::force, "N", any().usually(usual::kForce), "force"),
       value<S>("moment", &S::moment, "N m", any().usually(usual::kForce), "moment"),
       value<S>("at", &S::at, "m", any().possibly(0.0, usual::kFarthest),
                "point of the block where the force acts, moving with it; none: the centroid"),
       value<S>("path", &S::path, "", filled(),
                "CSV of t, x, y, z in s and m: a force that moves along these points, in place of `block` and `at`; before the first "
                "time there is none, after the last it stays at the last point"),
       value<S>("ramp", &S::ramp, "s", any().usually(usual::kDuration), "grows linearly from the first time to the second"),
       value<S>("history", &S::history, "", filled(), "CSV of t, x, y, z in s and N: the force over time, in place of `force` and `ramp`"),
       value<S>("follows", &S::follows, "", any(), "force and moment turn with the block; false: a dead load, which keeps its direction"),
       value<S>("grows", &S::grows, "", any(),
                "multiplied by the load factor of [analysis]: a pushover with pattern = \"given\", or cyclic")},
      [](const S& s, const RuleCheck& check) {
        if (s.ramp[0] > s.ramp[1]) check.fault("ramp", "must be [from, to] with from <= to");
        if (s.path && (s.at || !s.block.empty())) check.fault("path", "does not go with block or at: the force acts on what it meets");
        if (s.path && (s.history || s.ramp != Load{}.ramp || s.grows || s.moment != Vec3{}))
          check.fault("path", "goes with a force that is constant: without history, ramp, grows and moment");
        if (s.block.empty() && !s.path && !s.at)
          check.fault("block", "is missing: name a block, or give `at` or `path`, where the force acts");
        if (s.block.empty() && s.force == Vec3{} && !s.history)
          check.fault("force", "is missing: without a block, the force says which one it meets");
        if (s.block.empty() && s.history) check.fault("history", "needs a block: the file's force has no one direction");
        if (s.history && (s.force != Vec3{} || s.ramp != Load{}.ramp))
          check.fault("history", "does not go with force or ramp; its file holds the force over time");
        if (s.history && s.grows) check.fault("history", "does not go with grows = true; the load factor says how it grows");
        if (s.grows && s.ramp != Load{}.ramp) check.fault("ramp", "does not go with grows = true; the load factor says how it grows");
      }};
}

Table<Motion> motion_table() {
  using S = Motion;
  const std::vector<std::pair<std::string, std::string>> directions{{"LTV", "LTV"}, {"LVT", "LVT"}, {"TLV", "TLV"},
                                                                    {"TVL", "TVL"}, {"VLT", "VLT"}, {"VTL", "VTL"}};
  const std::vector<std::pair<std::string, std::string>> units{{"g", "g"}, {"m/s2", "m/s2"}, {"cm/s2", "cm/s2"}};
  const std::vector<std::pair<std::string, Baseline>> baselines{
      {"none", Baseline::none}, {"mean", Baseline::mean}, {"linear", Baseline::linear}, {"parabolic", Baseline::parabolic}};
  return {
      "acceleration of the base: a record, or files; any axis may be absent",
      {value<S>("record", &S::record, "", filled(),
                "\"bam-like\", \"bam-like#7\" (realisation 7 of its family; 1 to 999), a folder that holds record.toml, or a file that "
                "holds L, T and V"),
       choice<S>("direction", &S::direction, "", directions,
                 "which of L, T, V goes to x, y, z: LTV sends L along the bearing walls of a house that is not turned, TLV across them"),
       file_key("x", &S::xyz, 0, "file of the motion along x"), file_key("y", &S::xyz, 1, "file of the motion along y"),
       file_key("z", &S::xyz, 2, "file of the motion along z"), file_key("L", &S::ltv, 0, "file of the longitudinal motion"),
       file_key("T", &S::ltv, 1, "file of the transverse motion"), file_key("V", &S::ltv, 2, "file of the vertical motion"),
       choice<S>("unit", &S::unit, "", units, "of the files, where a format does not say"),
       value<S>("dt", &S::dt, "s", within(1e-6, 10.0).usually(usual::kSample),
                "between samples of the files, where a format does not say (one column)"),
       value<S>(
           "from", [](auto& s) -> auto& { return s.treatment.from; }, "s", at_least(0.0).possibly(0.0, kLongestRun),
           "of the record: the sample nearest to it shakes first, at time zero; none: its start"),
       value<S>(
           "to", [](auto& s) -> auto& { return s.treatment.to; }, "s", above(0.0).possibly(0.0, kLongestRun),
           "of the record: the last sample that shakes; none: its end"),
       choice<S>(
           "baseline", [](auto& s) -> auto& { return s.treatment.baseline; }, "", baselines,
           "taken off each component after the cut: its mean, a least-squares line, or the parabola that leaves the least mean square of "
           "velocity"),
       taper_key(), scale_key(), table<S>("intensity", &S::intensity, intensity_table())},
      check_motion};
}

Table<Output> output_table() {
  using S = Output;
  return {
      "what is written, and how often",
      {value<S>("history_interval", &S::history_interval, "s", above(0.0).usually(usual::kInterval),
                "between rows of histories; time.step = \"auto\" takes a step that divides it"),
       auto_or_number<S>("frame_interval", &S::frame_interval, "s", above(0.0).usually(usual::kFrames),
                         "between frames of the whole model; auto: 0.02, or for large models the least of 0.05, 0.1, 0.2, 0.5, ... with "
                         "which elements times frames are at most 40 million, up to a tenth of the duration; with [analysis] 0.02"),
       value<S>("ledger_interval", &S::ledger_interval, "s", above(0.0).usually(usual::kInterval),
                "between rows of energy, forces and damage"),
       table<S>("history", &S::history, history_table()), table<S>("cut", &S::cuts, cut_table())},
      [](const S& s, const RuleCheck& check) {
        std::set<std::string> cuts;
        for (std::size_t i = 0; i < s.cuts.size(); ++i) {
          if (!cuts.insert(s.cuts[i].name).second) return check.fault(path_to("cut", i) + ".name", "is the name of another cut, too");
        }
        std::set<std::string> names;
        for (std::size_t i = 0; i < s.history.size(); ++i) {
          if (!names.insert(s.history[i].name).second)
            return check.fault(path_to("history", i) + ".name", "is the name of another history, too");
        }
      }};
}

}  // namespace voussoir::io
