// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "cases/model.h"
#include "geometry/grid.h"
#include "kernels/contact_patch.h"
#include "kernels/integrate.h"
#include "kernels/law.h"
#include "kernels/laws/softening.h"
#include "kernels/laws/tie_law.h"
#include "kernels/overlap.h"
#include "kernels/side.h"
#include "kernels/whole_sides.h"
#include "solver/world/array.h"
#include "solver/world/multirate.h"
#include "solver/world/search_room.h"
#include "solver/world/travel.h"

/// Everything the step works on. State arrays (what a checkpoint must hold) are listed in field_table.h; the rest is built from the model
/// by setup.h, or rebuilt from the state (candidates, the grid).
namespace voussoir::solver {

/// How a run is computed. Two change what is computed: `step`, and `merge_sides` (for the test of THEORY.md's merging).
struct Options {
  bool reference_kernels = false;  // --kernels reference: every segment on its own, in plain scalar code
  bool merge_sides = true;         // false: the literal pair of springs of Eq. 11 for coinciding grids too
  bool gather = false;             // --scatter gather: each side keeps its forces, each element adds up its own; same bits as by colour
  double cell = 0.0;               // m, cells of the decomposition; 0: chosen from the model
  std::size_t out_of_cache_from =
      25'000;  // elements from which a model is out of cache, see World::out_of_cache; a number of its own, or bits would depend on caches
  int threads = 0;             // 0: OpenMP's default
  std::optional<double> step;  // s; overrides the case
};

/// Elements, structure of arrays. Rows [0, count) are elements; row `base` is the resting base; the rest pads to whole batches
/// (kernels::kBatch) and is inert.
struct Elements {
  std::int32_t count = 0, base = 0;
  std::int64_t rows = 0;
  // State, along the global axes, velocities half a step behind positions (THEORY.md (22) to (24)).
  Array<double> ux, uy, uz;      // m, displacement of the centroid, over the ground
  Array<double> qw, qx, qy, qz;  // unit quaternion of the orientation
  Array<double> vx, vy, vz;      // m/s, over the ground
  Array<double> lx, ly, lz;      // kg m2/s, angular momentum about the centroid
  Array<double> wx, wy, wz;      // rad/s
  Array<double> tally;        // J, see kernels::Tally
  Array<double> alpha;        // 1/s (changes where debris loses its damping)
  Array<std::int32_t> bonds;  // bonded segment sides left
  // Constants.
  Array<double> mass, inv_mass;                // kg, 1/kg
  Array<double> ixx, iyy, izz, ixy, ixz, iyz;  // inverse inertia, body axes
  std::vector<std::uint8_t> principal;         // by batch, see kernels::ElementsView
  std::vector<kernels::BodyConstants> body;
  Array<double> radius;                              // m, round the centroid
  Array<double> half_x, half_y, half_z;              // m, half extents of a body-frame box about the centroid
  std::vector<std::int32_t> first_face, face_count;  // into World::faces
  std::vector<std::int32_t> bonds_at_start;
  std::vector<std::uint8_t> fixed;
  // Rows, see kernels/rows.h; those of velocities are kept up to date for active batches alone (travel.h).
  Array<double> pose, twist, wrench, dashpot;

