// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/contact/overlap_contact.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <utility>

#include "geometry/nth.h"
#include "kernels/laws/contact_law.h"
#include "kernels/laws/restitution.h"

namespace voussoir::solver {

namespace {

constexpr double kSudden = 2.0;    // times as far as it has come in the step: a body was there before
constexpr double kNothing = 1e-6;  // m
constexpr double kOneAxis = 0.99;  // cosine: two axes of an overlap count as one
// Of 4, the most that the scheme bears of Δt² k + 2 Δt c over the mass: what all overlaps of an element may take together. Its joints and
// the points of its faces need the rest.
constexpr double kOfStep = 1.0;

bool is_base(const World& w, std::int32_t e) { return e == w.elements.base; }

const kernels::ConvexShape& shape_of(const World& w, std::int32_t e) { return nth(w.overlaps.shape, nth(w.overlaps.shape_of, e)); }

/// 1/kg: by how much a force of 1 N along n at the arm accelerates the body's point there.
double inverse_mass(const World& w, std::int32_t e, Vec3 arm, Vec3 n) {
  if (w.is_ground(e)) return 0.0;
  const auto i = static_cast<std::size_t>(e);
  const Elements& el = w.elements;
  const Mat3 r = Mat3{} + kernels::load_pose(el.pose.data(), e).d;
  const Vec3 turn = transposed(r) * cross(arm, n);
  return el.inert_inv_mass()[i] + dot(turn, el.inv_inertia(i) * turn);
}

/// As they stand in these poses.
kernels::Overlap overlap_of(const World& w, std::int32_t a, std::int32_t b, const kernels::Pose& pa, const kernels::Pose& pb,
                            double enough) {
  const Elements& e = w.elements;
  const Vec3 apart = (nth(e.body, b).ref - nth(e.body, a).ref) + (pb.u - pa.u);
  if (is_base(w, b)) return kernels::overlap_with_base(shape_of(w, a), pa, -apart.z);
  return kernels::overlap_of(shape_of(w, a), pa, shape_of(w, b), pb, apart, enough);
}

/// Springs of a body and of the other, or of the ground (0), which is rigid.
double in_line(double a, double b) { return b > 0.0 ? a * b / (a + b) : a; }

int level_of(const World& w, std::int32_t a, std::int32_t b) { return w.multirate.contact_level(a, b); }

/// Springs of the two bodies in line, and dashpots with the ratio of all contacts (Eq. 9, semi-implicit as THEORY.md (20)).
kernels::Stiffness stiffness(const World& w, std::int32_t a, std::int32_t b, const kernels::Overlap& at) {
  const Overlaps& o = w.overlaps;
  const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
  const bool ground = w.is_ground(b), base = is_base(w, b);
  kernels::Stiffness k{in_line(o.stiffness_n[i], base ? 0.0 : o.stiffness_n[j]), in_line(o.stiffness_s[i], base ? 0.0 : o.stiffness_s[j])};
  const double inverse = inverse_mass(w, a, at.arm_a, at.normal) + inverse_mass(w, b, at.arm_b, at.normal);
  if (inverse == 0.0) return k;
  const double beta = nth(w.dashpot_bounds.all, i) + nth(w.dashpot_bounds.all, ground ? i : j);
  const auto dashpot = [&](double stiff) {
    const double c = 2.0 * w.contact.damping * std::sqrt(stiff / inverse);
    return c / (1.0 + w.step_of(level_of(w, a, b)) * (beta + c * inverse));
  };
  k.cn = dashpot(k.kn), k.cs = dashpot(k.ks);
  return k;
}

/// Δt² k + 2 Δt c of a spring, over the mass that it moves: what it takes of 4, the most that the scheme bears (THEORY.md (21c)).
double load_on_step(const World& w, std::int32_t a, std::int32_t b, const kernels::Overlap& at) {
  const double inverse = inverse_mass(w, a, at.arm_a, at.normal) + inverse_mass(w, b, at.arm_b, at.normal);
  const double step = w.step_of(level_of(w, a, b));
  const kernels::Stiffness k = stiffness(w, a, b, at);
  return step * (step * k.kn + 2.0 * k.cn) * inverse;
}

/// Sums over the overlaps of each element in this step.
class LoadsOnStep {
 public:
  /// \pre found ones are in the order of their pairs
  LoadsOnStep(const World& w, std::span<const OverlapFound> found) : w_(w) {
    for (const OverlapFound& f : found) {
      const OverlapPair& p = w.overlaps.pairs[f.pair];
      const double load = load_on_step(w, p.a, p.b, f.at);
      for (const std::int32_t e : {p.a, p.b}) {
        if (!w.is_ground(e)) sums_[e] += load;
      }
    }
  }

