// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <bit>

#include "geometry/nth.h"
#include "kernels/contact/patch_work.h"
#include "kernels/lanes.h"

namespace voussoir::kernels {

namespace {

/// Lanes in which the entry of `list` equals `value`.
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

/// The pair of a patch and one face, prepared for several points at a time.
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

/// Traction and slip of the points of a chunk that touch one face: the law of `touch` in reference/contact_patch.cpp. Points inside the
/// body but above their offset carry no force and lose their slip.
/// \param cn  normal dashpots of the points
VOUSSOIR_INLINE void touch(const Facing& f, const FacingLanes& g, PointsView p, ContactPoints q, int i, LaneMask mine, Lanes cn,
                           Touching& sum) noexcept {
  PointSprings& k = q.springs_at(i);
  const Lanes zero{}, one = lanes(1.0), s = load_lanes(p.s + i), t = load_lanes(p.t + i), da = f.factor * load_lanes(p.area + i);
  const Lanes xn = f.depth.g0 + s * f.depth.gs + t * f.depth.gt - load_lanes(k.closure);
  const LaneMask closed = mine & (xn < 0.0);
  const VecLanes v = g.v0 + (s * g.vs + t * g.vt);
  const Lanes vn = dot(v, g.n);
  const VecLanes vt = v - vn * g.n;
  const VecLanes body{load_lanes(k.slip_x), load_lanes(k.slip_y), load_lanes(k.slip_z)};
  const VecLanes carried = body + g.d * body;
  const VecLanes before = carried - dot(carried, g.n) * g.n, du = lanes(g.step) * vt;
  VecLanes x = before + du;
  const Lanes dn = min(cn * vn, f.excess - f.k.kn * xn);
  const Lanes limit = max(-(f.k.kn * xn + dn) * f.tan_phi, zero), limit2 = limit * limit;
  Lanes spring2 = f.k.ks * f.k.ks * dot(x, x);
  const LaneMask cut = closed & (spring2 > limit2);
  if (bits(cut) != 0) {
    x = select(cut, limit / sqrt(spring2), one) * x;
    spring2 = min(spring2, limit2);
  }
  const VecLanes spring = lanes(f.k.ks) * x, all = lanes(f.k.cs) * vt;
  const Lanes pd = dot(spring, all), dd = dot(all, all);
  const LaneMask within = spring2 + 2.0 * pd + dd <= limit2 + f.excess;
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
  store_lanes(k.slip_x, kept.x), store_lanes(k.slip_y, kept.y), store_lanes(k.slip_z, kept.z);
  const Lanes n_now = select(closed, xn, zero);
  sum.stored += da * (0.5 * f.k.kn * (n_now * n_now) + 0.5 * f.k.ks * dot(now, now));
  // No loss in a point that was closed, stays closed and does not slip.
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

/// Crushes the points `mine` of a chunk, which touch one face, where their pressure exceeds their strength.
[[gnu::noinline]] void crush(Work& w, const Facing& f, int i, unsigned mine) noexcept {
  for (; mine != 0; mine &= mine - 1) {
    const int k = i + std::countr_zero(mine);
    crush_point(f, w.points.s[k], w.points.t[k], w.points.area[k], w.q, k, w.o, w.r);
  }
}

/// Updates the indentations of the points `mine` of a chunk, which touch one face. \return their normal dashpots
[[gnu::noinline]] Lanes press(Work& w, const Facing& f, int i, unsigned mine) noexcept {
  Lanes cn{};
  for (; mine != 0; mine &= mine - 1) {
    const int l = std::countr_zero(mine), k = i + l;
    if (press_point(f, w.points.s[k], w.points.t[k], w.points.area[k], w.q, k, w.o, w.r)) cn[l] = f.k.cn;
  }
  return cn;
}

/// Forces of the points in the range of a candidate that touch one of its faces.
void touch_face(Work& w, const Facing& f, const Candidate& c, std::int32_t face, Touching& sum) noexcept {
  const FacingLanes g = facing_lanes(f, w.m.pose.d, w.o.step);
  for (int i = c.first; i < c.last; i += kWidth) {
    const LaneMask mine = equal(w.q.partner + i, c.element) & equal(w.q.face + i, face);
    if (bits(mine) == 0) continue;
    if (w.q.crushed != nullptr) crush(w, f, i, bits(mine));
    touch(f, g, w.points, w.q, i, mine, w.q.pressed == nullptr ? lanes(f.k.cn) : press(w, f, i, bits(mine)), sum);
  }
}

/// Lists the faces of candidate c against which points of its range push, each once, in the order of the points.
int faces_pushed(const Work& w, const Candidate& c, std::int32_t* list) noexcept {
  int count = 0;
  for (int i = c.first; i < c.last; ++i) {
    const std::int32_t face = w.q.face[i];
    if (w.q.partner[i] != c.element || face == kNoFace || std::find(list, list + count, face) != list + count) continue;
    list[count++] = face;
  }
  return count;
}

/// Writes to the candidates which points touch them and which faces these points push against.
void list_partners(Work& w) noexcept {
  for (Candidate& c : w.candidates) c.face = kNoFace, c.first = c.last = 0;
  if (w.r.touching == 0 && !w.changed) return;
  w.r.touching = 0;
  for (int i = 0; i < w.points.n; i += kWidth) {
    for (unsigned rest = bits(~equal(w.q.partner + i, kNobody)); rest != 0; rest &= rest - 1) {
      const int k = i + std::countr_zero(rest);
      ++w.r.touching;
      const auto is_partner = [&](const Candidate& c) { return c.element == w.q.partner[k]; };
      const auto found = std::find_if(w.candidates.begin(), w.candidates.end(), is_partner);
      if (found == w.candidates.end()) continue;  // only in a forged checkpoint
      Candidate& c = *found;
      if (c.last == 0) c.first = i, c.safe = kLookNow;
      c.last = i + kWidth;
      if (w.q.face[k] == kNoFace || c.face == w.q.face[k]) continue;
      c.face = c.face == kNoFace ? w.q.face[k] : kSeveralFaces;
    }
  }
}

/// Forces of all points that touch candidate c. Returns whether any point carries force.
bool evaluate(Work& w, const Candidate& c, PairWrench& wrench) noexcept {
  if (c.face == kNoFace) return false;
  const InSlave y = slave_frame(w, c);
  Touching sum;
  const auto add = [&](std::int32_t face) { touch_face(w, facing(w.patch, w.m, y, c, face, w.bodies, w.faces, w.o), c, face, sum); };
  if (c.face == kSeveralFaces) {
    std::int32_t* const faces = w.scratch.face;  // at most one per point
    const int count = faces_pushed(w, c, faces);
    for (int n = 0; n < count; ++n) add(faces[n]);
  } else {
    add(c.face);
  }
  const Quad energy = sums_of(sum.stored, sum.friction, sum.impact, Lanes{});
  w.r.stored += energy[0], w.r.friction += energy[1], w.r.impact += energy[2];
  const Vec3 arm_b = (w.m.ref - reference(w.bodies, c.element)) + (w.m.centre - load_pose(w.bodies.pose, c.element).u);
  write_wrench(w.m, arm_b, sum.total.sum(), sum.dash.sum(), wrench);
  return true;
}

/// Greatest distance of the points of a chunk from the faces of a candidate [m]: negative inside.
VOUSSOIR_INLINE Lanes distances(const PlaneFields& planes, Lanes s, Lanes t) noexcept {
  Lanes most = lanes(-1e300);
  for (int f = 0; f < planes.count; ++f) most = max(most, planes.g[f].g0 + s * planes.g[f].gs + t * planes.g[f].gt);
  return most;
}

/// Distances of points from the face that each touches, and greatest distance from all other faces.
struct Distances {
  Lanes own = lanes(-1e300), beside = lanes(-1e300);
};
VOUSSOIR_INLINE Distances distances_of_held(const PlaneFields& planes, std::int32_t first_face, const std::int32_t* face, Lanes s,
                                            Lanes t) noexcept {
  Distances d;
  for (int f = 0; f < planes.count; ++f) {
    const Lanes g = planes.g[f].g0 + s * planes.g[f].gs + t * planes.g[f].gt;
    const LaneMask is_own = equal(face, first_face + f);
    d.own = select(is_own, g, d.own);
    d.beside = select(is_own, d.beside, max(d.beside, g));
  }
  return d;
}

// Share of the distance to other faces that held points may use. A point outside its partner's face may lie beyond the partner's radius,
// for which travel bounds hold; the remaining 5 % covers the difference.
constexpr double kHeldRoom = 0.95;

/// Distance outside its partner's face up to which a point stays [m]: the offset from its joint, at which it is still in contact.
VOUSSOIR_INLINE Lanes kept_out_to(ContactPoints q, int i) noexcept { return max(lanes(0.0), load_lanes(q.springs_at(i).closure)); }

/// Tests the points of the patch against candidate k; few of them come in or leave in a step. Returns the travel [m] of both bodies before
/// another point can come in or leave, except through the face that the point touches.
double look_at(Work& w, std::int32_t k, const InSlave& y) noexcept {
  const Candidate& c = nth(w.candidates, k);
  const PlaneFields planes = plane_fields(y, w.faces, c, w.scratch.planes);
  const Lanes far = lanes(1e300);
  Lanes spare = far;
  for (int i = 0; i < w.points.n; i += kWidth) {
    const Lanes s = load_lanes(w.points.s + i), t = load_lanes(w.points.t + i), distance = distances(planes, s, t);
    const LaneMask free = equal(w.q.partner + i, kNobody), held = equal(w.q.partner + i, c.element);
    LaneMask in = distance < 0.0;
    Lanes room = select(free, distance, far);
    if (bits(held) != 0) {
      const Distances d = distances_of_held(planes, c.first_face, w.q.face + i, s, t);
      in = (in & ~held) | (held & (d.beside < 0.0) & (d.own < kept_out_to(w.q, i)));
      room = select(held, -kHeldRoom * d.beside, room);
    }
    unsigned rest = bits((in & free) | (~in & held));
    if (w.points.n - i < kWidth) {
      rest &= (1U << (w.points.n - i)) - 1U;
      for (int l = w.points.n - i; l < kWidth; ++l) room[l] = 1e300;
    }
    spare = min(spare, room);
    for (; rest != 0; rest &= rest - 1) {
      const int l = std::countr_zero(rest);
      look_at_point(w, k, y, planes, i + l, (bits(in) >> l & 1U) != 0);
    }
  }
  double least = spare[0];
  for (int l = 1; l < kWidth; ++l) least = std::min(least, spare[l]);
  return least;
}

/// Whether some point that touches candidate c may have left through that face. All other ways out are bounded by Candidate::safe.
bool leaves(const Work& w, const Candidate& c) noexcept {
  if (c.face == kNoFace) return false;
  if (c.face == kSeveralFaces) return true;
  const Pose slave = load_pose(w.bodies.pose, c.element);
  const Vec3 n = apply(slave, w.faces[c.face].normal);
  const Vec3 from = (w.m.ref - reference(w.bodies, c.element)) + (w.m.centre - slave.u);
  const double g0 = dot(n, from) - w.faces[c.face].distance + kRoundOff, gs = dot(n, w.m.es), gt = dot(n, w.m.et);
  LaneMask out{};
  for (int i = c.first; i < c.last; i += kWidth) {
    const Lanes depth = g0 + load_lanes(w.points.s + i) * gs + load_lanes(w.points.t + i) * gt;
    out |= equal(w.q.partner + i, c.element) & equal(w.q.face + i, c.face) & (depth >= kept_out_to(w.q, i));
  }
  return bits(out) != 0;
}

/// Tests candidate k if something may have changed; in most steps nothing can.
void look_if_due(Work& w, std::int32_t k) noexcept {
  Candidate& c = nth(w.candidates, k);
  const double travel = w.bodies.travel[w.patch.element] + w.bodies.travel[c.element];
  if (travel < c.safe && !w.changed && !leaves(w, c)) return;  // a point released by another partner is new for this candidate
  const InSlave y = slave_frame(w, c);
  const double apart = c.first < c.last ? -1.0 : separation(w.patch, y, w.faces, c);
  if (apart < 0.0 && !w.looked) std::fill_n(w.scratch.candidate, w.points.n, -1), w.looked = true;
  c.safe = travel + (apart >= 0.0 ? apart : look_at(w, k, y)) - kRoundOff;
}

}  // namespace

double depth_under_face(const Patch& patch, double s, double t, std::int32_t slave, std::int32_t face, const Bodies& bodies,
                        const Face* faces, const ContactOptions& o) noexcept {
  const Master m = master_of(patch, bodies);
  const InSlave y = in_slave(m, load_pose(bodies.pose, slave), reference(bodies, slave));
  return facing(patch, m, y, {.element = slave}, face, bodies, faces, o).depth.at(s, t);
}

// Pass 1 releases points that left their partner and finds partners for free points; pass 2 evaluates the forces.
PatchResult advance_patch(const Patch& patch, PointsView points, ContactPoints q, int touching, std::span<Candidate> candidates,
                          const Bodies& bodies, const Face* faces, const ContactOptions& o, PatchScratch scratch, PairWrench* wrench,
                          std::uint8_t* active) noexcept {
  Work w{patch, points, q, candidates, bodies, faces, o, scratch, master_of(patch, bodies), {}};
  w.r.touching = touching;
  if (candidates.front().face == kUnknownFace) list_partners(w);
  const auto count = static_cast<std::int32_t>(candidates.size());
  for (std::int32_t k = 0; k < count; ++k) look_if_due(w, k);
  if (w.noted) take_partners(w);
  if (w.changed) {
    list_partners(w);
    for (Candidate& c : candidates) c.safe = kLookNow;
  }
  for (std::int32_t k = 0; k < count; ++k) active[k] = evaluate(w, nth(candidates, k), wrench[k]) ? 1 : 0;
  return w.r;
}

}  // namespace voussoir::kernels