  [[nodiscard]] kernels::ElementsView view() noexcept;
  /// Writes the velocity row of an element from its state.
  void store_velocity_row(std::int32_t element) noexcept;
  /// Of all elements.
  void store_velocity_rows() noexcept;
};

/// Contact points of congruent patches, stored once: the segment geometry of 4,000 equal bricks is read from L1.
struct PointSets {
  std::vector<std::int32_t> first, count;  // by set; first is a multiple of kLanes
  Array<double> s, t, area;                // padded to kLanes with area 0
  std::int32_t largest = 0;                // points
  [[nodiscard]] kernels::PointsView view(std::int32_t set) const noexcept;
};

/// Sides of joints, in blocks of kLanes, blocks in tasks, tasks in colours (decomposition.h). A side's number is block × kLanes + lane.
struct Sides {
  Array<kernels::SideConstants> constants;  // of blocks that are alike
  Array<kernels::WholeConstants> whole;     // of the same blocks
  Array<kernels::SideBlock> blocks;
  std::vector<std::int32_t> task_first;  // blocks of task t: [task_first[t], task_first[t + 1])
  std::vector<std::int32_t> task_level;  // by task and level (multirate.h): the first block of its sides of that level; one more at the end
  std::vector<std::int32_t> colour_first;  // tasks of colour c: [colour_first[c], colour_first[c + 1])
  std::int32_t overflow_colour = -1;       // one task; −1: none
  std::vector<std::int32_t> live;          // blocks with a side that is not retired, ascending
  std::vector<std::int32_t> live_first;    // by task, into `live`; tasks + 1 entries
  std::vector<std::int32_t> live_level;    // by task and level, into `live`: as task_level
  std::vector<std::uint8_t> live_lanes;    // by block, bit mask of the sides that are not retired
  // Constants by side.
  std::vector<std::int32_t> joint, set;               // joint −1: unused lane
  std::vector<std::int32_t> master_face, slave_face;  // into World::faces
  std::vector<std::uint8_t> faces;                    // 2: a merged side, stands for both faces
  std::vector<kernels::SideParts> parts;              // with views of the point sets and of the segments' state below
  std::vector<double> size;                           // m, segment size of the master
  // --scatter gather, or World::keep_pairs: what each side left; for the former also where each element finds its own (side × 2 + (0:
  // master, 1: slave), ascending).
  Array<double> pair_wrench, pair_dashpot;
  std::vector<std::uint8_t> pair_on;
  std::vector<std::int64_t> first_gather, gather;  // by element, count + 1 entries; codes
  ZeroArray<kernels::SteadySides> steady;          // State by block: of its steady sides
  std::vector<kernels::SoftSide> soft;             // by side; empty: no law of the model softens
  ZeroArray<double> wear;                          // State by segment of the sides that soften, kernels/laws/softening.h
  std::vector<kernels::Closing> closing;           // by side; empty: no joint of the model stiffens as it closes
  std::vector<double*> crushed_of;                 // by side, into `crushed`; empty: contacts bear any pressure
  ZeroArray<double> crushed;                       // m, State by segment, kernels/laws/crushing.h
  // State by side.
  Array<kernels::SideState> side_state;
  Array<std::uint8_t> retired;               // lives on as free patches
  Array<std::int32_t> held;                  // bonded segments
  Array<double> friction, impact, fracture;  // J, lost so far
  // State by segment.
  Array<kernels::Bond> bond;
  ZeroArray<kernels::Mode> first_mode;
  ZeroArray<double> first_time;
  ZeroArray<kernels::SegmentSprings> springs;  // of kWidth segments each

  [[nodiscard]] std::int64_t count() const noexcept { return static_cast<std::int64_t>(joint.size()); }
  [[nodiscard]] kernels::Side side(std::int64_t id) const noexcept;
  /// How the bonds of a side soften; nullptr: they do not.
  [[nodiscard]] const kernels::SoftSide* soft_side(std::int64_t id) const noexcept {
    return soft.empty() || soft[static_cast<std::size_t>(id)].wear == nullptr ? nullptr : &soft[static_cast<std::size_t>(id)];
  }
  [[nodiscard]] kernels::SegmentsView segments(std::int64_t id) const noexcept { return parts[static_cast<std::size_t>(id)].segments; }
};

/// A free patch and what it has been through: three cache lines, all of which a patch needs that is pushed.
struct alignas(64) FreePatch : kernels::Patch {
  std::int32_t set = 0;                                               // of its points in World::points
  std::int32_t touching = 0;                                          // points with a partner (state)
  std::int64_t first_point = 0;                                       // into the arrays by point, a multiple of kLanes
  double stored = 0.0, friction = 0.0, impact = 0.0, fracture = 0.0;  // J (state)
};
static_assert(sizeof(FreePatch) == 192);

/// Free patches: segments in no joint, or whose joint has come apart. Grows as sides retire.
struct Patches {
  Array<FreePatch> patch;
  std::vector<std::int32_t> element;  // by patch: Patch::element, close together (derived)
  double beyond = 0.0;                // m, by which the rectangle of some patch reaches out of the box round its element (derived)
  // State by patch.
  Array<std::int32_t> from_side;  // the side it comes from, −1: never joined
  Array<std::uint8_t> mastered;   // 1: its element was the master of from_side
  // State by point.
  Array<std::int32_t> partner, face;
  ZeroArray<kernels::PointSprings> springs;  // of kWidth points each
  Array<double> crushed;                     // m; empty: contacts bear any pressure

