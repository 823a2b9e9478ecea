// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/state/field_table.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <type_traits>

#include "solver/run/run.h"
#include "solver/state/hash.h"

namespace voussoir::solver {

namespace {

using Table = std::vector<Field>;

template <class T>
constexpr FieldType type_of() {
  if constexpr (std::is_same_v<T, double>) return FieldType::f64;
  if constexpr (std::is_same_v<T, std::int64_t>) return FieldType::i64;
  if constexpr (std::is_same_v<T, std::int32_t>) return FieldType::i32;
  static_assert(sizeof(T) == 1 || std::is_same_v<T, double> || std::is_same_v<T, std::int64_t> || std::is_same_v<T, std::int32_t>);
  return FieldType::u8;
}

/// An array of numbers. For choices (enumerations, flags) `high` is the last.
template <class Column>
Field field(const char* name, const char* unit, const char* shape, Column& a) {
  return {name, unit, shape, type_of<typename Column::value_type>(), a.data(), a.size()};
}
template <class Column>
Field field(const char* name, const char* unit, const char* shape, Column& a, std::int64_t low, std::int64_t high) {
  Field f = field(name, unit, shape, a);
  f.low = low, f.high = high;
  return f;
}

/// A single value.
template <class T>
Field value(const char* name, const char* unit, T& v) {
  return {name, unit, "run", type_of<T>(), &v, 1};
}
template <class T>
Field value(const char* name, T& v, std::int64_t low, std::int64_t high) {
  return {name, "-", "run", type_of<T>(), &v, 1, 1, low, high};
}

/// An array whose entries are rows of several values of type V.
template <class V, class Column>
Field rows(const char* name, const char* unit, const char* shape, Column& a, std::size_t columns) {
  const std::size_t values = a.size() * sizeof(typename Column::value_type) / sizeof(V);
  return {name, unit, shape, type_of<V>(), a.data(), values / columns, columns};
}

/// A member of the entries of an array, or of those that lie together in each: `together` of them from `first` on.
template <class T, class Column>
Field member(const char* name, const char* unit, const char* shape, Column& a, T* first, std::size_t together = 1) {
  return {.name = name,
          .unit = unit,
          .shape = shape,
          .type = type_of<T>(),
          .data = first,
          .count = a.size() * together,
          .together = together,
          .stride = sizeof(typename Column::value_type)};
}

template <class T, class Column>
Field member(const char* name, const char* unit, const char* shape, Column& a, T* first, std::int64_t low, std::int64_t high) {
  Field f = member(name, unit, shape, a, first);
  f.low = low, f.high = high;
  return f;
}

void add_elements(Table& t, Elements& e) {
  const char* shape = "element";
  t.insert(t.end(), {field("ux", "m", shape, e.ux), field("uy", "m", shape, e.uy), field("uz", "m", shape, e.uz),
                     field("qw", "-", shape, e.qw), field("qx", "-", shape, e.qx), field("qy", "-", shape, e.qy),
                     field("qz", "-", shape, e.qz), field("vx", "m/s", shape, e.vx), field("vy", "m/s", shape, e.vy),
                     field("vz", "m/s", shape, e.vz), field("lx", "kg m2/s", shape, e.lx), field("ly", "kg m2/s", shape, e.ly),
                     field("lz", "kg m2/s", shape, e.lz), field("wx", "rad/s", shape, e.wx), field("wy", "rad/s", shape, e.wy),
                     field("wz", "rad/s", shape, e.wz), field("alpha", "1/s", shape, e.alpha), field("bonds", "-", shape, e.bonds)});
  t.push_back(rows<double>("books", "J", "batch of elements", e.tally, kernels::kTallies));
  // These rows could be made from the columns, but only by the drift of a step are they the same to the last bit.
  t.push_back(rows<double>("pose", "m, -", shape, e.pose, kernels::kPoseStride));
}

void add_sides(Table& t, Sides& s) {
  kernels::SegmentSprings none;
  kernels::SegmentSprings& first = s.springs.size() == 0 ? none : s.springs[0];
  const auto of_segments = [&](const char* name, double* at) { return member(name, "m", "segment", s.springs, at, kernels::kWidth); };
  t.insert(t.end(), {field("side_quick", "-", "side", s.side_state, 0, 3), field("side_retired", "-", "side", s.retired, 0, 1),
                     field("side_held", "-", "side", s.held), field("side_friction", "J", "side", s.friction),
                     field("side_impact", "J", "side", s.impact), field("side_fracture", "J", "side", s.fracture),
                     field("segment_bond", "-", "segment", s.bond, 0, 3), field("segment_first_mode", "-", "segment", s.first_mode, 0, 3),
                     field("segment_first_time", "s", "segment", s.first_time), of_segments("segment_slip1", first.slip1),
                     of_segments("segment_slip2", first.slip2), of_segments("segment_closure", first.closure)});
  for (LawState& kept : s.law_state) t.push_back(field(kept.name, kept.unit, kept.shape, kept.values));
  t.push_back(rows<double>("side_steady", "SI", "block of sides", s.steady, sizeof(kernels::SteadySides) / sizeof(double)));
}

// What a patch of a retired side is made of follows from the side: see restore().
void add_patches(Table& t, World& w) {
  Patches& p = w.patches;
  const std::int64_t sides = w.sides.count(), elements = w.elements.base + 1, faces = static_cast<std::int64_t>(w.faces.size());
  FreePatch nobody;
  kernels::PointSprings none;
  FreePatch& first = p.patch.empty() ? nobody : p.patch.front();
  kernels::PointSprings& springs = p.springs.size() == 0 ? none : p.springs[0];
  const auto of_patch = [&](const char* name, const char* unit, auto* at) { return member(name, unit, "patch", p.patch, at); };
  const auto of_points = [&](const char* name, double* at) { return member(name, "m", "point", p.springs, at, kernels::kWidth); };
  t.insert(t.end(),
           {field("patch_from_side", "-", "patch", p.from_side, -1, sides - 1), field("patch_mastered", "-", "patch", p.mastered, 0, 1),
            of_patch("patch_touching", "-", &first.touching), of_patch("patch_stored", "J", &first.stored),
            of_patch("patch_friction", "J", &first.friction), of_patch("patch_impact", "J", &first.impact),
            field("point_partner", "-", "point", p.partner, -1, elements - 1), field("point_face", "-", "point", p.face, -1, faces - 1),
            of_points("point_slip_x", springs.slip_x), of_points("point_slip_y", springs.slip_y), of_points("point_slip_z", springs.slip_z),
            of_points("point_closure", springs.closure)});
  if (w.contact.restitution > 0.0) t.push_back(field("point_pressed", "m", "point", p.pressed));
  if (!w.contact.crushing.on()) return;
  t.push_back(of_patch("patch_fracture", "J", &first.fracture));
  t.push_back(field("point_crushed", "m", "point", p.crushed));
}

void add_overlaps(Table& t, World& w) {
  Overlaps& o = w.overlaps;
  OverlapSpring none;
  OverlapSpring& first = o.springs.empty() ? none : o.springs.front();
  constexpr std::size_t kValues = (offsetof(OverlapSpring, dashpot) - offsetof(OverlapSpring, shear)) / sizeof(double);
  const std::int64_t elements = w.elements.base + 1;
  const char* shape = "overlap spring";
  t.insert(t.end(), {member("overlap_a", "-", shape, o.springs, &first.a, 0, elements - 2),
                     member("overlap_b", "-", shape, o.springs, &first.b, 1, elements - 1)});
  t.push_back(member("overlap_spring", "m, J, N, N m", shape, o.springs, &first.shear.x, kValues));
  t.insert(t.end(), {value("overlap_friction", "J", o.friction), value("overlap_impact", "J", o.impact)});
}

// The pairs that searches have listed. Forces do not depend on them; at several rates they decide how often an element is moved. The hash
// of a state leaves them out.
void add_listed_pairs(Table& t, World& w) {
  std::vector<OverlapPair>& pairs = w.overlaps.pairs;
  OverlapPair none;
  OverlapPair& first = pairs.empty() ? none : pairs.front();
  const std::int64_t elements = w.elements.base + 1;
  t.insert(t.end(), {member("listed_a", "-", "pair that may overlap", pairs, &first.a, 0, elements - 2),
                     member("listed_b", "-", "pair that may overlap", pairs, &first.b, 1, elements - 1)});
}

// What dashpots of whole bodies take is in the books of elements already; by itself it only tells whether such bodies give energy out. The
// hash leaves it out, as it does the pairs above.
void add_overlap_dashpots(Table& t, World& w) {
  Overlaps& o = w.overlaps;
  OverlapSpring none;
  OverlapSpring& first = o.springs.empty() ? none : o.springs.front();
  constexpr std::size_t kValues = (sizeof(OverlapSpring) - offsetof(OverlapSpring, dashpot)) / sizeof(double);
  t.push_back(member("overlap_dashpot", "N, N m", "overlap spring", o.springs, &first.dashpot.x, kValues));
  t.push_back(value("overlap_dashpots", "J", o.dashpots));
}

void add_ties(Table& t, Ties& ties) {
  if (ties.state.empty()) return;
  kernels::TieState& first = ties.state.front();
  constexpr std::size_t kValues = offsetof(kernels::TieState, broken) / sizeof(double);
  t.push_back(member("tie_state", "m, N, J", "tie", ties.state, &first.elongation, kValues));
  t.push_back(member("tie_broken", "-", "tie", ties.state, &first.broken, 0, 1));
  t.push_back(field("tie_jack", "m", "tie", ties.jack));
}

void add_multirate(Table& t, World& w) {
  if (w.multirate.wanted == 1) return;
  Multirate& m = w.multirate;
  static constexpr std::array<const char*, 3> kVelocities = {"level_1_velocity", "level_2_velocity", "level_3_velocity"};
  for (std::size_t level = 1; level < m.every.size(); ++level)
    t.push_back(rows<double>(kVelocities[level - 1], "m/s, rad/s", "element", m.rows[level - 1].twist, kernels::kTwistStride));
  const auto highest = static_cast<std::int64_t>(m.every.size()) - 1;
  t.push_back(field("contact_level", "-", "element", m.of_contacts, 0, highest));
  t.push_back(field("moved_at_level", "-", "batch", w.moved_at, 0, highest));
  t.push_back(field("search_reach", "m", "element", *w.travel.state().reach));
}

// When the next search is due depends on where elements were at the last one. The order of candidates decides between equals.
void add_search(Table& t, World& w) {
  Contacts& c = w.contacts;
  const Travel::State travel = w.travel.state();
  const auto [ux, uy, uz, qw, qx, qy, qz] = travel.poses;
  const char* shape = "element";
  const auto patches = static_cast<std::int64_t>(w.patches.patch.size()), slots = static_cast<std::int64_t>(c.element.size()),
             elements = std::int64_t{w.elements.base} + 1;
  t.insert(t.end(),
           {field("searched_ux", "m", shape, *ux), field("searched_uy", "m", shape, *uy), field("searched_uz", "m", shape, *uz),
            field("searched_qw", "-", shape, *qw), field("searched_qx", "-", shape, *qx), field("searched_qy", "-", shape, *qy),
            field("searched_qz", "-", shape, *qz), value("search_due", *travel.due_at_once, 0, 1),
            value("search_countdown", *travel.countdown, 0, std::numeric_limits<std::int32_t>::max()), value("searches", "-", c.searches),
            value("searched_patches", c.searched, 0, static_cast<std::int64_t>(c.active.size())),
            field("active_patch", "-", "active patch", c.active, 0, patches - 1),
            field("active_first_slot", "-", "active patch", c.first_slot, 0, slots)});
  t.push_back(field("slot_element", "-", "slot", c.element, 0, elements - 1));
}

}  // namespace

/// The friend of those who keep their state to themselves.
struct FieldTable {
  static void add(Table& t, Ledger& l) {
    static_assert(sizeof(EnergyRow) == 11 * sizeof(double));
    t.insert(t.end(),
             {value("ledger_fresh", l.fresh_, 0, 1), value("ledger_initial", "J", l.initial_), value("ledger_loads", "J", l.loads_),
              value("ledger_supports", "J", l.supports_), value("ledger_scale", "J", l.scale_), value("ledger_worst", "-", l.worst_),
              rows<double>("ledger_support_wrench", "N, N m", "support", l.support_wrench_, 6)});
    t.push_back({"ledger_last_row", "s, J, -", "run", FieldType::f64, &l.last_, 1, 11});
  }

