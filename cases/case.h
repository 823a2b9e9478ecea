// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "cases/analysis.h"
#include "cases/solids/stones.h"
#include "geometry/segment_rule.h"
#include "geometry/vec3.h"

/// What is simulated, as plain data: the case file, read. SI units, z up; angles in degrees, as the user writes them.
namespace voussoir::cases {

/// A fault in what the user asked for. `key` is the path in the case file ("house.opening[1].width", indices from 0; empty: the whole
/// file); the message says what is wrong, the value, and what is allowed. io adds file and line.
class InputError : public std::runtime_error {
 public:
  InputError(std::string key, const std::string& problem)
      : std::runtime_error(key.empty() ? problem : key + ": " + problem), key_(std::move(key)), problem_(problem) {}
  [[nodiscard]] const std::string& key() const noexcept { return key_; }
  [[nodiscard]] const std::string& problem() const noexcept { return problem_; }

 private:
  std::string key_, problem_;
};

struct Gravity {
  Vec3 acceleration{0.0, 0.0, -9.8};  // m/s2
  bool settle = true;                 // ramp gravity and wait for rest before time zero
  std::optional<double> ramp;         // s; default five periods of damping.frequency, else 1 s
  double settle_limit = 3.0;          // s, after the ramp
};

inline constexpr double kLongestRun = 1e6;  // s of shaking: far beyond any record, and its steps can still be counted

struct Time {
  std::optional<double> step;            // s; absent = "auto"
  double duration = 10.0;                // s, after settling
  std::optional<double> after_collapse;  // s; the run ends so long after the building has collapsed, or at its duration
};

struct Damping {
  double ratio = 0.0;               // of critical, at `frequency`
  std::optional<double> frequency;  // Hz
  bool own_frequency = false;       // frequency = "auto": that of the model's mode with the largest mass in y; io fills it in
  std::optional<double> alpha;      // 1/s; instead of ratio and frequency
  bool debris = true;               // "keep" | "off": mass damping of elements without a bond
};

struct Material {
  double density = 0.0;  // kg/m3
  double young = 0.0;    // Pa
  double poisson = 0.0;
  std::optional<std::string> inside{};  // law between the convex pieces of a stone that is not convex (none: they
                                        // never part), and between the halves of a unit
};

enum class SofteningCurve { exponential, linear };

/// Strength of a joint (Eqs. 5-7) and its mortar (Eq. 3), or its own stiffness. Neither: Eq. 2.
struct JointLaw {
  double tension = 0.0;      // f_t, Pa
  double cohesion = 0.0;     // c, Pa
  double friction = 0.0;     // phi, degrees, while the bond holds
  double compression = 0.0;  // f_m, Pa
  double cap = 9.0;          // C_s
  double thickness = 0.0;    // t_M, m
  double young = 0.0;        // E_M, Pa
  double poisson = 0.0;
  double fracture_energy_tension = 0.0, fracture_energy_shear = 0.0;  // J/m2; 0: brittle in tension, failure.post_shear in shear
  SofteningCurve softening = SofteningCurve::exponential;
  std::optional<double> residual_friction{};  // degrees, of this joint without its bond; none: that of [contact]
  double dilatancy = 0.0;                     // degrees, of the first slip; dies as the bond wears
  std::optional<double> normal_stiffness{}, shear_stiffness{};  // k_n, k_s, Pa/m: of the joint alone, in series with its blocks; both or none
};

/// Random strength of joints: one factor a joint on its law's f_t, c and f_m (cases/scatter.h).
enum class Distribution { lognormal, normal, uniform };
struct Scatter {
  int seed = 0;
  double variation = 0.0;  // coefficient of variation; 0: none
  Distribution distribution = Distribution::lognormal;
  std::vector<std::string> laws;  // names of joint_laws; empty: all
};

enum class PostShear { plastic, brittle };
enum class ShearInTension { cohesion, none, coulomb };
struct Failure {
  bool shear = true;  // "on" | "off"
  PostShear post_shear = PostShear::plastic;
  ShearInTension shear_in_tension = ShearInTension::cohesion;
};

struct JointRule {
  std::array<std::string, 2> materials;  // "base" counts as a material
  std::string law;                       // a name of joint_laws, or "dry"
};
struct Joints {
  std::string default_law = "dry";  // key: default
  std::vector<JointRule> between;
};

enum class ContactNormal { slave, master };
struct ContactRule {
  std::array<std::string, 2> materials;  // "base" counts as a material
  double friction = 0.0;                 // degrees
};
struct Contact {
  double friction = 32.0;            // degrees, of all pairs of materials but those of `between`
  std::vector<ContactRule> between;  // a pair of materials at most once
  double damping = 1.0;              // h_n = h_s
  ContactNormal normal = ContactNormal::slave;
  double compression = 0.0;           // Pa; 0: contacts bear any pressure
  double crushing_energy = 0.0;       // J/m2, above what the residual takes; 0: the strength does not fall
  double residual_compression = 0.0;  // Pa
  double crushing_depth = 0.01;       // m
};

enum class Baseline { none, mean, linear, parabolic };
/// What is done to the components of a motion before they are scaled (cases/motion/treatment.h).
struct MotionTreatment {
  std::optional<double> from, to;         // s of the record: the window that shakes; its start is time zero
  Baseline baseline = Baseline::none;     // taken off what the window holds
  std::array<double, 2> taper{0.0, 0.0};  // s, at the start and at the end
};

/// Base acceleration. Either a record (name or folder) with a direction, or files for x, y, z, or files for L, T, V with a direction.
struct Motion {
  std::optional<std::string> record;              // "bam-like", "bam-like#7", a folder holding record.toml, or a file that holds L, T and V
  std::string direction = "LTV";                  // which of L, T, V goes to x, y, z
  std::array<std::optional<std::string>, 3> xyz;  // files; keys x, y, z
  std::array<std::optional<std::string>, 3> ltv;  // files; keys L, T, V
  std::optional<std::string> unit;                // "g", "m/s2", "cm/s2": where a format does not say
  std::optional<double> dt;                       // s: where a format does not say
  MotionTreatment treatment;                      // keys from, to, baseline, taper
  std::array<double, 3> scale{1.0, 1.0, 1.0};     // of L, T, V (or x, y, z when files are given so)
};

struct HistoryPoint {
  std::string name;
  Vec3 point;  // m
};
/// A plane along which the structure is thought to be parted; what goes through it is written (Output::cuts).
struct Cut {
  std::string name;
  Vec3 point, normal{0, 0, 1};             // m; of any length but zero, towards what acts
  std::optional<std::array<Vec3, 2>> box;  // m, two corners: only pairs of elements whose middle is in it
};
struct Output {
  double history_interval = 0.001;  // s
  double frame_interval = 0.02;     // s
  double ledger_interval = 0.01;    // s: rows of /energy, /forces, /damage
  std::vector<HistoryPoint> history;
  std::vector<Cut> cuts;  // key: cut
};

struct Rotation {
  Vec3 axis{0, 0, 1};
  double angle = 0.0;  // degrees
  Vec3 about;          // m
};
/// Motion of a fixed block: constant velocity, or a file of t [s], x, y, z [m].
struct SupportMotion {
  std::optional<Vec3> velocity;  // m/s
  std::optional<std::string> file;
};
/// A free-standing block. Exactly one of box, vertices, polygon + extrude. `vertices` without `faces` are the eight of a hexahedron in
/// VTK's order; with `faces` (loops of their numbers, counter-clockwise seen from outside) any convex polyhedron.
struct BlockSpec {
  std::string name, material;
  std::optional<std::array<Vec3, 2>> box;
  std::vector<Vec3> vertices;
  std::vector<std::vector<int>> faces;
  std::vector<std::array<double, 2>> polygon;
  std::optional<std::array<double, 2>> extrude;
  bool halves = false;  // two elements, cut at mid-length; materials.<name>.inside is the law between them
  bool fixed = false, free = false;
  Vec3 velocity, angular_velocity;  // m/s, rad/s, global axes
  std::optional<Rotation> rotate;
  std::optional<SupportMotion> motion;
};
struct Load {
  std::string block;
  Vec3 force, moment;                    // N, N m
  std::optional<Vec3> at;                // m, a material point; default the centroid
  std::array<double, 2> ramp{0.0, 0.0};  // s: grows linearly from the first to the second (time zero = start of shaking; also acts while
                                         // settling with the value it has at time 0)
  std::optional<std::string> history;    // file of t, x, y, z: the force over time, in place of `force` and `ramp`
  bool follows = false;                  // it turns with its block; else it keeps its direction (a dead load)
  bool grows = false;                    // it is multiplied by the load factor of the analysis
};
struct Base {
  double z = 0.0;                        // m
  std::array<double, 2> tilt{0.0, 0.0};  // degrees about x and y; turns gravity
};

struct Lintel {
  double length = 0.0, height = 0.1, element = 0.2;  // m
};
struct Opening {
  std::string wall;                                          // front | rear | left | right
  double from = 0.0, width = 0.0, sill = 0.0, height = 0.0;  // m
  std::optional<Lintel> lintel;
};
struct HouseWood {
  std::string material = "wood", within_member = "wood", between_members = "normal";
  std::optional<std::string> timber_on_timber;  // between members of timber alone; none: between_members
};
/// gables: the non-bearing walls go on as under a vault, but there is none.
enum class RoofKind { none, flat, vault, gables };
struct Roof {
  RoofKind kind = RoofKind::none;
  std::array<double, 2> beam{0.2, 0.2};  // width along x, height, m (flat)
  double element = 0.2;                  // m (flat)
  std::string between_beams = "normal";
  double radius = 1.5, thickness = 0.2, ring = 0.2;  // m (vault; radius also gables)
  int voussoirs = 25;                                // of a ring (vault, gables)
  double surcharge = 0.0;                            // kg per m2 of the roof's upper surface (flat, vault)
};
/// A rod, cable, strap or bar between two points of the model (cases/ties.h).
struct Tie {
  std::string name;
  Vec3 from, to;                                 // m
  double area = 0.0;                             // m2, of the section
  double young = 2.1e11;                         // Pa
  std::optional<double> yield{};                 // Pa; none: elastic
  double hardening = 0.0;                        // Pa, slope of stress over strain beyond yield
  std::optional<double> elongation{};            // strain at which it breaks; none: never
  double pretension = 0.0;                       // N, if its ends did not move
  bool compression = false;                      // true: a bar; false: goes slack
  std::optional<std::array<double, 2>> plate{};  // m, width and height of the anchor plates; none: each end holds one element
};
/// Rods of a house, by wall and height (cases/house/house_ties.h).
enum class HouseTieKind { along, across, corner };
struct HouseTie {
  HouseTieKind kind = HouseTieKind::along;
  std::vector<std::string> walls;  // empty: all that are built
  std::vector<double> heights;     // m, above the foot of the walls
  std::vector<double> at;          // m, across: along the wall from the outer corner
  std::optional<double> depth;     // m, along: from the outer face of the wall; none: in its middle
  double reach = 0.0;              // m, corner: along both walls, from the outer corner to the rod's ends
  Tie bar;                         // without ends
};
/// Bars through the wall from node to node of a mesh.
struct MeshConnectors {
  int every = 2;                            // nodes, along and up
  double area = 0.0, young = 2.1e11;        // m2, Pa
  std::optional<double> yield, elongation;  // Pa, strain; none: elastic, never breaks
};
/// A grid of straps on the faces of a house's walls: a net, a mesh, or a bandage if it covers some courses only.
enum class MeshFaces { both, outside, inside };
struct HouseMesh {
  std::string name;
  std::vector<std::string> walls;           // empty: all that are built
  double from = 0.0;                        // m, above the foot of the walls
  std::optional<double> to;                 // m; none: the top of the walls
  std::array<double, 2> spacing{0.2, 0.2};  // m, of the nodes along and up
  MeshFaces faces = MeshFaces::both;
  double stiffness = 0.0;            // N per m of width, force over strain
  std::optional<double> strength;    // N per m of width, at which it yields; none: elastic
  std::optional<double> elongation;  // strain at which it breaks; none: never
  std::optional<MeshConnectors> connectors;
};

/// inside: at the inner faces of the walls, flush with their top. middle: upon the walls, over their middle; the roof lies on it.
enum class RingPlace { inside, middle };
struct Reinforcement {
  std::array<double, 2> column{0.1, 0.1}, ring_beam{0.1, 0.1};  // m
  std::vector<double> bearing, nonbearing;                      // column axes, m
  double element = 0.2;                                         // length of an element of a member, m
  RingPlace ring_beam_place = RingPlace::inside;
};
enum class Bond { english, running };
struct House {
  std::array<double, 2> inner_size{5.0, 3.0};  // m
  double height = 2.4;                         // m
  std::array<double, 3> brick{0.2, 0.1, 0.1};  // length, width, height, m
  double mortar = 0.0;                         // m, of beds and upright joints; 0: the size of the brick has it in it
  Bond bond = Bond::english;
  std::string material = "adobe", joint = "normal";
  bool halves = false;  // whole bricks are two elements each; materials.<name>.inside is the law between them
  HouseWood wood;
  std::array<double, 2> origin{0.0, 0.0};  // m
  double turn = 0.0;                       // degrees about z: 0, 90, 180, 270
  std::array<int, 2> copies{1, 1};
  std::array<double, 2> spacing{8.0, 6.0};                           // m
  double bearing_wall = 0.2, nonbearing_wall = 0.2;                  // m
  std::vector<std::string> walls{"front", "right", "rear", "left"};  // those that are built
  Roof roof;
  std::vector<Opening> openings;  // key: opening
  std::optional<Reinforcement> reinforcement;
  std::vector<HouseTie> ties;     // key: tie
  std::vector<HouseMesh> meshes;  // key: mesh
};

/// The whole case file.
struct Case {
  std::string title, source;
  Gravity gravity;
  Time time;
  Damping damping;
  std::map<std::string, Material> materials;
  std::map<std::string, JointLaw> joint_laws;
  Scatter scatter;
  Failure failure;
  Joints joints;
  Contact contact;
  Analysis analysis;
  std::optional<Motion> motion;
  std::optional<double> segment_size;                                   // m; key segments.size
  geometry::SegmentRule segment_rule = geometry::SegmentRule::centres;  // key segments.rule
  Output output;
  std::optional<House> house;
  std::vector<BlockSpec> blocks;  // key: block
  std::vector<StonesSpec> stones;
  std::vector<Load> loads;  // key: load
  std::vector<Tie> ties;    // key: tie
  std::optional<Base> base;
  std::string folder;  // of the case file; relative paths in the case start here (not a key)

  /// s of shaking, or of a quasi-static analysis, after which the run ends at the latest.
  [[nodiscard]] double end() const noexcept { return is_assessment(analysis) ? analysis.longest : time.duration; }
  void set_end(double t) noexcept { (is_assessment(analysis) ? analysis.longest : time.duration) = t; }
};

}  // namespace voussoir::cases