  [[nodiscard]] kernels::ContactPoints points(std::int64_t p) noexcept;
};

/// Numbers by their level of multi-rate stepping (multirate.h), each level ascending: those that are due in a step come first.
struct ByLevel {
  std::vector<std::int32_t> list;
  std::vector<std::int64_t> end;  // by level
  /// \param level  of each number from 0 on; those of `levels` or above are left out
  void sort(const std::vector<std::uint8_t>& level, int levels);
};

/// Possible contacts: for each active patch a few candidates, each with a slot for its wrench; every element gathers
/// its slots in a fixed order, so no two threads ever add to one row.
struct Contacts {
  static constexpr int kUpToDate = 127;  // no level is as high
  geometry::UniformGrid grid;            // of elements where they were searched last
  SearchRoom room;
  int stale_level = kUpToDate;           // the lowest level (multirate.h) of slots that were added since the gather lists were made
  std::vector<std::int32_t> active;      // patches with candidates
  std::vector<std::int64_t> first_slot;  // by active patch, count + 1 entries
  std::vector<std::int32_t> master;      // by active patch: its element (derived)
  Array<std::int32_t> element;           // by slot: who may be touched (state)
  Array<kernels::Candidate> candidate;   // by slot: the same, and what is known of the pair (derived)
  Array<kernels::PairWrench> wrench;
  std::vector<std::uint8_t> on;
  std::vector<std::int64_t> first_gather;  // by element, count + 1 entries: its room in `gather`
  std::vector<std::int64_t> last_gather;   // by element: where its entries end; the rest of its room is for slots that come later
  std::vector<std::int32_t> gather;        // slot × 2 + (0: master, 1: slave), ascending
  std::vector<std::int32_t> place;  // the way back: by slot × 2 + (0, 1), where it stands among these; −1: the base, which gathers none
  std::vector<std::uint8_t> gather_on;  // `on` of their slots, and 8 zeros: few push, and these are found 8 at a time
  // Of multi-rate stepping; else empty. A patch has the lowest level of its pairs.
  std::vector<std::uint8_t> level;         // by active patch
  std::vector<std::uint8_t> gather_level;  // by entry of `gather`, and 8 zeros
  ByLevel patches, gatherers;              // active patches; elements with entries in `gather`, by the lowest of these
  std::int64_t searched = 0;               // active patches whose candidates a search found; the others are new (state)
  std::int64_t searches = 0;
};

/// The spring between two elements that overlap by more than is allowed (all of it state).
struct OverlapSpring {
  std::int32_t a = 0, b = 0;
  Vec3 shear;                      // m, elongation along the contact, in the body axes of a
  double stored = 0.0;             // J
  Vec3 force, torque_a, torque_b;  // N, N m: elastic part at the last step, on a; b gets −force
};

/// Contact of whole bodies by their exact overlap, where contact points see too little: at edges, corners and crossed edges, and deep
/// inside (THEORY.md (21a)).
struct Overlaps {
  // Constants.
  std::vector<Vec3> vertices, edges;             // of all shapes: from the centroid, m; unit directions
  std::vector<kernels::Crease> creases;          // of all shapes
  std::vector<kernels::ConvexShape> shape;       // different ones once; the faces of the first element that has it
  std::vector<std::int32_t> shape_of;            // by element
  std::vector<double> stiffness_n, stiffness_s;  // N/m, by element; the base is rigid: 0
  std::vector<double> allowed;                   // m, by element
  // Derived.
  std::vector<OverlapPair> pairs;  // ascending (a, b); state, since at several rates elements are moved by them
  ByLevel by_level;                // of pairs; empty unless multi-rate
  // State.
  std::vector<OverlapSpring> springs;       // ascending (a, b)
  std::vector<kernels::PairWrench> wrench;  // of each spring with its dashpot in this step, if World::keep_pairs (derived)
  double friction = 0.0, impact = 0.0;      // J, lost so far
};

/// Bars between points of elements (cases/ties.h).
struct Ties {
  struct Hold {
    std::int32_t tie = 0, element = 0;
    double share = 0.0;  // of the tie's force; negative at its first end
    Vec3 arm;            // m, from the centroid (of the base: from its reference point), body axes
  };
  struct Tie {
    kernels::TieLaw law;
    Vec3 axis;                                   // unit, from the first end to the second at the start
    double length = 0.0;                         // m, at the start
    double pretension = 0.0;                     // N
    double wanted = 0.0;                         // N/m, E A / length; law.stiffness is less where the step allows no more
    std::int32_t first_hold = 0, last_hold = 0;  // into `hold`
  };
  // Constants.
  std::vector<Tie> tie;
  std::vector<Hold> hold;                                       // by tie, the first end before the second
  std::vector<std::int32_t> element;                            // that are held and move or are fixed blocks, ascending
  std::vector<std::int32_t> first_of_element, hold_of_element;  // by entry of `element`; ascending, into `hold`
  // State.
  std::vector<kernels::TieState> state;
  std::vector<double> jack;  // m, elongation of the pretension so far
  // Of the last step.
  std::vector<double> jack_work;  // J
  std::vector<Vec3> pull;         // N, along the tie, on its first end
};

/// Loads and supports that act on single elements.
struct PointLoad {
  std::int32_t element = 0;
  Vec3 force, moment, arm;                         // N, N m; m, from the centroid, body axes
  double ramp_begin = 0, ramp_end = 0;             // s
  const cases::SupportHistory* history = nullptr;  // of the force, in place of the ramp
  bool follows = false;                            // force and moment turn with the element
  bool grows = false;                              // multiplied by the load factor (run/load_program.h)
};
struct Support {
  std::int32_t element = 0;
  const cases::SupportHistory* history = nullptr;
};

struct World {
  explicit World(const cases::Model& m) : model(m) {}