  /// Of the stiffness and the dashpots of a pair, what the step bears; 1: all.
  [[nodiscard]] double share_of(const OverlapPair& p) const {
    double most = 0.0;
    for (const std::int32_t e : {p.a, p.b}) {
      if (!w_.is_ground(e)) most = std::max(most, sums_.at(e));
    }
    return most <= kOfStep ? 1.0 : kOfStep / most;
  }

 private:
  const World& w_;
  std::map<std::int32_t, double> sums_;
};

/// tan φ of the two materials.
double friction(const World& w, std::int32_t a, std::int32_t b) {
  const auto material = [&](std::int32_t e) { return nth(w.faces, nth(w.elements.first_face, e)).material; };
  return w.contact.friction.of(material(a), material(b));
}

struct Motion {
  kernels::Twist a, b;
};
Motion motion_of(const World& w, std::int32_t a, std::int32_t b) {
  const double* rows = w.twist_rows(level_of(w, a, b));
  return {kernels::load_twist(rows, a), kernels::load_twist(rows, b)};
}

/// J, of the elastic forces of a spring on both bodies in the step behind, as they move now.
double work(const OverlapSpring& s, const Motion& m, double step) {
  return step * (dot(s.force, m.a.v - m.b.v) + dot(s.torque_a, m.a.w) + dot(s.torque_b, m.b.w));
}

/// J, that its dashpot takes in half a step, with the bodies moving like this.
double dashpot_loss(const OverlapSpring& s, const Motion& m, double step) {
  return -0.5 * step * (dot(s.dashpot, m.a.v - m.b.v) + dot(s.dashpot_torque_a, m.a.w) + dot(s.dashpot_torque_b, m.b.w));
}

void add_forces(World& w, const OverlapSpring& s) {
  const kernels::Rows rows = w.rows(level_of(w, s.a, s.b));
  double *wrench = rows.wrench, *dash = rows.dashpot;
  kernels::add_wrench(wrench, s.a, s.force + s.dashpot, s.torque_a + s.dashpot_torque_a);
  kernels::add_dashpot(wrench, dash, s.a, s.dashpot, s.dashpot_torque_a);
  kernels::note_push(wrench, s.a, s.force + s.dashpot);
  if (is_base(w, s.b)) return;
  kernels::add_wrench(wrench, s.b, -(s.force + s.dashpot), s.torque_b + s.dashpot_torque_b);
  kernels::add_dashpot(wrench, dash, s.b, -s.dashpot, s.dashpot_torque_b);
  kernels::note_push(wrench, s.b, s.force + s.dashpot);
}

/// The bodies have parted: what the spring still held, less its last work, is lost.
void end_spring(World& w, const OverlapSpring& s) {
  const Motion m = motion_of(w, s.a, s.b);
  const double step = w.step_of(level_of(w, s.a, s.b));
  w.overlaps.impact += s.stored - 0.5 * work(s, m, step);
  w.overlaps.dashpots += dashpot_loss(s, m, step);
}

/// Of an overlap beyond what is allowed that is seen for the first time, what the bodies have not gone in this step: their joint bore it.
/// The spring begins without it, or it would give back what it never took. \param apart  m, by which they have parted in the step
double there_before(double over, double apart) { return over > kSudden * std::abs(apart) + kNothing ? over + std::min(0.0, apart) : 0.0; }

/// m, how far the points of a joint between the two have been crushed; below 0: they have none that still faces.
double crushed_in_joint(const World& w, std::int32_t a, std::int32_t b) {
  const Overlaps& o = w.overlaps;
  double most = -1.0;
  for (std::int64_t k = nth(o.first_side, a); k < o.first_side[static_cast<std::size_t>(a) + 1]; ++k) {
    const auto i = static_cast<std::size_t>(nth(o.side, k));
    if (nth(o.joined_to, k) != b || w.sides.retired[i] != 0) continue;
    most = std::max(most, 0.0);
    const kernels::SegmentsView q = w.sides.segments(static_cast<std::int64_t>(i));
    for (int p = 0; p < w.points.view(w.sides.set[i]).n; ++p) most = std::max(most, -q.closure(p));
  }
  return most;
}

/// Whether the points of a joint between the two bear what overlaps: they give way elastically, the more the longer the elements are, and
/// miss nothing while the two faces lie before each other.
bool joint_bears(const World& w, const OverlapPair& p) {
  const double crushed = crushed_in_joint(w, p.a, p.b);
  return crushed >= 0.0 && crushed <= allowed_overlap(w, p.a, p.b);
}

/// As a body stands after the step ahead, if its velocity stays as it is.
kernels::Pose moved_on(const kernels::Pose& p, const kernels::Twist& t, double step) {
  const Vec3 w = step * t.w;
  const Mat3 turn{{0.0, -w.z, w.y}, {w.z, 0.0, -w.x}, {-w.y, w.x, 0.0}};
  return {p.u + step * t.v, p.d + turn * (Mat3{} + p.d)};
}

/// Whether two bodies meet elsewhere, or along another axis, than their motion can account for.
bool jumps(const kernels::Overlap& from, const kernels::Overlap& to, const Motion& m, double step) {
  const double turn = step * (norm(m.a.w) + norm(m.b.w));
  const double travel = step * (norm(m.a.v) + norm(m.b.v)) + norm(from.arm_a) * step * norm(m.a.w) + norm(from.arm_b) * step * norm(m.b.w);
  return norm(to.normal - from.normal) > kSudden * turn + kNothing || norm(to.arm_a - from.arm_a) > kSudden * travel + kNothing;
}

/// Speed at which two bodies part at an overlap, m/s; below 0: they approach.
double parting(const kernels::Overlap& at, const Motion& m) {
  return dot((m.b.v + cross(m.b.w, at.arm_b)) - (m.a.v + cross(m.a.w, at.arm_a)), at.normal);
}

/// The motion after a step in which a force [N] at the overlap pushes the two apart.
Motion pushed_apart(const World& w, const OverlapPair& p, const kernels::Overlap& at, Motion m, double force) {
  const double impulse = w.step_of(level_of(w, p.a, p.b)) * force;
  const auto push = [&](std::int32_t e, Vec3 arm, Vec3 along, kernels::Twist& t) {
    if (w.is_ground(e)) return;
    const Mat3 r = Mat3{} + kernels::load_pose(w.elements.pose.data(), e).d;
    const auto i = static_cast<std::size_t>(e);
    t.v += w.elements.inert_inv_mass()[i] * along;
    t.w += r * (w.elements.inv_inertia(i) * (transposed(r) * cross(arm, along)));
  };
  push(p.a, at.arm_a, -impulse * at.normal, m.a);
  push(p.b, at.arm_b, impulse * at.normal, m.b);
  return m;
}

/// Between two places of an overlap, by the share of the second.
kernels::Overlap between(const kernels::Overlap& first, const kernels::Overlap& second, double share) {
  const auto mix = [share](Vec3 a, Vec3 b) { return a + share * (b - a); };
  return {first.depth, normalised(mix(first.normal, second.normal)), mix(first.arm_a, second.arm_a), mix(first.arm_b, second.arm_b)};
}

/// Where corners of a body or axes take turns in the step ahead, the force acts between the place where the two bodies meet now and the one
/// where they would meet then, so that both are as deep then; where the axis turns by much, at the one of both where it takes more energy
/// out of the motion (THEORY.md (21b)). The depth is the present one. \param force  N, of the overlap in this step
kernels::Overlap where_it_acts(const World& w, const OverlapPair& p, const kernels::Overlap& now, double force) {
  const double step = w.step_of(level_of(w, p.a, p.b)), allowed = allowed_overlap(w, p.a, p.b);
  const Motion m = motion_of(w, p.a, p.b), after = pushed_apart(w, p, now, m, force);
  const double* rows = w.elements.pose.data();
  const kernels::Overlap then = overlap_of(w, p.a, p.b, moved_on(kernels::load_pose(rows, p.a), after.a, step),
                                           moved_on(kernels::load_pose(rows, p.b), after.b, step), allowed);
  if (then.depth <= allowed || !jumps(now, then, after, step)) return now;
  const kernels::Overlap ahead{now.depth, then.normal, then.arm_a, now.arm_b + (then.arm_a - now.arm_a)};
  if (dot(now.normal, then.normal) < kOneAxis) return parting(ahead, m) < parting(now, m) ? ahead : now;
  // By how much the second place is deeper than the first at the end of the step, with the force at the first, and at the second.
  const Motion other = pushed_apart(w, p, ahead, m, force);
  const double at_first = then.depth - (now.depth - step * parting(now, after));
  const double at_second = at_first - step * (parting(ahead, other) - parting(ahead, after) - parting(now, other) + parting(now, after));
  if (at_first <= 0.0) return now;
  return at_second >= 0.0 ? ahead : between(now, ahead, at_first / (at_first - at_second));
}

/// One step of a spring. \param last  as it was a step before; a new one has no force yet
OverlapSpring advance_spring(World& w, const OverlapSpring& last, bool goes_on, const kernels::Overlap& found, double share) {
  OverlapSpring s;
  s.a = last.a, s.b = last.b;
  s.share = std::min(last.share, share);
  const double step = w.step_of(level_of(w, s.a, s.b));
  const Motion m = motion_of(w, s.a, s.b);
  const double over = found.depth - allowed_overlap(w, s.a, s.b), restitution = w.contact.restitution;
  const double from = goes_on ? std::min(last.from, over) : there_before(over, step * parting(found, m));
  s.from = restitution > 0.0 ? kernels::pressed_at(over, from, restitution) : from;
  const double xn = s.from - over;
  const kernels::Overlap at = where_it_acts(w, {s.a, s.b}, found, -s.share * stiffness(w, s.a, s.b, found).kn * xn);
  kernels::Stiffness k = stiffness(w, s.a, s.b, at);
  if (s.share < 1.0) k = {s.share * k.kn, s.share * k.ks, s.share * k.cn, s.share * k.cs};
  const Vec3 rate = (m.b.v + cross(m.b.w, at.arm_b)) - (m.a.v + cross(m.a.w, at.arm_a));
  const Mat3 turn = Mat3{} + kernels::load_pose(w.elements.pose.data(), s.a).d;
  // An impact that gives back a given share has a normal dashpot only where the bodies close and have been deeper.
  if (restitution > 0.0 && !(dot(rate, at.normal) < 0.0 && kernels::was_deeper(over, from, restitution))) k.cn = 0.0;
  const kernels::ContactStep c =
      kernels::advance_contact(xn, at.normal, rate, turn * last.shear, k, friction(w, s.a, s.b), step, w.contact.dashpot_excess);
  s.shear = transposed(turn) * c.spring;
  s.stored = 0.5 * k.kn * xn * xn + 0.5 * k.ks * dot(c.spring, c.spring);
  s.force = c.elastic, s.torque_a = cross(at.arm_a, c.elastic), s.torque_b = -cross(at.arm_b, c.elastic);
  s.dashpot = c.dashpot, s.dashpot_torque_a = cross(at.arm_a, c.dashpot), s.dashpot_torque_b = -cross(at.arm_b, c.dashpot);
  // What the springs held, less what they hold, less their work on the bodies (28): the slip's share of it, and the rest.
  const Vec3 slide = rate - dot(rate, at.normal) * at.normal;
  const double lost = last.stored - s.stored - 0.5 * (work(last, m, step) + work(s, m, step));
  const double friction = 0.5 * k.ks * (dot(c.before, c.before) - dot(c.spring, c.spring) + step * dot(c.before + c.spring, slide));
  w.overlaps.friction += friction;
  w.overlaps.impact += lost - friction;
  w.overlaps.dashpots += dashpot_loss(last, m, step) + dashpot_loss(s, m, step);
  add_forces(w, s);
  if (w.keep_pairs)
    w.overlaps.wrench.push_back({s.force + s.dashpot, s.torque_a + s.dashpot_torque_a, s.torque_b + s.dashpot_torque_b, s.dashpot,
                                 s.dashpot_torque_a, s.dashpot_torque_b});
  return s;
}

}  // namespace

double allowed_overlap(const World& w, std::int32_t a, std::int32_t b) {
  const std::vector<double>& allowed = w.overlaps.allowed;
  const double first = nth(allowed, a);
  return is_base(w, b) ? first : std::max(first, nth(allowed, b));
}

kernels::Overlap overlap_of(const World& w, std::int32_t a, std::int32_t b, double enough) {
  const double* rows = w.elements.pose.data();
  return overlap_of(w, a, b, kernels::load_pose(rows, a), kernels::load_pose(rows, b), enough);
}

void list_overlap_levels(World& w) {
  if (!w.multirate.on()) return;
  std::vector<std::uint8_t> level;
  for (const OverlapPair& p : w.overlaps.pairs) level.push_back(static_cast<std::uint8_t>(level_of(w, p.a, p.b)));
  w.overlaps.by_level.sort(level, w.multirate.levels());
}

DueNumbers overlaps_due(const World& w, int due) { return {w.multirate, w.overlaps.by_level, due, w.overlaps.pairs.size()}; }

void find_overlaps(World& w, int due, Tickets& tickets, std::vector<OverlapFound>& found) {
  const DueNumbers pairs = overlaps_due(w, due);
  const auto find = [&](std::int64_t k) {
    const std::size_t i = pairs[k];
    OverlapPair& p = w.overlaps.pairs[i];
    const double travel = w.travel.bound(p.a) + w.travel.bound(p.b);
    if (travel < p.safe && !w.options.reference_kernels) return;
    const double allowed = allowed_overlap(w, p.a, p.b);
    const kernels::Overlap at = overlap_of(w, p.a, p.b, allowed);
    if (at.depth > allowed) {
      p.safe = kernels::kLookNow;
      found.push_back({i, at});
    } else {
      p.safe = travel + (allowed - at.depth) - kernels::kRoundOff;
    }
  };
  tickets.take([&](std::int64_t first, std::int64_t last) {
    for (std::int64_t k = first; k < last; ++k) find(k);
  });
}

void apply_overlaps(World& w, int due, std::vector<OverlapFound>& found) {
  std::vector<OverlapSpring>& springs = w.overlaps.springs;
  w.overlaps.wrench.clear();
  if (found.empty() && springs.empty()) return;
  // Here, where joints have been advanced: another thread may still do so while pairs are found.
  std::erase_if(found, [&](const OverlapFound& f) { return joint_bears(w, w.overlaps.pairs[f.pair]); });
  std::ranges::sort(found, {}, &OverlapFound::pair);
  const LoadsOnStep loads(w, found);
  std::vector<OverlapSpring> now;
  now.reserve(found.size());
  auto last = springs.begin();
  const auto order = [](const auto& s) { return std::pair(s.a, s.b); };
  const auto leave = [&](const OverlapSpring& s) {
    if (level_of(w, s.a, s.b) >= due) {
      now.push_back(s);
    } else {
      end_spring(w, s);
    }
  };
  for (const OverlapFound& f : found) {
    const OverlapPair& p = w.overlaps.pairs[f.pair];
    for (; last != springs.end() && order(*last) < order(p); ++last) leave(*last);
    const bool goes_on = last != springs.end() && order(*last) == order(p);
    OverlapSpring before;
    before.a = p.a, before.b = p.b;
    if (goes_on) before = *last++;
    now.push_back(advance_spring(w, before, goes_on, f.at, loads.share_of(p)));
  }
  for (; last != springs.end(); ++last) leave(*last);
  springs = std::move(now);
  found.clear();
}

}  // namespace voussoir::solver