  /// Of a quasi-static analysis alone: checkpoints and hashes of time histories hold nothing of it.
  static void add(Table& t, LoadProgram& p) {
    if (!p.active()) return;
    static_assert(sizeof(Drive) % sizeof(double) == 0 && sizeof(LoadProgram::State) % sizeof(double) == 0);
    t.push_back({"program_drive", "SI", "run", FieldType::f64, &p.drive_, 1, sizeof(Drive) / sizeof(double)});
    t.push_back({"program", "SI", "run", FieldType::f64, &p.state_, 1, sizeof(LoadProgram::State) / sizeof(double)});
    t.push_back(rows<double>("program_shape", "-", "element", p.shape_, 3));
  }

  static void add(Table& t, Simulation& s) {
    static_assert(sizeof(Damage) == 5 * sizeof(std::int64_t) && sizeof(Vec3) == 3 * sizeof(double) &&
                  sizeof(Quaternion) == 4 * sizeof(double));
    t.insert(t.end(), {value("phase", s.phase_, 0, 1), value("step", s.step_, 0, std::numeric_limits<std::int64_t>::max() / 2),
                       value("peak_speed", "m/s", s.peak_speed_)});
    t.push_back(value("largest_move", "m", s.moved_));
    const auto segment_sides = 2 * static_cast<std::int64_t>(s.world().sides.bond.size());  // at most
    t.push_back({"damage", "-", "run", FieldType::i64, &s.damage_, 1, 5, 0, segment_sides});
    t.push_back(rows<double>("load_before", "N, N m", "load", s.load_before_, 6));
    if (!s.load_start_.empty()) t.push_back(rows<double>("load_start", "m", "load", s.load_start_, 3));
    t.push_back(rows<double>("followed_start", "m", "history", s.start_, 3));
    t.push_back(rows<double>("followed_turned", "-", "history", s.turned_, 4));
    add(t, s.ledger_);
    add(t, s.program_);
    if (!s.relaxation_.on()) return;
    t.push_back({"relaxation", "SI", "run", FieldType::f64, &s.relaxation_.state_, 1, sizeof(Relaxation::State) / sizeof(double)});
    t.push_back({"path", "SI", "run", FieldType::f64, &s.path_.state_, 1, sizeof(Path::State) / sizeof(double)});
    t.push_back({"lead", "SI", "run", FieldType::f64, &s.lead_.state_, 1, sizeof(Lead::State) / sizeof(double)});
    t.push_back({"lead_way", "m", "run", FieldType::f64, &s.lead_.ahead_, 1});
    t.push_back(rows<double>("lead_pose", "m, -", "element", s.lead_.pose_, Lead::kPose));
    t.push_back(rows<double>("lead_motion", "-, rad/m", "element", s.lead_.rate_, Lead::kRate));
  }
};

std::size_t size_of(FieldType type) noexcept {
  return type == FieldType::f64 || type == FieldType::i64 ? 8U : type == FieldType::i32 ? 4U : 1U;
}

namespace {

/// Calls use(in memory, among the packed values, bytes) for every piece of a field that lies together.
template <class Use>
void each_piece(const Field& f, Use&& use) {
  constexpr std::size_t kPage = 4096;
  auto* data = static_cast<std::byte*>(f.data);
  const std::size_t piece = f.stride == 0 ? kPage : f.together * f.columns * size_of(f.type), stride = f.stride == 0 ? kPage : f.stride;
  for (std::size_t at = 0; at < f.bytes(); at += piece, data += stride) use(data, at, std::min(piece, f.bytes() - at));
}

}  // namespace

std::vector<std::byte> packed(const Field& f) {
  std::vector<std::byte> values(f.bytes());
  each_piece(f, [&](const std::byte* from, std::size_t at, std::size_t n) { std::memcpy(values.data() + at, from, n); });
  return values;
}

void unpack(std::span<const std::byte> values, const Field& f) {
  each_piece(f, [&](std::byte* to, std::size_t at, std::size_t n) {
    if (std::memcmp(to, values.data() + at, n) != 0) std::memcpy(to, values.data() + at, n);
  });
}

std::vector<Field> fields(World& w) {
  Table table;
  add_elements(table, w.elements);
  add_sides(table, w.sides);
  add_patches(table, w);
  add_overlaps(table, w);
  add_ties(table, w.ties);
  add_multirate(table, w);
  add_search(table, w);
  return table;
}

std::vector<Field> fields(Simulation& sim, RunState& plan) {
  Table table = fields(sim.world());
  add_listed_pairs(table, sim.world());
  add_overlap_dashpots(table, sim.world());
  FieldTable::add(table, sim);
  table.insert(table.end(),
               {value("plan_steps", plan.steps, 0, std::numeric_limits<std::int64_t>::max() / 2), value("plan_shaking", plan.shaking, 0, 1),
                value("plan_settled", plan.settled, 0, 1), value("plan_first_crack", "s", plan.first_crack),
                value("plan_collapse", "s", plan.collapse), value("plan_peak_base_shear", "N", plan.peak_base_shear),
                value("plan_settling_crack", "s", plan.settling_crack)});
  const auto segment_sides = 2 * static_cast<std::int64_t>(sim.world().sides.bond.size());  // at most
  table.push_back({"plan_settling", "-", "run", FieldType::i64, &plan.settling, 1, 5, 0, segment_sides});
  return table;
}

std::uint64_t state_hash(World& w) {
  Hash hash;
  for (const Field& f : fields(w)) {
    hash.add(f.name, std::strlen(f.name));
    each_piece(f, [&](const std::byte* from, std::size_t, std::size_t n) { hash.add(from, n); });
  }
  return hash.value();
}

}  // namespace voussoir::solver
