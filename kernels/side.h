// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "kernels/lanes.h"
#include "kernels/law.h"
#include "kernels/laws/closing.h"
#include "kernels/laws/crushing.h"
#include "kernels/laws/segment_law.h"
#include "kernels/laws/softening.h"
#include "kernels/rows.h"

/// A *side*: the segments of a joint that one face masters. A merged joint (both grids coincide) and a joint with the base have one side
/// that stands for both faces; any other joint has two. Sides are stored in blocks of kLanes, structure of arrays inside a block, so that
/// the closed form of whole joints runs over lanes without gathers of parameters.
namespace voussoir::kernels {

/// Constants of kLanes sides. Reference configuration: body frames and global axes coincide at the start. A house has thousands of joints
/// and few kinds of them, so congruent blocks share these numbers, which then stay in the near caches.
/// An unused lane has area = sss = sst = stt = 0.
struct alignas(64) SideConstants {
  double ca[3][kLanes], cb[3][kLanes];  // m, from the centroid of master / slave to the centre of the side
  double es[3][kLanes], et[3][kLanes];  // unit tangents; es × et is the outward normal of the master
  double mean[kLanes];  // 1/2: force acts at the midpoint along the mean normal; 0: at the master point (on the base; literally, Eq. 11)
  double kn[kLanes], ks[kLanes];                 // Pa/m
  double area[kLanes];                           // m2, Σ dA with the factor of Eq. 11 (1 if merged or on the base, else 1/2)
  double sss[kLanes], sst[kLanes], stt[kLanes];  // m4, Σ s² dA, Σ s t dA, Σ t² dA, same factor; Σ s dA = Σ t dA = 0
  double s_low[kLanes], s_high[kLanes], t_low[kLanes], t_high[kLanes];  // m, rectangle round all contact points
  double tension[kLanes], cohesion[kLanes], tan_phi[kLanes], compression[kLanes], cap[kLanes];
  double friction[kLanes];  // tan φ of what a broken bond becomes: see Strength
};
/// Numbers a side.
inline constexpr std::size_t kSideNumbers = sizeof(SideConstants) / (sizeof(double) * kLanes);

struct WholeConstants;  // kernels/whole_sides.h

/// kLanes sides: what they are, and between whom. Unused lanes are between the resting base and itself.
struct SideBlock {
  const SideConstants* constants = nullptr;
  const WholeConstants* whole = nullptr;       // of the same sides
  std::int32_t master[kLanes], slave[kLanes];  // elements (rows)
  std::uint32_t on_base = 0;                   // bit mask: the slave is the base, which does not move and takes no force
  std::int32_t axis = -1;                      // of `whole`, here too: it says which kernel, before anything of that is read
};

/// One side, taken out of its block, for the segment-by-segment kernels.
struct Side {
  std::int32_t master = 0, slave = 0;
  Vec3 ca, cb, es, et;
  double mean = 0.0;
  bool on_base = false;
  double factor = 0.0;  // of Eq. 11, on the segment areas
  Stiffness k;
  Strength strength;
  const SoftSide* soft = nullptr;    // its bonds soften
  const Closing* closing = nullptr;  // it stiffens as it closes
};

/// Contact points of a side, in its frame; n entries.
struct PointsView {
  const double *s = nullptr, *t = nullptr, *area = nullptr;
  int n = 0;
};

/// What kWidth segments of a side have been through for good [m]. They go through the kernel side by side, so their numbers lie together.
struct alignas(sizeof(Lanes)) SegmentSprings {
  double slip1[kWidth], slip2[kWidth], closure[kWidth];
};

/// History of the segments of a side; n entries, in the order of its points.
struct SegmentsView {
  Bond* bond = nullptr;
  Mode* first_mode = nullptr;
  double* first_time = nullptr;  // s
  SegmentSprings* springs = nullptr;

