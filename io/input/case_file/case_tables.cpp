// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/case_file/case_tables.h"

#include "cases/case.h"
#include "io/input/case_file/usual_ranges.h"

namespace voussoir::io {
namespace {

using namespace cases;

Table<Gravity> gravity_table() {
  using S = Gravity;
  return {"body force and the settling before time zero",
          {value<S>("acceleration", &S::acceleration, "m/s2", any().possibly(0.0, 1e3), "acceleration of free fall"),
           value<S>("settle", &S::settle, "", any(), "ramp gravity and wait for rest before time zero"),
           value<S>("ramp", &S::ramp, "s", at_least(0.0).usually(usual::kWait),
                    "length of the ramp; none: five periods of damping.frequency, else 1 s"),
           value<S>("settle_limit", &S::settle_limit, "s", at_least(0.0).usually(usual::kWait),
                    "longest wait for rest after the ramp; then the run goes on with a warning")},
          [](const S& s, const RuleCheck& check) {
            const double g = norm(s.acceleration);
            if (g == 0.0) return;
            if (s.acceleration.z >= 0.0) return check.doubt("acceleration", "does not point down; usually [0, 0, -9.81]");
            if (g < 9.0 || g > 10.5) check.doubt("acceleration", "is not that of the earth; usually [0, 0, -9.81]");
          }};
}

Table<Time> time_table() {
  using S = Time;
  return {
      "time step and duration",
      {auto_or_number<S>("step", &S::step, "s", above(0.0).usually(usual::kStep),
                         "time step; auto: the largest that divides history_interval and is at most 0.995 of the stability limit (Eq. 19)"),
       value<S>("duration", &S::duration, "s", within(0.0, kLongestRun).usually(usual::kDuration), "of the run, after settling"),
       value<S>("after_collapse", &S::after_collapse, "s", at_least(0.0).usually(usual::kWait),
                "the run ends so long after the first frame in which the building has collapsed; none: at its duration"),
       choice<S, int S::*, int>("multirate", &S::multirate, "", {{"1", 1}, {"2", 2}, {"4", 4}, {"8", 8}},
                                "steps from one evaluation of the slowest pairs of elements to the next: pairs that allow it are "
                                "evaluated once in so many steps, in half as many, ...; 1: all in every step, as in the paper. An "
                                "[analysis] takes 1")},
      nullptr};
}

/// Key `frequency`: a number in Hz, or "auto" for the model's own frequency.
Key<Damping> frequency_key() {
  Key<Damping> key = value<Damping>("frequency", &Damping::frequency, "Hz", above(0.0).usually(usual::kFrequency),
                                    "where the ratio holds: the natural frequency; auto: of the mode with the largest mass in y, computed "
                                    "before the run and kept in its case.toml (four digits)");
  key.info.shape = "\"auto\" or a number", key.info.words = {"\"auto\""};
  key.read = [info = key.info](const Node& node, Damping& damping, Reading& reading, const std::string& path) {
    damping.own_frequency = same_word(node, "\"auto\"");
    if (damping.own_frequency) {
      damping.frequency.reset();
    } else if (!reading.mistyped(node, path, info, {"auto"})) {
      read_value(node, damping.frequency, info, reading, path);
    }
  };
  key.text = [](const Damping& d) { return d.frequency ? value_text(*d.frequency) : std::string(d.own_frequency ? "\"auto\"" : ""); };
  return key;
}

Table<Damping> damping_table() {
  using S = Damping;
  return {
      "mass damping: ratio at frequency, or alpha",
      {value<S>("ratio", &S::ratio, "", from_below(0.0, 1.0).usually(usual::kRatio),
                "of critical damping, at `frequency` (Eq. 14): 0.02 for 2 %"),
       frequency_key(),
       value<S>("alpha", &S::alpha, "1/s", at_least(0.0).usually(usual::kDecay), "mass damping coefficient, instead of a ratio"),
       choice<S, bool S::*, bool>("debris", &S::debris, "", {{"keep", true}, {"off", false}}, "mass damping of elements without a bond"),
       choice<S, bool S::*, bool>("frame", &S::inertial, "", {{"ground", false}, {"inertial", true}},
                                  "velocities that are damped while it shakes: ground: relative to the moving ground, as in Eqs. 13 and "
                                  "15; inertial: absolute ones")},
      [](const S& s, const RuleCheck& check) {
        if (s.alpha && s.ratio > 0.0) check.fault("alpha", "does not go with damping.ratio; give ratio and frequency, or alpha");
        if (s.ratio > 0.0 && !s.frequency && !s.own_frequency)
          check.fault("ratio", "needs damping.frequency (Hz, > 0, or \"auto\"), where the ratio holds");
        if ((s.frequency || s.own_frequency) && !s.alpha && !check.given("ratio"))
          check.fault("frequency", "needs damping.ratio, of critical damping at this frequency");
      }};
}

Table<Material> material_table() {
  using S = Material;
  return {"a material of elements",
          {required(value<S>("density", &S::density, "kg/m3", above(0.0).usually(usual::kDensity), "mass per volume")),
           required(value<S>("young", &S::young, "Pa", above(0.0).usually(usual::kYoung), "Young's modulus")),
           required(value<S>("poisson", &S::poisson, "", from_below(0.0, 0.5).usually(usual::kPoisson), "Poisson's ratio")),
           value<S>("inside", &S::inside, "", filled(),
                    "law between the convex pieces of a stone that is not convex, and between the cells of a unit (house.cells, "
                    "wall.cells, block.cells; halves): a name of joint_laws; none: pieces of a stone never part")},
          nullptr};
}

Table<Scatter> scatter_table() {
  using S = Scatter;
  return {"random strength of joints: one factor a joint on tension, cohesion and compression of its law",
          {value<S>("seed", &S::seed, "", any(), "the same seed gives the same strengths"),
           value<S>(
               "variation", &S::variation, "", at_least(0.0).usually(usual::kVariation),
               "coefficient of variation, at most 0.33 (normal), 0.57 (uniform), 1 (lognormal); 0: all joints of a law are equally strong"),
           choice<S, Distribution S::*, Distribution>(
               "distribution", &S::distribution, "",
               {{"lognormal", Distribution::lognormal}, {"normal", Distribution::normal}, {"uniform", Distribution::uniform}},
               "of the factor, with mean 1; cut at three standard deviations"),
           value<S>("laws", &S::laws, "", any(), "names of joint_laws; none: all of them")},
          nullptr};
}

Table<Failure> failure_table() {
  using S = Failure;
  return {"options of the failure law",
          {choice<S, bool S::*, bool>("shear", &S::shear, "", {{"on", true}, {"off", false}}, "shear limit of bonded segments"),
           choice<S, PostShear S::*, PostShear>("post_shear", &S::post_shear, "",
                                                {{"plastic", PostShear::plastic}, {"brittle", PostShear::brittle}},
                                                "what a segment does after its shear limit"),
           choice<S, ShearInTension S::*, ShearInTension>(
               "shear_in_tension", &S::shear_in_tension, "",
               {{"cohesion", ShearInTension::cohesion}, {"none", ShearInTension::none}, {"coulomb", ShearInTension::coulomb}},
               "shear limit under tension: c, none, or Eq. 6 literally")},
          nullptr};
}

Table<JointRule> joint_rule_table() {
  using S = JointRule;
  return {"the law between two materials",
          {required(value<S>("materials", &S::materials, "", filled(), "the two materials; \"base\" counts as one")),
           required(value<S>("law", &S::law, "", filled(), "a name of joint_laws, or \"dry\""))},
          nullptr};
}

Table<Joints> joints_table() {
  using S = Joints;
  return {"laws of touching faces: a house's own keys, then the first of `between` that fits, then `default`",
          {value<S>("default", &S::default_law, "", filled(), "a name of joint_laws, or \"dry\": no bond, friction contact only"),
           table<S>("between", &S::between, joint_rule_table())},
          nullptr};
}

Table<ContactRule> contact_rule_table() {
  using S = ContactRule;
  return {"friction of two materials, whether they were joined or not",
          {required(value<S>("materials", &S::materials, "", filled(), "the two materials; \"base\" counts as one; a pair may stand once")),
           required(value<S>("friction", &S::friction, "degrees", from_below(0.0, 90.0).usually(usual::kFriction), "angle of friction"))},
          nullptr};
}

void check_crushing(const Contact& c, const RuleCheck& check) {
  if (c.compression <= 0.0) {
    const char* why = "needs compression (Pa, > 0): without it contacts bear any pressure";
    if (c.crushing_energy > 0.0) check.fault("crushing_energy", why);
    if (c.residual_compression > 0.0) check.fault("residual_compression", why);
    return;
  }
  if (c.residual_compression > 0.0 && c.crushing_energy <= 0.0)
    check.fault("residual_compression", "needs crushing_energy (J/m2, > 0), over which strength falls to it");
  if (c.residual_compression >= c.compression)
    check.fault("residual_compression", "is no less than compression = " + value_text(c.compression) + " Pa; allowed: 0 to below that");
}

Table<Contact> contact_table() {
  using S = Contact;
  return {
      "contact of faces without a bond",
      {value<S>("friction", &S::friction, "degrees", from_below(0.0, 90.0).usually(usual::kFriction),
                "angle of friction of all pairs of materials, broken joints too, but of those in `between`"),
       value<S>("damping", &S::damping, "", at_least(0.0).usually(usual::kDashpot), "h_n = h_s of the dashpots (Eqs. 9, 10)"),
       choice<S, Dashpots S::*, Dashpots>("dashpots", &S::dashpots, "",
                                          {{"bounded", Dashpots::bounded}, {"unbounded", Dashpots::unbounded}},
                                          "bounded: spring and dashpot together never pull and never exceed friction; unbounded: the whole "
                                          "dashpot acts while faces touch"),
       value<S>("restitution", &S::restitution, "", from_above(0.0, 1.0).usually(usual::kRestitution),
                "normal speed at which free bodies part over that at which they meet, at the point of contact; their normal dashpots then "
                "act only where a point is pressed again that has been deeper, joints keep theirs; none: that of the dashpots"),
       choice<S, ContactNormal S::*, ContactNormal>(
           "normal", &S::normal, "", {{"slave", ContactNormal::slave}, {"master", ContactNormal::master}}, "whose face gives the normal"),
       value<S>("compression", &S::compression, "Pa", at_least(0.0).usually(usual::kCompression),
                "pressure at which contacts crush: broken joints and bodies that meet at their points; 0: they bear any pressure"),
       value<S>("crushing_energy", &S::crushing_energy, "J/m2", at_least(0.0).usually(usual::kCrushing),
                "that crushing takes above the residual, more than (compression - residual)^2 / (2 k_n); 0: strength does not fall"),
       value<S>("residual_compression", &S::residual_compression, "Pa", at_least(0.0).usually(usual::kCompression),
                "that crushed contacts still bear, less than compression; needs crushing_energy"),
       value<S>("crushing_depth", &S::crushing_depth, "m", above(0.0).usually(usual::kCrushed),
                "most that a contact point is crushed: what is crushed so far is compacted and bears any pressure"),
       table<S>("between", &S::between, contact_rule_table())},
      [](const S& s, const RuleCheck& check) { check_crushing(s, check); }};
}

Table<Case> segments_table() {
  const auto size = [](auto& c) -> auto& { return c.segment_size; };
  return {
      "segments of the faces",
      {value<Case>("size", size, "m", above(0.0).usually(usual::kSegment),
                   "for all faces; none: per unit, a quarter of its shortest edge; of a block with faces, and of a piece of a stone, a "
                   "quarter of the least distance between a face and the corner farthest behind it (of a box its shortest edge)"),
       choice<Case, geometry::SegmentRule Case::*, geometry::SegmentRule>(
           "rule", &Case::segment_rule, "",
           {{"centres", geometry::SegmentRule::centres}, {"rim", geometry::SegmentRule::rim}, {"corners", geometry::SegmentRule::corners}},
           "where contact points lie: at the centres of n equal cells (the paper's; levers are short by 1/n: a wall of 0.20 m with 4 "
           "segments across overturns at three quarters of its slope), or up to the rim of each joint, with exact area and moments; "
           "corners: at the corners of each joint "
           "alone, for dry stones that turn about their edges (an impact takes the energy that Housner's block loses)"),
       choice<Case, geometry::Torsion Case::*, geometry::Torsion>(
           "torsion", &Case::segment_torsion, "", {{"paper", geometry::Torsion::paper}, {"solid", geometry::Torsion::solid}},
           "how stiff bonded joints are against a twist about their normals: G I_p (the paper's: a column of 1.0 x 0.1 m is 27 times too "
           "stiff), or Saint-Venant's constant of bars and plates in place of I_p")},
      nullptr};
}

Table<BasePart> base_part_table() {
  using S = BasePart;
  return {
      "a part of the ground above the base, as a slope has in steps, or one that moves: a rectangle in plan, or what lies under a wall of "
      "the house; walls begin upon it",
      {value<S>("x", &S::x, "m", any().usually(usual::kGround), "its two ends along x, with y; axes of the case"),
       value<S>("y", &S::y, "m", any().usually(usual::kGround), "its two ends along y"),
       value<S>("wall", &S::wall, "", any(),
                "in place of x and y: all that is under this wall: front, rear, left, right, or the name of an inner wall"),
       value<S>("from", &S::from, "m", at_least(0.0).usually(usual::kHouse),
                "with wall: start along it, from the outer corner of the house; none: its start"),
       value<S>("to", &S::to, "m", above(0.0).usually(usual::kHouse), "with wall: its end; none: the wall's"),
       required(value<S>("level", &S::level, "m", above(0.0).usually(usual::kLevel),
                         "height of its top above base.z; at most so much can it sink")),
       table<S>("motion", &S::motion, support_motion_table())},
      [](const S& s, const RuleCheck& check) {
        const bool rectangle = s.x || s.y;
        if (!rectangle && s.wall.empty()) return check.fault("", "has no place; give x and y, or wall");
        if (rectangle && !s.wall.empty()) return check.fault("wall", "does not go with x and y; give one of them");
        if (s.x.has_value() != s.y.has_value()) check.fault(s.x ? "x" : "y", "is not enough; a rectangle needs x and y");
        if (rectangle && (s.from || s.to)) check.fault(s.from ? "from" : "to", "needs wall; x and y say where a rectangle ends");
        for (const auto& [key, side] : {std::pair{"x", s.x}, std::pair{"y", s.y}}) {
          if (side && (*side)[0] >= (*side)[1]) check.fault(key, "must be [from, to] with from below to");
        }
        if (s.from && s.to && *s.from >= *s.to) check.fault("to", "must be above base.part.from");
      }};
}

Table<Base> base_table() {
  using S = Base;
  return {"fixed half-space under everything",
          {value<S>("z", &S::z, "m", any().usually(usual::kGround), "height of its top, the lowest ground"),
           value<S>("tilt", &S::tilt, "degrees", inside(-90.0, 90.0).usually(usual::kTilt), "about x and y; turns gravity"),
           table<S>("part", &S::parts, base_part_table())},
          nullptr};
}

constexpr std::size_t kMostMaterials = 2000;  // there is an entry for each pair of them

void check_reserved_names(const Case& c, const RuleCheck& check) {
  if (c.materials.size() > kMostMaterials)
    check.fault("materials",
                "has " + std::to_string(c.materials.size()) + " materials; allowed: at most " + std::to_string(kMostMaterials));
  if (c.materials.contains("base")) check.fault("materials.base", "is a reserved name: \"base\" stands for the fixed base");
  if (c.joint_laws.contains("dry")) check.fault("joint_laws.dry", "is a reserved name: \"dry\" stands for no bond");
}

}  // namespace

namespace {

Table<Case> whole_case() {
  using S = Case;
  return {"the whole case",
          {value<S>("title", &S::title, "", any(), "one line, for lists and reports"),
           value<S>("source", &S::source, "", any(), "where the numbers come from"),
           table<S>("gravity", &S::gravity, gravity_table()),
           table<S>("time", &S::time, time_table()),
           table<S>("damping", &S::damping, damping_table()),
           table<S>("materials", &S::materials, material_table()),
           table<S>("joint_laws", &S::joint_laws, joint_law_table()),
           table<S>("scatter", &S::scatter, scatter_table()),
           table<S>("failure", &S::failure, failure_table()),
           table<S>("joints", &S::joints, joints_table()),
           table<S>("contact", &S::contact, contact_table()),
           table<S>("analysis", &S::analysis, analysis_table()),
           table<S>("motion", &S::motion, motion_table()),
           table<S>(
               "segments", [](auto& c) -> auto& { return c; }, segments_table()),
           table<S>("output", &S::output, output_table()),
           table<S>("house", &S::house, house_table()),
           table<S>("wall", &S::walls, wall_table()),
           table<S>("floor", &S::floors, wall_floor_table()),
           table<S>("roof", &S::roofs, wall_roof_table()),
           table<S>("vault", &S::vaults, wall_vault_table()),
           table<S>("wall_tie", &S::wall_ties, wall_tie_table()),
           table<S>("block", &S::blocks, block_table()),
           table<S>("stones", &S::stones, stones_table()),
           table<S>("load", &S::loads, load_table()),
           table<S>("tie", &S::ties, tie_table()),
           table<S>("base", &S::base, base_table())},
          [](const Case& c, const RuleCheck& check) { check_reserved_names(c, check), check_analysis(c, check); }};
}

}  // namespace

const Table<Case>& case_table() {
  static const Table<Case> table = whole_case();
  return table;
}

}  // namespace voussoir::io
