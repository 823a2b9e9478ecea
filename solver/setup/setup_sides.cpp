// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <span>
#include <string>

#include "cases/case.h"
#include "cases/model.h"
#include "geometry/nth.h"
#include "geometry/segments/torsion.h"
#include "solver/schedule/colouring.h"
#include "solver/setup/point_sets.h"
#include "solver/setup/setup.h"
#include "solver/setup/side_kinds.h"
#include "solver/setup/side_stiffness.h"
#include "solver/world/first_touch.h"

namespace voussoir::solver {

namespace {

/// A side before it has a place in a block. A model has millions of them, so that each is small.
struct NewSide {
  std::int32_t joint = 0;
  std::int32_t master = 0, slave = 0, master_face = 0, slave_face = 0;  // slave may be the base row
  std::uint8_t faces = 1;                                               // 2: stands for both
  geometry::SegmentList segments;
  double factor = 1.0;
  // Found from the above and the frame.
  double cn = 0.0, cs = 0.0;  // Pa s/m
  std::int32_t kind = -1, order = -1;
};

/// The same plane seen from the other face: tangents swapped, so that es × et is its outward normal.
geometry::Frame seen_from_behind(const geometry::Frame& f) { return {f.centre, f.axis_t, f.axis_s, -f.normal}; }

double snapped(double x) { return std::ldexp(std::round(std::ldexp(x, 40)), -40); }  // as the geometry does: equal sets stay equal

/// Points and frame of the same side seen from behind, the frame's centre at the area centroid of the points, where
/// Σ s dA = Σ t dA = 0. \param frame  in: of the other face
std::vector<geometry::Segment> turned_round(geometry::SegmentList segments, geometry::Frame& frame) {
  frame = seen_from_behind(frame);
  std::vector<geometry::Segment> points(segments.begin(), segments.end());
  double area = 0.0, s = 0.0, t = 0.0;
  for (geometry::Segment& p : points) {
    std::swap(p.s, p.t);
    area += p.area, s += p.area * p.s, t += p.area * p.t;
  }
  s /= area, t /= area;
  frame.centre += s * frame.axis_s + t * frame.axis_t;
  for (geometry::Segment& p : points) p.s = snapped(p.s - s), p.t = snapped(p.t - t);
  return points;
}

/// Number of sides of a joint: one that stands for both faces or lies on ground, which has no points, or one of each face.
int sides_of(const World& w, const geometry::Joint& j) {
  const bool on_ground = j.element_b == geometry::kBase || w.is_ground(j.element_b);
  return on_ground || (j.merged && w.options.merge_sides) ? 1 : 2;
}

std::size_t count_sides(const World& w) {
  std::size_t sides = 0;
  for (const geometry::Joint& j : w.model.assembly.joints) sides += static_cast<std::size_t>(sides_of(w, j));
  return sides;
}

/// Calls `take(side, frame)` for every side, in the order of joints; the frame's normal is outward of the side's master.
/// \param store  keeps points that the assembly does not have
template <class Take>
void for_each_side(const World& w, geometry::SegmentStore& store, const Take& take) {
  const geometry::Assembly& a = w.model.assembly;
  const auto face = [&](std::int32_t e, std::int32_t f) { return nth(a.elements, e).first_face + f; };
  for (std::size_t i = 0; i < a.joints.size(); ++i) {
    const geometry::Joint& j = a.joints[i];
    const bool on_base = j.element_b == geometry::kBase;
    const bool one = sides_of(w, j) == 1, both = one && !on_base && !w.is_ground(j.element_b);
    NewSide side;
    side.joint = static_cast<std::int32_t>(i);
    side.master = j.element_a, side.slave = on_base ? w.elements.base : j.element_b;
    side.master_face = face(j.element_a, j.face_a);
    side.slave_face = on_base ? nth(w.elements.first_face, w.elements.base) : face(j.element_b, j.face_b);
    side.faces = both ? 2 : 1, side.factor = one ? 1.0 : 0.5;
    side.segments = j.side_a;
    take(side, j.frame());
    if (one) continue;
    std::swap(side.master, side.slave), std::swap(side.master_face, side.slave_face);
    geometry::Frame frame = j.frame();
    side.segments = store.keep(turned_round(j.merged ? j.side_a : j.side_b, frame));
    take(side, frame);
  }
}

/// k̄ of two faces with the joint's mortar or its own stiffness between them: Eqs. 2, 3, THEORY.md (4), (5), (5a). Against the base and its
/// parts the element's own ℓ counts, and the joint's own stiffness.
kernels::Stiffness joint_stiffness(const World& w, const NewSide& s, const cases::JointLaw& law, double h) {
  const kernels::Face& a = nth(w.faces, s.master_face);
  const kernels::Face& b = nth(w.faces, s.slave_face);
  double cn = a.compliance_n + b.compliance_n, cs = a.compliance_s + b.compliance_s;
  if (law.thickness > 0.0 && !b.is_ground()) {
    const double half = 0.5 * law.thickness;
    const double left = 1.0 - half / a.distance, right = 1.0 - half / b.distance;
    if (left <= 0.0 || right <= 0.0) {
      throw cases::InputError("joint_laws." + nth(w.model.laws, nth(w.model.joint_law, s.joint)).name + ".thickness",
                              "= " + std::to_string(law.thickness) +
                                  " m is thicker than a block that it joins; allowed: less than twice the distance " +
                                  std::to_string(std::min(a.distance, b.distance)) + " m from its centroid to the face");
    }
    cn = left * a.compliance_n + right * b.compliance_n + law.thickness * (1.0 - law.poisson * law.poisson) / law.young;
    cs = left * a.compliance_s + right * b.compliance_s + law.thickness * 2.0 * (1.0 + law.poisson) / law.young;
  }
  if (law.normal_stiffness) cn += 1.0 / *law.normal_stiffness, cs += 1.0 / *law.shear_stiffness;
  kernels::Stiffness k{1.0 / cn, 1.0 / cs, 0.0, 0.0};
  const double mass = a.mass + (b.is_ground() ? a.mass : b.mass);  // Eq. 10; with the ground 2 ρ_A ℓ_A
  const auto beta_of = [&](std::int32_t e) { return nth(w.elements.body, e).beta; };
  const double beta = beta_of(s.master) + beta_of(b.is_ground() ? s.master : s.slave);
  const double step = w.step_of(w.multirate.joint_level_in_cycles(s.master, s.slave));
  const double c = 2.0 * h / (1.0 + step * beta);  // Eq. 9, semi-implicit: see setup_damping.cpp
  k.cn = c * std::sqrt(mass * k.kn);
  k.cs = c * std::sqrt(mass * k.ks);
  return k;
}

/// Whether the joint has no bond from the start.
bool is_dry(const World& w, std::int32_t joint) {
  const std::int32_t law = nth(w.model.joint_law, joint);
  return law == 0 || nth(w.model.laws, law).value.stiffens();
}

/// \param factor  of the joint, see cases/rules/scatter.h
/// \param friction  tan φ of what the bond becomes: of its two materials, unless the law has its own
kernels::Strength strength_of(const cases::JointLaw& law, double factor, bool dry, double friction) {
  if (dry) return {0.0, 0.0, 0.0, 1.0, 0.0, friction};
  const double tan_phi = std::tan(law.friction * std::numbers::pi / 180.0);
  return {factor * law.tension, factor * law.cohesion, tan_phi, factor * law.compression, law.cap, friction};
}

/// For each colour the number of points, padded to whole lanes, of all sides before it; the last entry is that of all sides.
std::vector<std::int64_t> points_by_colour(const Sides& s, const std::vector<NewSide>& sides, const std::vector<std::int32_t>& numbered) {
  std::vector<std::int64_t> before;
  std::int64_t points = 0;
  std::size_t id = 0;
  for (const std::int32_t task : s.colour_first) {
    for (const std::size_t end = static_cast<std::size_t>(nth(s.task_first, task)) * kernels::kLanes; id < end; ++id) {
      if (numbered[id] < 0) continue;
      points += round_up(static_cast<std::int64_t>(nth(sides, numbered[id]).segments.size()), kernels::kLanes);
    }
    before.push_back(points);
  }
  return before;
}

/// \param points  see points_by_colour
void size_side_arrays(Sides& s, std::size_t blocks, std::span<const std::int64_t> points, Team& team) {
  const std::size_t n = blocks * kernels::kLanes;
  std::vector<std::int64_t> block_borders, side_borders;  // of colours: threads work on one after the other, each on a part of it
  for (const std::int32_t task : s.colour_first) block_borders.push_back(nth(s.task_first, task));
  for (const std::int64_t b : block_borders) side_borders.push_back(b * kernels::kLanes);
  assign_in_shares(s.blocks, blocks, kernels::SideBlock{}, team, block_borders);
  assign_in_shares(s.parts, n, {}, team, side_borders);
  s.bond.assign_zeros(static_cast<std::size_t>(points.back()));
  s.steady.assign_zeros(blocks);
  for (auto* column : {&s.joint, &s.set, &s.master_face, &s.slave_face}) column->assign(n, -1);
  s.size.assign(n, 0.0);
  for (auto* column : {&s.friction, &s.impact, &s.fracture}) column->assign_zeros(n);
  s.faces.assign(n, 1);
  s.side_state.assign(n, kernels::SideState::segments);
  s.retired.assign(n, 1);
  s.held.assign(n, 0);
}

/// Second moments and the rectangle round the points.
void set_moments(kernels::SideConstants& c, const NewSide& side) {
  *c.s_low = *c.t_low = 1e300, *c.s_high = *c.t_high = -1e300;
  for (const geometry::Segment& p : side.segments) {
    const double da = side.factor * p.area;
    *c.area += da;
    *c.sss += da * p.s * p.s, *c.sst += da * p.s * p.t, *c.stt += da * p.t * p.t;
    *c.s_low = std::min(*c.s_low, p.s), *c.s_high = std::max(*c.s_high, p.s);
    *c.t_low = std::min(*c.t_low, p.t), *c.t_high = std::max(*c.t_high, p.t);
  }
}

/// Constants of a side, in lane 0. \param torsion  m4, constant of its joint; 0: G I_p
kernels::SideConstants constants_of(const World& w, const NewSide& side, const geometry::Frame& frame, const kernels::Stiffness& k,
                                    const kernels::Strength& strength, double torsion) {
  kernels::SideConstants c{};
  const auto put = [](double(&to)[3][kernels::kLanes], Vec3 v) { to[0][0] = v.x, to[1][0] = v.y, to[2][0] = v.z; };
  const auto centroid = [&](std::int32_t e) {
    const auto i = static_cast<std::size_t>(e);
    return w.elements.body[i].ref;
  };
  put(c.ca, frame.centre - centroid(side.master));
  put(c.cb, frame.centre - centroid(side.slave));
  put(c.es, frame.axis_s);
  put(c.et, frame.axis_t);
  // A force at the master point along the master's normal, as Eq. 11 reads, does work that no potential covers once the faces have slid and
  // turned (by force × slide × relative rotation). At the midpoint along the mean normal the pair is conservative; a literal pair is for
  // comparison. So is a force at the master point along the normal of the base, THEORY.md (10a).
  *c.mean = w.options.merge_sides && side.slave != w.elements.base ? 0.5 : 0.0;
  set_moments(c, side);
  if (torsion > 0.0) *c.twist = twist_of(c, side.factor * torsion);
  *c.kn = k.kn, *c.ks = k.ks;
  *c.tension = strength.tension, *c.cohesion = strength.cohesion, *c.tan_phi = strength.tan_phi;
  *c.compression = strength.compression, *c.cap = strength.cap, *c.friction = strength.friction;
  return c;
}

/// A lane without a side: no area.
kernels::SideConstants nothing() {
  kernels::SideConstants c{};
  c.es[0][0] = c.et[1][0] = 1.0;
  *c.kn = *c.ks = 1.0;
  return c;
}

/// Sides of one form go through the kernel of whole sides together: those that look along one axis, those that do not, those on the base.
std::int32_t form_of(const World& w, const NewSide& s, const geometry::Frame& frame) {
  if (s.slave == w.elements.base) return 4;
  const int axis = kernels::axis_of_side(frame.axis_s, frame.axis_t);
  return axis < 0 ? 3 : axis;
}

/// All sides, with their kind and their place in the order of number_sides: form by form, and within a form by what they would be without
/// scatter of their strength, since `decompose` can set those of one kind that share no element beside each other.
std::vector<NewSide> new_sides(const World& w, const cases::Case& c, geometry::SegmentStore& store, SideKinds& kinds) {
  std::vector<NewSide> sides;
  sides.reserve(count_sides(w));
  SideKinds without_scatter;
  std::vector<std::uint8_t> form;
  form.reserve(sides.capacity());
  std::vector<geometry::JointTorsion> torsion(w.model.assembly.joints.size());
  if (c.segment_torsion == geometry::Torsion::solid) torsion = geometry::joint_torsion(w.model.assembly);
  kinds.add(nothing());
  for_each_side(w, store, [&](NewSide& side, const geometry::Frame& frame) {
    const auto joint = static_cast<std::size_t>(side.joint), law_index = static_cast<std::size_t>(w.model.joint_law[joint]);
    const cases::JointLaw& law = w.model.laws[law_index].value;
    const auto material = [&](std::int32_t face) { return nth(w.faces, face).material; };
    double friction = w.contact.friction.of(material(side.master_face), material(side.slave_face));
    if (law.residual_friction) friction = std::tan(*law.residual_friction * std::numbers::pi / 180.0);
    const auto strength = [&](double scatter) { return strength_of(law, scatter, is_dry(w, side.joint), friction); };
    const kernels::Stiffness k = joint_stiffness(w, side, law, c.contact.damping);
    side.cn = k.cn, side.cs = k.cs;
    side.kind = kinds.add(constants_of(w, side, frame, k, strength(w.model.joint_strength[joint]), torsion[joint].solid));
    side.order = without_scatter.add(constants_of(w, side, frame, k, strength(1.0), torsion[joint].solid));
    form.push_back(static_cast<std::uint8_t>(form_of(w, side, frame)));
    sides.push_back(side);
  });
  for (std::size_t i = 0; i < sides.size(); ++i) sides[i].order += form[i] * without_scatter.size();
  return sides;
}

/// Bookkeeping and the initial state of one side. \param points  of all sides before, padded to whole lanes
void set_state(World& w, const NewSide& side, std::size_t id, std::int32_t set, std::size_t points) {
  Sides& s = w.sides;
  const bool dry = is_dry(w, side.joint);
  s.joint[id] = side.joint;
  s.set[id] = set;
  s.master_face[id] = side.master_face, s.slave_face[id] = side.slave_face;
  s.faces[id] = static_cast<std::uint8_t>(side.faces);
  s.size[id] = nth(w.model.blocks, side.master).segment_size;
  s.retired[id] = 0;
  s.side_state[id] = dry ? kernels::SideState::segments : kernels::SideState::whole;
  s.parts[id] = {.id = static_cast<std::int32_t>(id), .factor = side.factor, .cn = side.cn, .cs = side.cs, .points = {}, .segments = {}};
  const auto n = static_cast<std::int32_t>(side.segments.size());
  s.held[id] = dry ? 0 : n;
  static_assert(static_cast<int>(kernels::Bond::bonded) == 0);
  if (dry) return static_cast<void>(std::fill_n(s.bond.data() + points, n, kernels::Bond::contact));
  for (const std::int32_t e : {side.master, side.slave}) {
    const std::int32_t sides_here = side.faces == 2 || e == side.master ? n : 0;  // a merged spring is one side of each body
    nth(w.elements.bonds, e) += sides_here;
    nth(w.elements.bonds_at_start, e) += sides_here;
  }
}

/// Colours, tasks and blocks; returns the sides in the order of their numbers, −1: unused lane.
std::vector<std::int32_t> number_sides(World& w, const std::vector<NewSide>& sides) {
  std::vector<Writes> writes;
  std::vector<std::int32_t> kinds;
  for (const NewSide& s : sides) {
    writes.push_back({s.master, s.slave == w.elements.base ? -1 : s.slave});
    kinds.push_back(s.order);
  }
  std::vector<Vec3> centroids;
  for (const geometry::Element& e : w.model.assembly.elements) centroids.push_back(e.mass.centroid);
  const double cell = w.options.cell > 0.0 ? w.options.cell : choose_cell(writes, centroids, w.out_of_cache);
  Decomposition d = decompose(writes, kinds, centroids, cell, w.out_of_cache);
  Sides& s = w.sides;
  if (!d.overflow.empty()) {
    s.overflow_colour = static_cast<std::int32_t>(d.colours.size());
    d.colours.push_back({d.overflow});
  }
  std::vector<std::int32_t> numbered;
  const auto blocks = [&] { return static_cast<std::int32_t>(numbered.size() / kernels::kLanes); };
  const auto append = [&](auto first, auto last) {
    numbered.insert(numbered.end(), first, last);
    numbered.resize(static_cast<std::size_t>(round_up(static_cast<std::int64_t>(numbered.size()), kernels::kLanes)), -1);
  };
  const auto level_of = [&](std::int32_t i) {
    const NewSide& side = nth(sides, i);
    return w.multirate.joint_level_in_cycles(side.master, side.slave);
  };
  const auto levels = static_cast<int>(w.multirate.every.size());
  for (auto& tasks : d.colours) {
    s.colour_first.push_back(static_cast<std::int32_t>(s.task_first.size()));
    for (auto& task : tasks) {
      s.task_first.push_back(blocks());
      for (int level = 0; level < levels; ++level) {
        s.task_level.push_back(blocks());
        std::vector<std::int32_t> of_level;
        std::ranges::copy_if(task, std::back_inserter(of_level), [&](std::int32_t i) { return level_of(i) == level; });
        append(of_level.begin(), of_level.end());
      }
    }
  }
  s.colour_first.push_back(static_cast<std::int32_t>(s.task_first.size()));
  s.task_first.push_back(blocks());
  s.task_level.push_back(blocks());
  return numbered;
}

/// Who is in which lane, and the constants of the block.
void fill_blocks(World& w, const std::vector<NewSide>& sides, const std::vector<std::int32_t>& numbered, const SideKinds& kinds) {
  BlockKinds blocks(kinds);
  std::vector<std::size_t> constants;
  for (std::size_t block = 0; block < w.sides.blocks.size(); ++block) {
    kernels::SideBlock& b = w.sides.blocks[block];
    BlockKinds::Lanes in_lane{};
    for (int l = 0; l < kernels::kLanes; ++l) {
      const std::size_t id = block * kernels::kLanes + static_cast<std::size_t>(l);
      b.master[l] = b.slave[l] = w.elements.base;
      if (numbered[id] < 0) continue;
      const NewSide& side = nth(sides, numbered[id]);
      b.master[l] = side.master, b.slave[l] = side.slave;
      if (side.slave == w.elements.base) b.on_base |= 1U << l;
      nth(in_lane, l) = side.kind;
    }
    constants.push_back(blocks.add(in_lane));
  }
  Sides& s = w.sides;
  s.constants = blocks.take();
  s.whole.resize(s.constants.size());
  std::vector<bool> found(s.constants.size(), false);
  for (std::size_t block = 0; block < constants.size(); ++block) {
    const std::size_t i = constants[block];
    if (!found[i]) s.whole[i] = kernels::whole_constants(s.constants[i], s.blocks[block].on_base), found[i] = true;
    s.blocks[block].constants = &s.constants[i];
    kernels::set_whole(s.blocks[block], s.whole[i]);
  }
}

}  // namespace

void set_up_sides(World& w, const cases::Case& c) {
  geometry::SegmentStore turned;
  SideKinds kinds;
  const std::vector<NewSide> sides = new_sides(w, c, turned, kinds);
  const std::vector<std::int32_t> numbered = number_sides(w, sides);
  size_side_arrays(w.sides, numbered.size() / kernels::kLanes, points_by_colour(w.sides, sides, numbered), w.team);
  fill_blocks(w, sides, numbered, kinds);
  PointSetBuilder sets(w.points);
  std::size_t points = 0;
  for (std::size_t id = 0; id < numbered.size(); ++id) {
    if (numbered[id] < 0) continue;
    const NewSide& side = nth(sides, numbered[id]);
    set_state(w, side, id, sets.add(side.segments), points);
    points += static_cast<std::size_t>(round_up(static_cast<std::int64_t>(side.segments.size()), kernels::kLanes));
  }
  const std::size_t n = w.sides.bond.size();
  static_assert(static_cast<int>(kernels::Mode::none) == 0);
  w.sides.first_mode.assign_zeros(n);
  w.sides.first_time.assign_zeros(n);
  w.sides.springs.assign_zeros(n / kernels::kWidth);
}

void set_up_pair_forces(World& w, const cases::Case& c) {
  if (c.output.cuts.empty()) return;
  Sides& s = w.sides;
  s.pair_wrench.assign(s.parts.size() * kernels::kPairStride, 0.0);
  s.pair_on.assign(s.parts.size(), 0);
}

void set_up_side_views(World& w) {
  Sides& s = w.sides;
  std::size_t at = 0;
  for (std::size_t id = 0; id < s.parts.size(); ++id) {
    if (s.joint[id] < 0) continue;
    s.parts[id].points = w.points.view(s.set[id]);
    s.parts[id].segments = {s.bond.data() + at, s.first_mode.data() + at, s.first_time.data() + at,
                            s.springs.data() + at / kernels::kWidth};
    at += static_cast<std::size_t>(round_up(s.parts[id].points.n, kernels::kLanes));
  }
}

}  // namespace voussoir::solver