  [[nodiscard]] SegmentSprings& springs_at(int i) const noexcept { return springs[i / kWidth]; }
  [[nodiscard]] double& slip1(int i) const noexcept { return springs_at(i).slip1[i % kWidth]; }
  [[nodiscard]] double& slip2(int i) const noexcept { return springs_at(i).slip2[i % kWidth]; }
  [[nodiscard]] double& closure(int i) const noexcept { return springs_at(i).closure[i % kWidth]; }
  /// Of the segments from `i` on, a multiple of kWidth.
  [[nodiscard]] SegmentsView from(int i) const noexcept { return {bond + i, first_mode + i, first_time + i, &springs_at(i)}; }
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

/// Sums of tractions over a side, in its frame: Σ f dA, Σ s f dA, Σ t f dA.
struct SideSums {
  Local f, sf, tf;
};
/// Force on the master and torques about both centroids from the sums.
void to_wrench(const SideFrame& f, const SideSums& sums, Vec3& force, Vec3& torque_a, Vec3& torque_b) noexcept;

/// What segments did in a step.
struct SegmentTotals {
  SideSums total, dash;                                 // springs and dashpots; dashpots alone
  double friction = 0.0, impact = 0.0, fracture = 0.0;  // J, lost in this step
  int held = 0;                                         // bonded after the step
  bool touching = false;                                // some segment that is not bonded carries force
};

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

/// Advances the segments of a side by one step, one by one, by the literal law. Writes `q`; appends events. \pre sink has room for
/// points.n.
SegmentTotals advance_segments(const Side& side, std::int32_t id, const SideFrame& f, PointsView p, SegmentsView q, double step,
                               double time, FailureOptions o, EventSink& sink) noexcept;

/// What the faces of a side do along their normal: u_n(s,t) [m] and its rate [m/s], d + s·ds + t·dt.
struct NormalFields {
  double d, ds, dt, v, vs, vt;
};
/// Lets segments without a bond give way that are pressed harder than they bear, before the law of contact is asked
/// (kernels/laws/crushing.h). \param factor   of Eq. 11, on the segment areas \param crushed  m, by segment \return J, lost by it
double crush_segments(const NormalFields& f, double kn, double factor, PointsView p, SegmentsView q, double step, const Crushing& a,
                      double* crushed) noexcept;

/// What springs lost before the law of contact was asked [J].
struct GaveWay {
  double fracture = 0.0, impact = 0.0;  // by crushing; within the steps of the hyperbola
};
/// The same for a side that stiffens as it closes (kernels/laws/closing.h). \param crushing, crushed  nullptr: any pressure is borne
GaveWay close_segments(const NormalFields& f, double kn, double factor, PointsView p, SegmentsView q, double step, const Closing& a,
                       const Crushing* crushing, double* crushed) noexcept;

/// Elastic energy in the springs of a side as they are [J]: of bonded segments, of contacts.
struct SideEnergy {
  double bonds = 0.0, contact = 0.0;
};
SideEnergy segment_energy(const Side& side, const SideFrame& f, PointsView p, SegmentsView q) noexcept;

/// One lane of a block for the kernels that look at its segments.
struct SideParts {
  std::int32_t id = 0;
  double factor = 0.0, cn = 0.0, cs = 0.0;  // Eq. 11; Pa s/m
  PointsView points;
  SegmentsView segments;
};

/// Where sides leave their forces if they do not add them to the elements' rows: 12 numbers a side, the force and torque on the master,
/// then those on the slave.
inline constexpr int kPairStride = 12;
struct PairBuffer {
  double *wrench = nullptr, *dashpot = nullptr;  // the whole; the dashpots' share
  std::uint8_t* on = nullptr;                    // by side: kOnWrench, kOnDashpot or both; 0: left nothing in this step
  bool copy = false;                             // what is left here is added to the elements' rows all the same
};
inline constexpr std::uint8_t kOnWrench = 1, kOnDashpot = 2;

/// Rows of the elements.
struct Rows {
  const double *pose = nullptr, *twist = nullptr;
  double *wrench = nullptr, *dashpot = nullptr;
  PairBuffer pairs;  // if it has a buffer, forces go there (too, if it is for copies)
};

/// Adds what sides left for element e to its rows, in the order of `codes`: side × 2 + (0: as master, 1: as slave).
void gather_sides(std::span<const std::int64_t> codes, std::int64_t e, const Rows& rows) noexcept;

/// Hands out zeros for the sides `live` of a block to the rows of their elements, with the work that forces take.
void assemble_zeros(const SideBlock& block, unsigned live, const Rows& rows) noexcept;

/// What became of a side whose segments were looked at.
struct DamagedSide {
  double friction = 0.0, impact = 0.0, fracture = 0.0;  // J, lost in this step
  int held = 0, events = 0;
  bool touching = false;
  double slide2 = 0.0, tilt2 = 0.0;  // m2, rad2: largest slide of the faces over the rectangle round the points, and tilt
  double gap = 0.0;                  // m, least opening over the rectangle round the points
  AffineField u;                     // how the faces stood
};

/// What is known of a side from the last step, so that most need no look at their segments.
enum class SideState : std::uint8_t {
  segments = 0,  // look at each
  whole = 1,     // all bonded, none slipped: closed form, if a certificate at the corners proves that no segment yields
  open = 2,      // none bonded, none touched: no force, if the corners prove that none touches now
  steady = 3     // damaged, some bonded, none touches: closed form, while the side stays near where it was looked at (SteadySides)
};

/// What is known of the steady sides of a block (THEORY.md (16a), (16b)). Lanes that are not steady hold anything.
struct alignas(64) SteadySides {
  // Where each was looked at: u(s,t) = d + s·ds + t·dt in its frame, each (n, 1, 2) [m, -, -].
  double d[3][kLanes], ds[3][kLanes], dt[3][kLanes];
  // Over its bonded segments, with the factor of Eq. 11: Σ dA, Σ s dA, Σ t dA, Σ s² dA, Σ s t dA, Σ t² dA [m2, m3, m4].
  double area[kLanes], as[kLanes], at[kLanes], ass[kLanes], ast[kLanes], att[kLanes];
  // The same of their plastic slip along 1 and 2: Σ x dA, Σ s x dA, Σ t x dA.
  double slip[2][kLanes], slip_s[2][kLanes], slip_t[2][kLanes];
  // How far the nearest segment was from tension, shear and the cap [Pa], and from touching [m].
  double to_tension[kLanes], to_shear[kLanes], to_cap[kLanes], to_contact[kLanes];
};

/// The sides of a block as they stand.
struct BlockState {
  const SideState* side_state = nullptr;  // kLanes
  const SteadySides* steady = nullptr;
  const SideParts* parts = nullptr;    // kLanes
  const SoftSide* soft = nullptr;      // kLanes; nullptr: no law of the model softens
  const Crushing* crushing = nullptr;  // of all contacts; nullptr: they bear any pressure
  double* const* crushed = nullptr;    // kLanes, then by segment [m]
  const Closing* closing = nullptr;    // kLanes; nullptr: no joint of the model stiffens as it closes
  std::int64_t first = 0;              // number of the first side
  unsigned live = 0;                   // bit mask of the lanes that take part
  bool look_closely = false;           // look also at open sides, which may have come apart
  bool bound_tried = false;            // in this step advance_whole has not found the lanes that take part certain to stay whole
};

/// The clock of a step.
struct StepClock {
  double dt = 0.0, time = 0.0;  // s
};

/// One step of the live sides of a block: histories, events, forces on the elements' rows. A side that is whole and certified, or open or
/// steady and certain to stay so, is done in closed form; of the others each segment is looked at.
/// \param result  by lane, written for the lanes that are returned
/// \pre  sink has room for all points of the live lanes
/// \return bit mask of the lanes whose segments were looked at
using AdvanceSides = unsigned(const SideBlock& block, const BlockState& state, const Rows& rows, StepClock clock, FailureOptions o,
                              DamagedSide* result, EventSink& sink) noexcept;
AdvanceSides advance_sides;            // several lanes, or several segments of one, at a time
AdvanceSides advance_sides_reference;  // the plain twin: all segments of all lanes, one by one

/// Makes a damaged side steady if it can be: some segment holds, none that does not hold touches or is crushed, none is at a limit.
/// \param u  how its faces stood when its segments were looked at last, in this step
/// \param farthest  m, that it may slide from there
/// \param known  of its block; the side's lane is written
/// \return false if it cannot be; `known` then holds nothing of it
bool make_steady(const SideBlock& block, int lane, const SideParts& parts, const AffineField& u, double farthest, FailureOptions o,
                 SteadySides& known) noexcept;

/// Side `lane` of a block, with the rest of its constants.
Side side_of(const SideBlock& block, int lane, const SideParts& parts) noexcept;

/// Elastic energy of the sides of a block, taken as whole [J]: kLanes values, same closed form.
void whole_side_energies(const SideBlock& block, const double* pose, double* energy) noexcept;

}  // namespace voussoir::kernels
