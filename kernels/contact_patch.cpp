// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <bit>

#include "kernels/lanes.h"
#include "kernels/patch_work.h"

namespace voussoir::kernels {

namespace {

/// Lanes whose entry of `list` is `value`.
VOUSSOIR_INLINE LaneMask equal(const std::int32_t* list, std::int32_t value) noexcept {
  typedef std::int32_t Ints __attribute__((vector_size(4 * kWidth)));
  Ints x;
  __builtin_memcpy(&x, list, sizeof x);
  return __builtin_convertvector(x == value, LaneMask);
}

/// Sums of tractions in global axes, by lane.
struct SumsOfLanes {
  VecLanes f{}, sf{}, tf{};
  VOUSSOIR_INLINE void add(VecLanes v, Lanes s, Lanes t) noexcept {
    f = f + v;
    sf = sf + s * v;
    tf = tf + t * v;
  }
  [[nodiscard]] VOUSSOIR_INLINE GlobalSums sum() const noexcept {
    const Quad a = sums_of(f.x, f.y, f.z, sf.x), b = sums_of(sf.y, sf.z, tf.x, tf.y), c = sums_of(tf.z, Lanes{}, Lanes{}, Lanes{});
    return {{a[0], a[1], a[2]}, {a[3], b[0], b[1]}, {b[2], b[3], c[0]}};
  }
};

struct Touching {
  SumsOfLanes total, dash;
  Lanes stored{}, friction{}, impact{};
};

/// The pair of a patch and one face, ready for several points at a time.
struct FacingLanes {
  VecLanes n, v0, vs, vt;
  MatLanes d, d_transposed;  // R − I of the master, and its transpose
  double step;
};
VOUSSOIR_INLINE FacingLanes facing_lanes(const Facing& f, const Mat3& d, double step) noexcept {
  const Mat3 t = transposed(d);
  return {spread(f.n),
          spread(f.v0),
          spread(f.vs),
          spread(f.vt),
          {spread(d.r0), spread(d.r1), spread(d.r2)},
          {spread(t.r0), spread(t.r1), spread(t.r2)},
          step};
}

/// Traction of the points of a chunk that touch one face, and their slip: the law of `touch` in reference/contact_patch.cpp. Points that
/// are inside but not down on their offset carry nothing and lose their slip.
VOUSSOIR_INLINE void touch(const Facing& f, const FacingLanes& g, PointsView p, ContactPoints q, int i, LaneMask mine,
                           Touching& sum) noexcept {
  const Lanes zero{}, one = lanes(1.0), s = load_lanes(p.s + i), t = load_lanes(p.t + i), da = f.factor * load_lanes(p.area + i);
  const Lanes xn = f.depth.g0 + s * f.depth.gs + t * f.depth.gt - load_lanes(q.closure + i);
  const LaneMask closed = mine & (xn < 0.0);
  const VecLanes v = g.v0 + (s * g.vs + t * g.vt);
  const Lanes vn = dot(v, g.n);
  const VecLanes vt = v - vn * g.n;
  const VecLanes body{load_lanes(q.slip_x + i), load_lanes(q.slip_y + i), load_lanes(q.slip_z + i)};
  const VecLanes carried = body + g.d * body;
  const VecLanes before = carried - dot(carried, g.n) * g.n, du = lanes(g.step) * vt;
  VecLanes x = before + du;
  const Lanes dn = min(f.k.cn * vn, -f.k.kn * xn);
  const Lanes limit = -(f.k.kn * xn + dn) * f.tan_phi, limit2 = limit * limit;
  Lanes spring2 = f.k.ks * f.k.ks * dot(x, x);
  const LaneMask cut = closed & (spring2 > limit2);
  if (bits(cut) != 0) {
    x = select(cut, limit / sqrt(spring2), one) * x;
    spring2 = min(spring2, limit2);
  }
  const VecLanes spring = lanes(f.k.ks) * x, all = lanes(f.k.cs) * vt;
  const Lanes pd = dot(spring, all), dd = dot(all, all);
  const LaneMask within = spring2 + 2.0 * pd + dd <= limit2;
  Lanes h = one;
  if (bits(closed & ~within) != 0) {
    h = select(within, one, max((sqrt(max(pd * pd + dd * (limit2 - spring2), zero)) - pd) / dd, zero));
  }
  const VecLanes none{zero, zero, zero};
  const VecLanes dash = select3(closed, h * all + dn * g.n, none);
  const VecLanes springs = select3(closed, spring + (f.k.kn * xn) * g.n, none);
  sum.total.add(da * (springs + dash), s, t);
  sum.dash.add(da * dash, s, t);
  const VecLanes now = select3(closed, x, none), kept = select3(mine, now + g.d_transposed * now, body);
  store_lanes(q.slip_x + i, kept.x), store_lanes(q.slip_y + i, kept.y), store_lanes(q.slip_z + i, kept.z);
  const Lanes n_now = select(closed, xn, zero);
  sum.stored += da * (0.5 * f.k.kn * (n_now * n_now) + 0.5 * f.k.ks * dot(now, now));
  // A point that was closed, stays closed and does not slip loses nothing.
  const Lanes dun = g.step * vn;
  const LaneMask changed = mine & (cut | (closed ^ (xn - dun < 0.0)) | ~closed);
  if (bits(changed) == 0) return;
  const VecLanes was = select3(closed, before, carried);
  const Lanes n_before = min(xn - dun, zero);
  const Lanes shear = 0.5 * f.k.ks * (dot(was, was) - dot(now, now) + dot(was + now, du));
  const Lanes normal = 0.5 * f.k.kn * (n_before * n_before - n_now * n_now + (n_before + n_now) * dun);
  sum.friction += select(changed, da * shear, zero);
  sum.impact += select(changed, da * normal, zero);
}

/// Points of the patch that touch one face of candidate k.
void touch_face(Work& w, const Facing& f, std::int32_t element, std::int32_t face, Touching& sum) noexcept {
  const FacingLanes g = facing_lanes(f, w.m.pose.d, w.o.step);
  for (int i = 0; i < w.points.n; i += kWidth) {
    const LaneMask mine = equal(w.q.partner + i, element) & equal(w.q.face + i, face);
    if (bits(mine) != 0) touch(f, g, w.points, w.q, i, mine, sum);
  }
}

/// The partners of a patch and their faces, each once, in the order of the points: mostly one, seldom more than two.
struct Partners {
  std::int32_t *element, *face;  // room for one entry a point
  int count = 0, points = 0;

