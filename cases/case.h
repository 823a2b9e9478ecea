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
#include "cases/house/house_case.h"
#include "cases/solids/stones.h"
#include "geometry/segments/segment_rule.h"
#include "geometry/vec3.h"

/// The input of a simulation as plain data: the parsed case file. SI units, z up; angles in degrees, as in the file.
namespace voussoir::cases {

/// An error in the user's input. `key` is the path in the case file ("house.opening[1].width", indices from 0; empty: the whole file); the
/// message says what is wrong, the value, and what is allowed. io adds file and line.
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

inline constexpr double kLongestRun = 1e6;  // s of shaking: far above any record, and few enough steps to count

struct Time {
  std::optional<double> step;            // s; absent = "auto"
  double duration = 10.0;                // s, after settling
  std::optional<double> after_collapse;  // s; the run ends this long after the building has collapsed, or at its duration
  int multirate = 1;                     // steps from one evaluation of soft pairs to the next; 1: all pairs in every step
};

struct Damping {
  double ratio = 0.0;               // fraction of critical damping at `frequency`
  std::optional<double> frequency;  // Hz
  bool own_frequency = false;       // frequency = "auto": frequency of the mode with the largest mass in y; set by io
  std::optional<double> alpha;      // 1/s; instead of ratio and frequency
  bool debris = true;               // "keep" | "off": mass damping of elements without a bond
  bool inertial = false;            // key: frame, "ground" | "inertial": frame of the damped velocities
};

struct Material {
  double density = 0.0;  // kg/m3
  double young = 0.0;    // Pa
  double poisson = 0.0;
  std::optional<std::string> inside{};  // law between the convex pieces of a stone that is not convex (none: pieces
                                        // never separate), and between the halves of a unit
};

enum class SofteningCurve { exponential, linear };

/// Strength of a joint (Eqs. 5-7), and the mortar (Eq. 3) or the stiffness of the joint. With neither, its stiffness is that of Eq. 2.
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
  std::optional<double> residual_friction{};  // degrees, of the joint without its bond; none: friction of [contact]
  double dilatancy = 0.0;                     // degrees, of the first slip; decreases to zero with the wear of the bond
  std::optional<double> normal_stiffness{},
      shear_stiffness{};                    // k_n, k_s, Pa/m: of the joint alone, in series with its blocks; both or none
  std::optional<double> maximum_closure{};  // V, m: closure limit of a dry joint that stiffens as it closes, k_n at no pressure; else none

  [[nodiscard]] bool stiffens() const noexcept { return maximum_closure.has_value(); }  // a joint that stiffens has no bond
};

/// Random strength of joints: one factor per joint on f_t, c and f_m of its law (cases/scatter.h).
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
  std::string law;                       // name in joint_laws, or "dry"
};
struct Joints {
  std::string default_law = "dry";  // key: default
  std::vector<JointRule> between;
};

enum class ContactNormal { slave, master };
enum class Dashpots { bounded, unbounded };  // unbounded: dashpots may make a contact pull, and exceed friction
struct ContactRule {
  std::array<std::string, 2> materials;  // "base" counts as a material
  double friction = 0.0;                 // degrees
};
struct Contact {
  double friction = 32.0;            // degrees, of all pairs of materials not in `between`
  std::vector<ContactRule> between;  // each pair of materials at most once
  double damping = 1.0;              // h_n = h_s
  Dashpots dashpots = Dashpots::bounded;
  std::optional<double> restitution;  // of free bodies; none: that of the dashpots
  ContactNormal normal = ContactNormal::slave;
  double compression = 0.0;           // Pa; 0: contacts bear any pressure
  double crushing_energy = 0.0;       // J/m2, beyond the work of the residual; 0: the strength does not fall
  double residual_compression = 0.0;  // Pa
  double crushing_depth = 0.01;       // m
};

enum class Baseline { none, mean, linear, parabolic };
/// Treatment of the components of a motion before scaling (io/input/motion/treatment.h).
struct MotionTreatment {
  std::optional<double> from, to;         // s of the record: the window used as motion; its start is time zero
  Baseline baseline = Baseline::none;     // subtracted from the window
  std::array<double, 2> taper{0.0, 0.0};  // s, at the start and at the end
};

