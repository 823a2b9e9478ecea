// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "kernels/lanes.h"
#include "kernels/law.h"
#include "kernels/laws/laws_of_side.h"
#include "kernels/laws/local.h"
#include "kernels/rows.h"
#include "kernels/segments.h"

/// A *side*: the segments of a joint that one face masters. A merged joint (both grids coincide) and a joint with the base have one side
/// that represents both faces; any other joint has two. Sides are stored in blocks of kLanes, structure of arrays inside a block, so that
/// the closed form of whole joints loads parameters of several lanes without gathers.
namespace voussoir::kernels {

/// Constants of kLanes sides. Reference configuration: body frames and global axes coincide at the start. A house has thousands of joints
/// but few kinds of joints, so congruent blocks share one SideConstants, which then stays in the near caches.
/// An unused lane has area = sss = sst = stt = 0.
struct alignas(64) SideConstants {
  double ca[3][kLanes], cb[3][kLanes];  // m, from the centroid of master / slave to the centre of the side
  double es[3][kLanes], et[3][kLanes];  // unit tangents; es × et is the outward normal of the master
  double mean[kLanes];  // 1/2: force acts at the midpoint along the mean normal; 0: at the master point (on the base; literally, Eq. 11)
  double kn[kLanes], ks[kLanes];                 // Pa/m
  double area[kLanes];                           // m2, Σ dA with the factor of Eq. 11 (1 if merged or on the base, else 1/2)
  double sss[kLanes], sst[kLanes], stt[kLanes];  // m4, Σ s² dA, Σ s t dA, Σ t² dA, same factor; Σ s dA = Σ t dA = 0
  double s_low[kLanes], s_high[kLanes], t_low[kLanes], t_high[kLanes];  // m, bounding rectangle of all contact points
  double tension[kLanes], cohesion[kLanes], tan_phi[kLanes], compression[kLanes], cap[kLanes];
  double friction[kLanes];  // tan φ of the contact that a broken bond becomes: see Strength
  double twist[kLanes];     // see Side::twist
};
/// Number of doubles per side.
inline constexpr std::size_t kSideNumbers = sizeof(SideConstants) / (sizeof(double) * kLanes);

struct WholeConstants;  // kernels/whole_sides.h

/// SideBlock::axis of blocks with a side whose `twist` is not zero. set_whole writes it.
inline constexpr std::int32_t kSolidFaces = -2;

/// kLanes sides: their constants and elements. Unused lanes are between the base and itself.
struct SideBlock {
  const SideConstants* constants = nullptr;
  const WholeConstants* whole = nullptr;       // of the same sides
  std::int32_t master[kLanes], slave[kLanes];  // elements (rows)
  std::uint32_t on_base = 0;                   // bit mask: the slave is the base, which does not move and takes no force
  std::int32_t axis = -1;                      // copy of `whole->axis`: selects the kernel before `whole` is read
};

/// One side, copied from its block, for the segment-by-segment kernels.
struct Side {
  std::int32_t master = 0, slave = 0;
  Vec3 ca, cb, es, et;
  double mean = 0.0;
  bool on_base = false;
  double factor = 0.0;  // factor of Eq. 11 on the segment areas
  Stiffness k;
  Strength strength;
  double twist = 0.0;               // what is added to 1 as a factor on the slip of bonded segments by twist, THEORY.md (11a); 0: G I_p
  const SideLaws* laws = &kNoLaws;  // the optional ones
};

/// Current frame of a side and the affine fields over it: u(s,t) = d + s·ds + t·dt in (n, 1, 2), and likewise its rate.
struct SideFrame {
  Vec3 n, t1, t2;     // orthonormal
  Vec3 es, et;        // tangents carried by the bodies (mean of both)
  Vec3 arm_a, arm_b;  // m, from the centroids to the point of action at the centre
  Local d, ds, dt;    // m, -, -
  Local v, vs, vt;    // m/s, 1/s, 1/s
};
SideFrame side_frame(const Side& side, const Pose& a, const Pose& b, const Twist& ta, const Twist& tb) noexcept;

/// An affine field over a side, in its frame: u(s,t) = d + s·ds + t·dt.
struct AffineField {
  Local d, ds, dt;
};

/// What a side's `twist` adds to u(s,t) of its bonded segments, or to its rate (THEORY.md (11a)).
inline Local added_by_twist(double twist, const Local& ds, const Local& dt, double s, double t) noexcept {
  return {0.0, twist * t * dt.s1, twist * s * ds.s2};
}

/// Force on the master and torques about both centroids from the sums.
void to_wrench(const SideFrame& f, const SideSums& sums, Vec3& force, Vec3& torque_a, Vec3& torque_b) noexcept;

/// One break or first yield of a segment.
struct SegmentEvent {
  std::int32_t side = 0, point = 0;
  Mode reached = Mode::none, broke = Mode::none;
};

/// A bounded list that a kernel may append to without allocating; the owner reserves enough for one side.
struct EventSink {
  SegmentEvent* data = nullptr;
  int count = 0;
};

/// Advances the segments of a side by one step, one by one, by the literal law. Updates `q` and appends events. \pre sink has room for
/// points.n events
SegmentTotals advance_segments(const Side& side, std::int32_t id, const SideFrame& f, PointsView p, SegmentsView q, double step,
                               double time, FailureOptions o, EventSink& sink) noexcept;

/// Elastic energy in the springs of a side as they are [J]: of bonded segments, of contacts.
struct SideEnergy {
  double bonds = 0.0, contact = 0.0;
};
SideEnergy segment_energy(const Side& side, const SideFrame& f, PointsView p, SegmentsView q) noexcept;

/// Data of one lane of a block for the kernels that process its segments.
struct SideParts {
  std::int32_t id = 0;
  double factor = 0.0, cn = 0.0, cs = 0.0;  // Eq. 11; Pa s/m, for all faces of both elements in contact
  PointsView points;
  SegmentsView segments;
  double dashpot_factor = 1.0;  // on cn and cs, at least 1: fewer faces than all have something near (THEORY.md (20d))
};

/// Copies of the forces that sides add to the elements' rows: 12 numbers a side, force and torque on the master, then force and torque on
/// the slave, dashpots included.
inline constexpr int kPairStride = 12;
struct PairForces {
  double* wrench = nullptr;
  std::uint8_t* on = nullptr;  // by side: 1; 0: no force in this step
};

/// Rows of the elements.
struct Rows {
  const double *pose = nullptr, *twist = nullptr;
  double *wrench = nullptr, *dashpot = nullptr;
  PairForces pairs;  // if it has arrays, forces are also copied there
};

/// Adds zeros to the rows of the elements of the sides `live` of a block, at the cost of adding forces. For measurements.
void assemble_zeros(const SideBlock& block, unsigned live, const Rows& rows) noexcept;

/// Result of a side whose segments were processed.
struct DamagedSide {
  double friction = 0.0, impact = 0.0, fracture = 0.0;  // J, lost in this step
  int held = 0, events = 0;
  bool touching = false;
  double slide2 = 0.0, tilt2 = 0.0;  // m2, rad2: squares of the largest slide over the rectangle of the points, and of the tilt
  double gap = 0.0;                  // m, least opening over the rectangle of the points
  AffineField u;                     // relative displacement of the faces in this step
};

/// State of a side after the last step; most states spare the processing of its segments.
enum class SideState : std::uint8_t {
  segments = 0,  // each segment must be processed
  whole = 1,     // all bonded, none slipped: closed form, if a certificate at the corners proves that no segment yields
  open = 2,      // none bonded, none touched: no force, if the corners prove that none touches now
  steady = 3     // damaged, some bonded, none touches: closed form, while the side stays near its last processed displacement (SteadySides)
};

/// Data of the steady sides of a block (THEORY.md (16a), (16b)). Lanes that are not steady are undefined.
struct alignas(64) SteadySides {
  // Displacement at which the side was processed last: u(s,t) = d + s·ds + t·dt in its frame, each (n, 1, 2) [m, -, -].
  double d[3][kLanes], ds[3][kLanes], dt[3][kLanes];
  // Moments of the bonded segments, with the factor of Eq. 11: Σ dA, Σ s dA, Σ t dA, Σ s² dA, Σ s t dA, Σ t² dA [m2, m3, m4].
  double area[kLanes], as[kLanes], at[kLanes], ass[kLanes], ast[kLanes], att[kLanes];
  // Moments of their plastic slip x along 1 and 2: Σ x dA, Σ s x dA, Σ t x dA [m3, m4, m4].
  double slip[2][kLanes], slip_s[2][kLanes], slip_t[2][kLanes];
  // Distance of the nearest segment from the limits in tension, shear and of the cap [Pa], and from touching [m].
  double to_tension[kLanes], to_shear[kLanes], to_cap[kLanes], to_contact[kLanes];
};

/// State of the sides of a block.
struct BlockState {
  const SideState* side_state = nullptr;  // kLanes
  const SteadySides* steady = nullptr;
  const SideParts* parts = nullptr;  // kLanes
  const SideLaws* laws = nullptr;    // kLanes, the optional ones; nullptr: no joint of the model has any
  std::int64_t first = 0;            // number of the first side
  unsigned live = 0;                 // bit mask of the lanes that take part
  bool look_closely = false;         // look also at open sides, which may have come apart
  bool bound_tried = false;          // in this step advance_whole has not found the lanes that take part certain to stay whole
};

/// Clock of a step.
struct StepClock {
  double dt = 0.0, time = 0.0;  // s
};

/// Advances the live sides of a block by one step: histories, events, forces on the elements' rows. A side that is whole and certified, or
/// open or steady and certain to stay so, is done in closed form; all other sides are processed segment by segment.
/// \param result  by lane, written for the returned lanes
/// \pre sink has room for all points of the live lanes
/// \return bit mask of the lanes processed segment by segment
using AdvanceSides = unsigned(const SideBlock& block, const BlockState& state, const Rows& rows, StepClock clock, FailureOptions o,
                              DamagedSide* result, EventSink& sink) noexcept;
AdvanceSides advance_sides;            // several lanes, or several segments of one lane, at a time
AdvanceSides advance_sides_reference;  // the plain twin: all segments of all lanes, one by one

/// Makes a damaged side steady if possible: some segment is bonded, no unbonded segment touches or is crushed, none is at a limit.
/// \param faces  their displacement when its segments were processed, in this step
/// \param farthest  m, greatest slide from there
/// \param known  of its block; the side's lane is written
/// \return false if the side cannot be steady; its lane of `known` is then undefined
bool make_steady(const SideBlock& block, int lane, const SideParts& parts, const AffineField& faces, double farthest, FailureOptions o,
                 SteadySides& known) noexcept;

/// Copies side `lane` out of a block.
Side side_of(const SideBlock& block, int lane, const SideParts& parts) noexcept;

/// Elastic energy of the sides of a block, taken as whole [J], by the closed form: kLanes values.
void whole_side_energies(const SideBlock& block, const double* pose, double* energy) noexcept;

}  // namespace voussoir::kernels