  [[nodiscard]] bool hold(std::int32_t e) const noexcept { return std::find(element, element + count, e) != element + count; }
  void add(std::int32_t e, std::int32_t f) noexcept {
    for (int n = 0; n < count; ++n) {
      if (element[n] == e && face[n] == f) return;
    }
    element[count] = e, face[count] = f;
    ++count;
  }
};
Partners partners_of(PointsView p, ContactPoints q, PatchScratch scratch) noexcept {
  Partners all{scratch.pair_element, scratch.pair_face};
  for (int i = 0; i < p.n; i += kWidth) {
    const LaneMask held = ~equal(q.partner + i, kNobody);
    all.points += std::popcount(bits(held));
    LaneMask unknown = held;
    if (all.count > 0) unknown &= ~(equal(q.partner + i, all.element[0]) & equal(q.face + i, all.face[0]));
    for (unsigned rest = bits(unknown); rest != 0; rest &= rest - 1) {
      const int k = i + std::countr_zero(rest);
      all.add(q.partner[k], q.face[k]);
    }
  }
  return all;
}

/// Forces of all points that touch candidate k. Returns whether any carries force.
bool evaluate(Work& w, std::int32_t k, const Partners& partners, PairWrench& wrench) noexcept {
  const Candidate& c = w.candidates[static_cast<std::size_t>(k)];
  const auto pushes = [&](int n) { return partners.element[n] == c.element && partners.face[n] != kNoFace; };
  int n = 0;
  while (n < partners.count && !pushes(n)) ++n;
  if (n == partners.count) return false;
  const InSlave y = slave_frame(w, c);
  Touching sum;
  for (; n < partners.count; ++n) {
    if (!pushes(n)) continue;
    const std::int32_t face = partners.face[n];
    touch_face(w, facing(w.patch, w.m, y, c, face, w.bodies, w.faces, w.o), c.element, face, sum);
  }
  const Quad energy = sums_of(sum.stored, sum.friction, sum.impact, Lanes{});
  w.r.stored += energy[0], w.r.friction += energy[1], w.r.impact += energy[2];
  const Vec3 arm_b = (w.m.ref - reference(w.bodies, c.element)) + (w.m.centre - load_pose(w.bodies.pose, c.element).u);
  write_wrench(w.m, arm_b, sum.total.sum(), sum.dash.sum(), wrench);
  return true;
}

/// Points of the patch against candidate k: few have come in or left, the others need no look.
void look_at(Work& w, std::int32_t k, const InSlave& y) noexcept {
  const Candidate& c = w.candidates[static_cast<std::size_t>(k)];
  const PlaneFields planes = plane_fields(y, w.faces, c);
  for (int i = 0; i < w.points.n; i += kWidth) {
    const Lanes s = load_lanes(w.points.s + i), t = load_lanes(w.points.t + i);
    Lanes distance = lanes(-1e300);  // the largest over the faces: negative inside
    for (int f = 0; f < planes.count; ++f) distance = max(distance, planes.g[f].g0 + s * planes.g[f].gs + t * planes.g[f].gt);
    const LaneMask in = distance < 0.0;
    unsigned rest = bits((in & equal(w.q.partner + i, kNobody)) | (~in & equal(w.q.partner + i, c.element)));
    if (w.points.n - i < kWidth) rest &= (1U << (w.points.n - i)) - 1U;
    for (; rest != 0; rest &= rest - 1) {
      const int l = std::countr_zero(rest);
      look_at_point(w, k, y, planes, i + l, (bits(in) >> l & 1U) != 0);
    }
  }
}

/// True if the face that separated the two last time still does, found without turning the whole patch.
bool still_separated(const Patch& p, const Master& m, const Bodies& b, const FaceTable& faces, const Candidate& c) noexcept {
  const Pose slave = load_pose(b.pose, c.element);
  const Vec3 n = apply(slave, faces.normal[c.separating]);
  const Vec3 from = (m.ref - reference(b, c.element)) + (m.centre - slave.u);
  return separates(p, {dot(n, from) - faces.distance[c.separating], dot(n, m.es), dot(n, m.et)});
}

/// True if the two were farther apart at the last search than all that either can have moved since.
bool out_of_reach(const Patch& p, const Bodies& b, const Candidate& c, double gap) noexcept {
  return gap > b.moved[p.element] + b.moved[c.element];
}

}  // namespace

double depth_under_face(const Patch& patch, double s, double t, std::int32_t slave, std::int32_t face, const Bodies& bodies,
                        const FaceTable& faces, const ContactOptions& o) noexcept {
  const Master m = master_of(patch, bodies);
  const InSlave y = in_slave(m, load_pose(bodies.pose, slave), reference(bodies, slave));
  return facing(patch, m, y, {slave, 0, 0, 0}, face, bodies, faces, o).depth.at(s, t);
}

// Pass 1 releases points that left their partner and finds the deepest new one for free points; pass 2 evaluates the forces. Candidates
// that nothing touched, and that are out of reach or still separated, are passed over at once: most are.
PatchResult advance_patch(const Patch& patch, PointsView points, ContactPoints q, bool had_partners, std::span<Candidate> candidates,
                          const double* gap, const Bodies& bodies, const FaceTable& faces, const ContactOptions& o, PatchScratch scratch,
                          PairWrench* wrench, std::uint8_t* active) noexcept {
  const auto count = static_cast<std::int32_t>(candidates.size());
  std::fill_n(active, count, std::uint8_t{0});
  Partners partners{scratch.pair_element, scratch.pair_face};
  if (had_partners) partners = partners_of(points, q, scratch);
  const auto passed_over = [&](const Candidate& c) {
    return out_of_reach(patch, bodies, c, gap[&c - candidates.data()]) && !partners.hold(c.element);
  };
  if (std::all_of(candidates.begin(), candidates.end(), passed_over)) return {};
  Work w{patch, points, q, candidates, bodies, faces, o, scratch, master_of(patch, bodies), {}};
  bool near = had_partners;
  if (near) std::fill_n(scratch.candidate, points.n, -1);
  for (std::int32_t k = 0; k < count; ++k) {
    Candidate& c = candidates[static_cast<std::size_t>(k)];
    if (passed_over(c)) continue;
    const bool held = partners.hold(c.element);
    if (!held && still_separated(patch, w.m, bodies, faces, c)) continue;
    const InSlave y = slave_frame(w, c);
    if (!held && separated(patch, y, faces, c)) continue;
    if (!near) std::fill_n(scratch.candidate, points.n, -1);
    near = true;
    look_at(w, k, y);
  }
  if (!near) return w.r;
  take_partners(w);
  if (w.changed) partners = partners_of(points, q, scratch);
  w.r.touching = partners.points;
  for (std::int32_t k = 0; k < count; ++k) active[k] = evaluate(w, k, partners, wrench[k]) ? 1 : 0;
  return w.r;
}

}  // namespace voussoir::kernels