enum class IntensityMeasure { pga, pgv, sa };
/// Intensity level to which a motion is scaled by one factor (io/input/motion/spectra/intensity.h).
struct MotionIntensity {
  IntensityMeasure measure = IntensityMeasure::pga;
  double level = 0.0;            // m/s2; for PGV m/s
  std::optional<double> period;  // s, for Sa only
};

/// Base acceleration: a record (name or folder) with a direction; or files for x, y, z; or files for L, T, V with a direction.
struct Motion {
  std::optional<std::string> record;              // "bam-like", "bam-like#7", a folder holding record.toml, or a file that holds L, T and V
  std::string direction = "LTV";                  // which of L, T, V acts along x, y, z
  std::array<std::optional<std::string>, 3> xyz;  // files; keys x, y, z
  std::array<std::optional<std::string>, 3> ltv;  // files; keys L, T, V
  std::optional<std::string> unit;                // "g", "m/s2", "cm/s2": for formats without a unit
  std::optional<double> dt;                       // s: for formats without a time step
  MotionTreatment treatment;                      // keys from, to, baseline, taper
  std::array<double, 3> scale{1.0, 1.0, 1.0};     // of L, T, V (or of x, y, z for files given as such)
  std::optional<MotionIntensity> intensity;       // level reached after `scale` by one more factor for all components
};

struct HistoryPoint {
  std::string name;
  Vec3 point;  // m
};
/// A plane through the structure; the force through it is written (Output::cuts).
struct Cut {
  std::string name;
  Vec3 point, normal{0, 0, 1};             // m; normal of any length but zero, towards the part that exerts the force
  std::optional<std::array<Vec3, 2>> box;  // m, two corners: only pairs of elements with their middle in the box count
};
struct Output {
  double history_interval = 0.001;       // s
  std::optional<double> frame_interval;  // s; absent = "auto", see cases/census.h
  double ledger_interval = 0.01;         // s: rows of /energy, /forces, /damage
  std::vector<HistoryPoint> history;
  std::vector<Cut> cuts;  // key: cut
};

struct Rotation {
  Vec3 axis{0, 0, 1};
  double angle = 0.0;  // degrees
  Vec3 about;          // m
};
/// Motion of a fixed block: a constant velocity, or a file of t [s] and x, y, z [m].
struct SupportMotion {
  std::optional<Vec3> velocity;  // m/s
  std::optional<std::string> file;
};
/// A free block. Exactly one of box, vertices, polygon + extrude. `vertices` without `faces` are the eight of a hexahedron in VTK order;
/// with `faces` (loops of vertex numbers, counter-clockwise seen from outside) any convex polyhedron.
struct BlockSpec {
  std::string name, material;
  std::string part;  // of a building: "front wall", "front wall, storey 2"; empty: no part
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
  std::optional<std::string> history;    // file of t, x, y, z: force over time, in place of `force` and `ramp`
  bool follows = false;                  // the force turns with its block; else it keeps its direction (a dead load)
  bool grows = false;                    // the force is multiplied by the load factor of the analysis
};
/// A part of the ground at another height, or a moving one: a rectangle in plan, or the ground under a wall of the house.
struct BasePart {
  std::optional<std::array<double, 2>> x, y;  // m
  std::string wall;                           // front | rear | left | right, or the name of an inner wall
  std::optional<double> from, to;             // m, along the wall from the outer corner; none: the ends of the wall
  double level = 0.0;                         // m, height of its top above Base::z
  std::optional<SupportMotion> motion;
};
struct Base {
  double z = 0.0;                        // m
  std::array<double, 2> tilt{0.0, 0.0};  // degrees about x and y; rotates gravity
  std::vector<BasePart> parts;           // key: part
};

/// The contents of a case file.
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
  std::string folder;  // folder of the case file; relative paths in the case start here (not a key)
  /// Not a key: the point of the file's axes [m] that all coordinates here are relative to; none: not chosen, they are those of the file
  /// (cases/solids/origin.h).
  std::optional<Vec3> origin;

  /// Time of shaking, or of a quasi-static analysis, at which the run ends at the latest [s].
  [[nodiscard]] double end() const noexcept { return is_assessment(analysis) ? analysis.longest : time.duration; }
  void set_end(double t) noexcept { (is_assessment(analysis) ? analysis.longest : time.duration) = t; }
};

}  // namespace voussoir::cases