  const cases::Model& model;
  Options options;
  kernels::FailureOptions failure;
  kernels::ContactOptions contact;
  std::vector<double> friction;  // tan φ, the table that `contact` sees: Model::contact_friction
  bool has_base = false;
  bool out_of_cache = false;  // the model is larger than the caches, see joints/out_of_cache.h
  bool drop_debris_damping = false;
  double dt = 0.0;  // s
  Multirate multirate;
  double bound = 0.0;       // s, Eq. 19
  int threads = 1;          // of the teams that work on it
  bool keep_pairs = false;  // in this step sides and overlaps leave a copy of their forces, for cuts
  Elements elements;
  std::vector<kernels::Face> faces;  // of all elements, one more for the base
  std::int32_t most_faces = 1;       // of one element
  PointSets points;
  Sides sides;
  Patches patches;
  Travel travel;
  Contacts contacts;
  Overlaps overlaps;
  Ties ties;
  /// Those that pairs of that level (multirate.h) read and write, and the step that they take.
  [[nodiscard]] kernels::Bodies bodies(int level = 0) const noexcept;
  [[nodiscard]] kernels::Rows rows(int level = 0) noexcept;
  [[nodiscard]] const double* twist_rows(int level) const noexcept;
  [[nodiscard]] double step_of(int level) const noexcept { return level == 0 ? dt : multirate.steps_of(level) * dt; }
  [[nodiscard]] kernels::ContactOptions contact_of(int level) const noexcept;
  [[nodiscard]] kernels::ElementRows element_rows() noexcept;

  /// The base, or a part of it.
  [[nodiscard]] bool is_ground(std::int32_t element) const noexcept {
    return faces[static_cast<std::size_t>(elements.first_face[static_cast<std::size_t>(element)])].is_ground();
  }

  /// s, by which an element is moved on at a time.
  [[nodiscard]] double step_of_element(std::size_t e) const noexcept { return step_of(batch_level(e / kernels::kBatch)); }
  [[nodiscard]] int batch_level(std::size_t batch) const noexcept { return multirate.on() ? moved_at[batch] : 0; }

  std::vector<PointLoad> loads;
  std::vector<Support> supports;
  // State by batch of multi-rate stepping, else empty: the level (multirate.h) in whose steps its elements are moved on, by all of these
  // steps at once. None of their pairs has a lower one.
  std::vector<std::uint8_t> moved_at;
};

}  // namespace voussoir::solver
