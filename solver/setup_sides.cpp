// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string>

#include "solver/decomposition.h"
#include "solver/point_sets.h"
#include "solver/setup.h"

namespace voussoir::solver {

namespace {

/// A side before it has a place in a block.
struct NewSide {
  std::int32_t joint = 0;
  std::int32_t master = 0, slave = 0, master_face = 0, slave_face = 0;  // slave may be the base row
  geometry::Frame frame;                                                // normal outward of the master
  std::vector<geometry::Segment> segments;
  double factor = 1.0;
  int faces = 1;  // 2: stands for both
};

/// The same plane seen from the other face: tangents swapped, so that es × et is its outward normal.
geometry::Frame seen_from_behind(const geometry::Frame& f) { return {f.centre, f.axis_t, f.axis_s, -f.normal}; }

std::vector<geometry::Segment> swapped(std::vector<geometry::Segment> segments) {
  for (geometry::Segment& s : segments) std::swap(s.s, s.t);
  return segments;
}

double snapped(double x) { return std::ldexp(std::round(std::ldexp(x, 40)), -40); }  // as the geometry does: equal sets stay equal

/// Moves the frame's centre to the area centroid of the points, where Σ s dA = Σ t dA = 0.
void centre_on_points(NewSide& side) {
  double area = 0.0, s = 0.0, t = 0.0;
  for (const geometry::Segment& p : side.segments) area += p.area, s += p.area * p.s, t += p.area * p.t;
  s /= area, t /= area;
  side.frame.centre += s * side.frame.axis_s + t * side.frame.axis_t;
  for (geometry::Segment& p : side.segments) p.s = snapped(p.s - s), p.t = snapped(p.t - t);
}

std::vector<NewSide> sides_of(const World& w) {
  const geometry::Assembly& a = w.model.assembly;
  const auto face = [&](std::int32_t e, std::int32_t f) { return a.elements[static_cast<std::size_t>(e)].first_face + f; };
  std::vector<NewSide> sides;
  for (std::size_t i = 0; i < a.joints.size(); ++i) {
    const geometry::Joint& j = a.joints[i];
    const bool on_base = j.element_b == geometry::kBase;
    const bool one = on_base || (j.merged && w.options.merge_sides);
    NewSide first{static_cast<std::int32_t>(i),
                  j.element_a,
                  on_base ? w.elements.base : j.element_b,
                  face(j.element_a, j.face_a),
                  on_base ? w.elements.first_face[static_cast<std::size_t>(w.elements.base)] : face(j.element_b, j.face_b),
                  j.frame,
                  j.side_a,
                  one ? 1.0 : 0.5,
                  one && !on_base ? 2 : 1};
    if (!one) {
      NewSide second{first.joint,
                     first.slave,
                     first.master,
                     first.slave_face,
                     first.master_face,
                     seen_from_behind(j.frame),
                     swapped(j.merged ? j.side_a : j.side_b),
                     0.5,
                     1};
      centre_on_points(second);
      sides.push_back(std::move(first));
      sides.push_back(std::move(second));
    } else {
      sides.push_back(std::move(first));
    }
  }
  return sides;
}

/// k̄ of two faces with the joint's mortar between them: Eqs. 2, 3, THEORY.md (4), (5). Against the base the element's own ℓ alone counts.
kernels::Stiffness joint_stiffness(const World& w, const NewSide& s, const cases::JointLaw& law, double h) {
  const Faces& f = w.faces;
  const auto a = static_cast<std::size_t>(s.master_face), b = static_cast<std::size_t>(s.slave_face);
  double cn = f.compliance_n[a] + f.compliance_n[b], cs = f.compliance_s[a] + f.compliance_s[b];
  const bool on_base = s.slave == w.elements.base;
  if (law.thickness > 0.0 && !on_base) {
    const double half = 0.5 * law.thickness;
    const double left = 1.0 - half / f.distance[a], right = 1.0 - half / f.distance[b];
    if (left <= 0.0 || right <= 0.0) {
      throw cases::InputError(
          "joint_laws." + w.model.laws[static_cast<std::size_t>(w.model.joint_law[static_cast<std::size_t>(s.joint)])].name + ".thickness",
          "= " + std::to_string(law.thickness) + " m is thicker than a block that it joins; allowed: less than twice the distance " +
              std::to_string(std::min(f.distance[a], f.distance[b])) + " m from its centroid to the face");
    }
    cn = left * f.compliance_n[a] + right * f.compliance_n[b] + law.thickness * (1.0 - law.poisson * law.poisson) / law.young;
    cs = left * f.compliance_s[a] + right * f.compliance_s[b] + law.thickness * 2.0 * (1.0 + law.poisson) / law.young;
  }
  kernels::Stiffness k{1.0 / cn, 1.0 / cs, 0.0, 0.0};
  const double mass = f.mass[a] + (on_base ? f.mass[a] : f.mass[b]);  // Eq. 10; with the base 2 ρ_A ℓ_A
  const double beta =
      w.elements.beta[static_cast<std::size_t>(s.master)] + w.elements.beta[static_cast<std::size_t>(on_base ? s.master : s.slave)];
  const double c = 2.0 * h / (1.0 + w.dt * beta);  // Eq. 9, semi-implicit: see setup_damping.cpp
  k.cn = c * std::sqrt(mass * k.kn);
  k.cs = c * std::sqrt(mass * k.ks);
  return k;
}

/// \param factor  of the joint, see cases/scatter.h
kernels::Strength strength_of(const cases::JointLaw& law, double factor, bool dry, double contact_friction) {
  const double phi = (dry ? contact_friction : law.friction) * std::numbers::pi / 180.0;
  if (dry) return {0.0, 0.0, std::tan(phi), 1.0, 0.0};
  return {factor * law.tension, factor * law.cohesion, std::tan(phi), factor * law.compression, law.cap};
}

void size_side_arrays(Sides& s, std::size_t blocks) {
  const std::size_t n = blocks * kernels::kLanes;
  s.blocks.assign(blocks, kernels::SideBlock{});
  for (auto* column : {&s.joint, &s.set, &s.master_face, &s.slave_face}) column->assign(n, -1);
  s.size.assign(n, 0.0);
  for (auto* column : {&s.friction, &s.impact, &s.fracture}) column->assign(n, 0.0);
  s.parts.assign(n, {});
  s.faces.assign(n, 1);
  s.quick.assign(n, kernels::Quick::segments);
  s.retired.assign(n, 1);
  s.held.assign(n, 0);
}

/// Second moments and the rectangle round the points.
void set_moments(kernels::SideBlock& b, int l, const NewSide& side) {
  b.s_low[l] = b.t_low[l] = 1e300, b.s_high[l] = b.t_high[l] = -1e300;
  for (const geometry::Segment& p : side.segments) {
    const double da = side.factor * p.area;
    b.area[l] += da;
    b.sss[l] += da * p.s * p.s, b.sst[l] += da * p.s * p.t, b.stt[l] += da * p.t * p.t;
    b.s_low[l] = std::min(b.s_low[l], p.s), b.s_high[l] = std::max(b.s_high[l], p.s);
    b.t_low[l] = std::min(b.t_low[l], p.t), b.t_high[l] = std::max(b.t_high[l], p.t);
  }
}

void set_constants(World& w, const NewSide& side, std::size_t id, const cases::Case& c) {
  kernels::SideBlock& b = w.sides.blocks[id / kernels::kLanes];
  const int l = static_cast<int>(id % kernels::kLanes);
  const auto put = [l](double(&to)[3][kernels::kLanes], Vec3 v) { to[0][l] = v.x, to[1][l] = v.y, to[2][l] = v.z; };
  const auto centroid = [&](std::int32_t e) {
    const auto i = static_cast<std::size_t>(e);
    return Vec3{w.elements.ref_x[i], w.elements.ref_y[i], w.elements.ref_z[i]};
  };
  put(b.ca, side.frame.centre - centroid(side.master));
  put(b.cb, side.frame.centre - centroid(side.slave));
  put(b.es, side.frame.axis_s);
  put(b.et, side.frame.axis_t);
  b.master[l] = side.master, b.slave[l] = side.slave;
  if (side.slave == w.elements.base) b.on_base |= 1U << l;
  // A force at the master point along the master's normal, as Eq. 11 reads, does work that no potential covers once the faces have slid and
  // turned (by force × slide × relative rotation). At the midpoint along the mean normal the pair is conservative; a literal pair is for
  // comparison.
  b.mean[l] = w.options.merge_sides ? 0.5 : 0.0;
  set_moments(b, l, side);
  const auto law_index = static_cast<std::size_t>(w.model.joint_law[static_cast<std::size_t>(side.joint)]);
  const cases::JointLaw& law = w.model.laws[law_index].value;
  const kernels::Stiffness k = joint_stiffness(w, side, law, c.contact.damping);
  const kernels::Strength s =
      strength_of(law, w.model.joint_strength[static_cast<std::size_t>(side.joint)], law_index == 0, c.contact.friction);
  b.kn[l] = k.kn, b.ks[l] = k.ks;
  b.tension[l] = s.tension, b.cohesion[l] = s.cohesion, b.tan_phi[l] = s.tan_phi, b.compression[l] = s.compression, b.cap[l] = s.cap;
  w.sides.parts[id] = {.id = static_cast<std::int32_t>(id), .factor = side.factor, .cn = k.cn, .cs = k.cs, .points = {}, .segments = {}};
}

/// Bookkeeping and the initial state of one side.
void set_state(World& w, const NewSide& side, std::size_t id, std::int32_t set) {
  Sides& s = w.sides;
  const bool dry = w.model.joint_law[static_cast<std::size_t>(side.joint)] == 0;
  s.joint[id] = side.joint;
  s.set[id] = set;
  s.master_face[id] = side.master_face, s.slave_face[id] = side.slave_face;
  s.faces[id] = static_cast<std::uint8_t>(side.faces);
  s.size[id] = w.model.blocks[static_cast<std::size_t>(side.master)].segment_size;
  s.retired[id] = 0;
  s.quick[id] = dry ? kernels::Quick::segments : kernels::Quick::whole;
  const auto n = static_cast<std::int32_t>(side.segments.size());
  s.held[id] = dry ? 0 : n;
  s.bond.resize(s.bond.size() + static_cast<std::size_t>(n), dry ? kernels::Bond::contact : kernels::Bond::bonded);
  s.bond.resize(static_cast<std::size_t>(round_up(static_cast<std::int64_t>(s.bond.size()), kernels::kLanes)), kernels::Bond::bonded);
  if (dry) return;
  for (const std::int32_t e : {side.master, side.slave}) {
    const std::int32_t sides_here = side.faces == 2 || e == side.master ? n : 0;  // a merged spring is one side of each body
    w.elements.bonds[static_cast<std::size_t>(e)] += sides_here;
    w.elements.bonds_at_start[static_cast<std::size_t>(e)] += sides_here;
  }
}

/// A lane without a side: two resting base rows, no area.
void clear_lane(World& w, std::size_t id) {
  kernels::SideBlock& b = w.sides.blocks[id / kernels::kLanes];
  const int l = static_cast<int>(id % kernels::kLanes);
  b.master[l] = b.slave[l] = w.elements.base;
  b.es[0][l] = b.et[1][l] = 1.0;
  b.kn[l] = b.ks[l] = 1.0;
}

/// Colours, tasks and blocks; returns the sides in the order of their numbers, −1: unused lane.
std::vector<std::int32_t> number_sides(World& w, const std::vector<NewSide>& sides) {
  std::vector<Writes> writes;
  for (const NewSide& s : sides) writes.push_back({s.master, s.slave == w.elements.base ? -1 : s.slave});
  std::vector<Vec3> centroids;
  for (const geometry::Element& e : w.model.assembly.elements) centroids.push_back(e.mass.centroid);
  Decomposition d = decompose(writes, centroids, w.options.cell > 0.0 ? w.options.cell : choose_cell(writes, centroids));
  Sides& s = w.sides;
  if (!d.overflow.empty()) {
    s.overflow_colour = static_cast<std::int32_t>(d.colours.size());
    d.colours.push_back({d.overflow});
  }
  std::vector<std::int32_t> numbered;
  for (const auto& tasks : d.colours) {
    s.colour_first.push_back(static_cast<std::int32_t>(s.task_first.size()));
    for (const auto& task : tasks) {
      s.task_first.push_back(static_cast<std::int32_t>(numbered.size() / kernels::kLanes));
      numbered.insert(numbered.end(), task.begin(), task.end());
      numbered.resize(static_cast<std::size_t>(round_up(static_cast<std::int64_t>(numbered.size()), kernels::kLanes)), -1);
    }
  }
  s.colour_first.push_back(static_cast<std::int32_t>(s.task_first.size()));
  s.task_first.push_back(static_cast<std::int32_t>(numbered.size() / kernels::kLanes));
  return numbered;
}

}  // namespace

void set_up_sides(World& w, const cases::Case& c) {
  const std::vector<NewSide> sides = sides_of(w);
  const std::vector<std::int32_t> numbered = number_sides(w, sides);
  size_side_arrays(w.sides, numbered.size() / kernels::kLanes);
  PointSetBuilder sets(w.points);
  for (std::size_t id = 0; id < numbered.size(); ++id) {
    clear_lane(w, id);
    if (numbered[id] < 0) continue;
    const NewSide& side = sides[static_cast<std::size_t>(numbered[id])];
    set_constants(w, side, id, c);
    set_state(w, side, id, sets.add(side.segments));
  }
  const std::size_t n = w.sides.bond.size();
  w.sides.first_mode.assign(n, kernels::Mode::none);
  for (auto* column : {&w.sides.first_time, &w.sides.slip1, &w.sides.slip2, &w.sides.closure}) column->assign(n, 0.0);
}

void set_up_side_gather(World& w) {
  Sides& s = w.sides;
  if (!w.options.gather) return;
  const std::size_t n = s.parts.size();
  s.pair_wrench.assign(n * kernels::kPairStride, 0.0);
  s.pair_dashpot.assign(n * kernels::kPairStride, 0.0);
  s.pair_on.assign(n, 0);
  std::vector<std::vector<std::int64_t>> of_element(static_cast<std::size_t>(w.elements.count));
  for (std::size_t id = 0; id < n; ++id) {
    if (s.joint[id] < 0) continue;
    const kernels::SideBlock& b = s.blocks[id / kernels::kLanes];
    const std::int32_t master = b.master[id % kernels::kLanes], slave = b.slave[id % kernels::kLanes];
    of_element[static_cast<std::size_t>(master)].push_back(static_cast<std::int64_t>(2 * id));
    if (slave != w.elements.base) of_element[static_cast<std::size_t>(slave)].push_back(static_cast<std::int64_t>(2 * id + 1));
  }
  for (const std::vector<std::int64_t>& codes : of_element) {
    s.first_gather.push_back(static_cast<std::int64_t>(s.gather.size()));
    s.gather.insert(s.gather.end(), codes.begin(), codes.end());
  }
  s.first_gather.push_back(static_cast<std::int64_t>(s.gather.size()));
}

void set_up_side_views(World& w) {
  Sides& s = w.sides;
  std::size_t at = 0;
  for (std::size_t id = 0; id < s.parts.size(); ++id) {
    if (s.joint[id] < 0) continue;
    s.parts[id].points = w.points.view(s.set[id]);
    s.parts[id].segments = {s.bond.data() + at,  s.first_mode.data() + at, s.first_time.data() + at,
                            s.slip1.data() + at, s.slip2.data() + at,      s.closure.data() + at};
    at += static_cast<std::size_t>(round_up(s.parts[id].points.n, kernels::kLanes));
  }
}

}  // namespace voussoir::solver
