// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "kernels/whole_sides.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geometry/nth.h"
#include "kernels/prefetch.h"
#include "kernels/side_lanes.h"

namespace voussoir::kernels {

namespace {

// Share of the limits that the bound uses. The bound takes the length of the mean normal for 1; it is shorter by at most half of kSeries.
constexpr double kInside = 1.0 - 1e-4;
constexpr double kLength = 1e-14;  // m, round-off of displacements: the margin of a limit of zero
constexpr double kDigits = 1e5;    // |u|² − u_n² keeps its digits while u_n is at most this times the allowed slide
constexpr double kPoints = 2e-12;  // m, precision of points of sides: a smaller Σ s t dA counts as zero

/// Two orthogonal tangents with Σ s t dA = 0, the reach of the points along them, and Σ s² dA, Σ t² dA.
struct Principal {
  Vec3 es, et;
  double reach_s, reach_t, sss, stt;
  bool turned;  // they are not the tangents of the side
};

Principal principal_of(const SideConstants& c, int l) noexcept {
  const auto vec = [l](const double v[3][kLanes]) { return Vec3{v[0][l], v[1][l], v[2][l]}; };
  double cosine = 1.0, sine = 0.0;
  const double reach = std::max({-c.s_low[l], c.s_high[l], -c.t_low[l], c.t_high[l]});
  if (std::abs(c.sst[l]) > kPoints * 2.0 * reach * c.area[l]) {  // one Jacobi rotation
    const double theta = (c.stt[l] - c.sss[l]) / (2.0 * c.sst[l]);
    const double tangent = std::copysign(1.0, theta) / (std::abs(theta) + std::sqrt(1.0 + theta * theta));
    cosine = 1.0 / std::sqrt(1.0 + tangent * tangent), sine = -tangent * cosine;
  }
  Principal p{cosine * vec(c.es) + sine * vec(c.et), cosine * vec(c.et) - sine * vec(c.es), 0.0, 0.0, 0.0, 0.0, sine != 0.0};
  for (const double s : {c.s_low[l], c.s_high[l]}) {
    for (const double t : {c.t_low[l], c.t_high[l]}) {
      p.reach_s = std::max(p.reach_s, std::abs(cosine * s + sine * t));
      p.reach_t = std::max(p.reach_t, std::abs(cosine * t - sine * s));
    }
  }
  const double cross = 2.0 * cosine * sine * c.sst[l];
  p.sss = cosine * cosine * c.sss[l] + cross + sine * sine * c.stt[l];
  p.stt = sine * sine * c.sss[l] - cross + cosine * cosine * c.stt[l];
  return p;
}

double part(Vec3 v, int axis) noexcept { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/// The axis that a unit vector lies along, or −1.
int axis_of(Vec3 v) noexcept {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(part(v, axis)) == 1.0) return axis;
  }
  return -1;
}

/// Sets the limits of the bound: |τ| up to c, or up to half of what the cap allows without pressure, which leaves a part for pressure.
void set_limits(const SideConstants& c, int l, WholeConstants& w) noexcept {
  const double shear = std::min(c.cohesion[l], 0.5 * c.compression[l] / std::sqrt(c.cap[l]));  // no cap: 1/0
  const double share = c.cap[l] > 0.0 ? shear / c.compression[l] : 0.0;
  const double slide = kInside * shear / (std::sqrt(3.0) * c.ks[l]) - kLength;
  const auto limit = [&](double stress) { return std::min(2.0 * (kInside * stress / c.kn[l] - kLength), kDigits * slide); };
  w.slide2[l] = slide > 0.0 ? slide * slide : -1.0;
  w.forward[l] = limit(c.tension[l]);
  w.backward[l] = limit(c.compression[l] * std::sqrt(1.0 - c.cap[l] * share * share));
}

void set_lane(const SideConstants& c, int l, bool on_base, const Principal& p, WholeConstants& w) noexcept {
  const auto put = [l](double(&to)[3][kLanes], Vec3 v) { to[0][l] = v.x, to[1][l] = v.y, to[2][l] = v.z; };
  put(w.es, p.es), put(w.et, p.et);
  for (int i = 0; i < 3; ++i) w.ca[i][l] = c.ca[i][l], w.cb[i][l] = c.cb[i][l];
  w.force[l] = c.ks[l] * c.area[l];
  w.about_s[l] = 0.5 * c.ks[l] * p.sss, w.about_t[l] = 0.5 * c.ks[l] * p.stt;
  w.reach_s[l] = p.reach_s, w.reach_t[l] = p.reach_t;
  w.normal[l] = 0.25 * (c.kn[l] - c.ks[l]) / c.ks[l];
  w.twist[l] = c.twist[l];
  w.mean[l] = c.mean[l], w.normal_turns[l] = on_base ? 0.0 : 1.0;
  set_limits(c, l, w);
  // (11a) is the same for all tangents of a mean frame alone.
  if (c.twist[l] != 0.0 && c.mean[l] != 0.5 && p.turned) w.slide2[l] = -1.0;
}

/// Permutes a lane into the axes of the kernel: its normal lies along `axis`, its tangents along the next two axes.
void turn_to(int axis, int l, const Principal& p, WholeConstants& w) noexcept {
  if (axis_of(p.es) != (axis + 1) % 3) std::swap(w.reach_s[l], w.reach_t[l]), std::swap(w.about_s[l], w.about_t[l]);
  if (part(cross(p.es, p.et), axis) < 0.0) std::swap(w.forward[l], w.backward[l]);
  for (int i = 0; i < 3; ++i) {
    w.es[i][l] = i == (axis + 1) % 3 ? 1.0 : 0.0;
    w.et[i][l] = i == (axis + 2) % 3 ? 1.0 : 0.0;
  }
}

}  // namespace

int axis_of_side(Vec3 es, Vec3 et) noexcept { return axis_of(es) >= 0 && axis_of(et) >= 0 ? axis_of(cross(es, et)) : -1; }

WholeConstants whole_constants(const SideConstants& c, unsigned on_base) noexcept {
  WholeConstants w{};
  Principal principal[kLanes];
  int axis = -2;  // −2: none yet
  for (int l = 0; l < kLanes; ++l) {
    if (c.area[l] == 0.0) continue;  // an unused lane, whose results nobody reads
    principal[l] = principal_of(c, l);
    set_lane(c, l, (on_base >> l & 1U) != 0, principal[l], w);
    const int here = c.mean[l] == 0.5 ? axis_of_side(principal[l].es, principal[l].et) : -1;
    axis = axis == -2 || axis == here ? here : -1;
  }
  w.axis = std::any_of(c.twist, c.twist + kLanes, [](double t) { return t != 0.0; }) ? kSolidFaces : std::max(axis, -1);
  for (int l = 0; l < kLanes && w.axis >= 0; ++l) {
    if (c.area[l] != 0.0) turn_to(w.axis, l, principal[l], w);
  }
  return w;
}

namespace {

/// Displacements and frames of kWidth sides, global axes.
struct Standing {
  VecLanes d, a, b;       // u(s,t) = d + s a + t b [m, -, -]
  VecLanes es, et, n;     // twice the mean tangents and the mean normal
  VecLanes arm_a, arm_b;  // m, from the centroids to the point of action at the centre
};

VOUSSOIR_INLINE Lanes part(VecLanes v, int axis) noexcept { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/// a·b + c, summed from c on.
VOUSSOIR_INLINE Lanes dot_plus(VecLanes a, VecLanes b, Lanes c) noexcept { return a.z * b.z + (a.y * b.y + (a.x * b.x + c)); }
VOUSSOIR_INLINE VecLanes cross_plus(VecLanes a, VecLanes b, VecLanes c) noexcept {
  return {c.x + a.y * b.z - a.z * b.y, c.y + a.z * b.x - a.x * b.z, c.z + a.x * b.y - a.y * b.x};
}

/// Component i of the tangents and the normal, and of the arms, of sides whose normals lie along `axis`: columns of R − I.
template <int axis>
VOUSSOIR_INLINE void stand_along(int i, VecLanes p, VecLanes q, Lanes VecLanes::*x, Standing& k) noexcept {
  constexpr int s = (axis + 1) % 3, t = (axis + 2) % 3;
  const auto twice = [&](int column) {
    return column == i ? 2.0 + (part(q, column) + part(p, column)) : part(q, column) + part(p, column);
  };
  k.a.*x = part(q, s) - part(p, s), k.b.*x = part(q, t) - part(p, t);
  k.es.*x = twice(s), k.et.*x = twice(t), k.n.*x = twice(axis);
}

/// Component i for sides of any direction.
VOUSSOIR_INLINE void stand_anyhow(const WholeConstants& c, int at, int i, VecLanes p, VecLanes q, Lanes VecLanes::*x,
                                  Standing& k) noexcept {
  const VecLanes es = load3(c.es, at), et = load3(c.et, at), n = cross(es, et), difference = q - p;
  const Lanes mean = load_lanes(c.mean + at);
  const VecLanes sum = (2.0 - 2.0 * mean) * p + (2.0 * mean) * q;
  k.a.*x = dot(difference, es), k.b.*x = dot(difference, et);
  k.es.*x = dot_plus(sum, es, 2.0 * load_lanes(c.es[i] + at)), k.et.*x = dot_plus(sum, et, 2.0 * load_lanes(c.et[i] + at));
  k.n.*x = 2.0 * (n.*x) + load_lanes(c.normal_turns + at) * dot(sum, n);
}

template <int axis>
VOUSSOIR_INLINE void stand(const WholeConstants& c, int at, int i, const RowPointers& a, const RowPointers& b, Lanes VecLanes::*x,
                           Standing& k) noexcept {
  const PoseRow p = pose_row(a, i), q = pose_row(b, i);
  const Lanes da = dot(p.d, load3(c.ca, at)), db = dot(q.d, load3(c.cb, at)), d = (q.u - p.u) + (db - da);
  k.d.*x = d;
  const Lanes mean = axis < 0 ? load_lanes(c.mean + at) : lanes(0.5);
  k.arm_a.*x = load_lanes(c.ca[i] + at) + da + mean * d;
  k.arm_b.*x = load_lanes(c.cb[i] + at) + db - (1.0 - mean) * d;
  if constexpr (axis < 0) {
    stand_anyhow(c, at, i, p.d, q.d, x, k);
  } else {
    stand_along<axis>(i, p.d, q.d, x, k);
  }
}

/// Lanes that certainly stay whole: |u_n − d_n| is at most S |a_n| + T |b_n|, and the square of a sum of three is at most three times the
/// sum of the squares. dn, an, bn are twice the components of d, a, b along the mean normal, whose square is 1 + e.
VOUSSOIR_INLINE LaneMask inside(const WholeConstants& c, int at, const Standing& k, Lanes e, Lanes dn, Lanes an, Lanes bn) noexcept {
  const Lanes s = load_lanes(c.reach_s + at), t = load_lanes(c.reach_t + at), sn = s * an, tn = t * bn;
  const Lanes swing = max(sn, -sn) + max(tn, -tn);
  const Lanes u2 = dot(k.d, k.d) + ((s * s) * dot(k.a, k.a) + (t * t) * dot(k.b, k.b));
  const Lanes slide2 = u2 - 0.25 * (dn * dn + (sn * sn + tn * tn));
  return (swing + dn <= load_lanes(c.forward + at)) & (swing - dn <= load_lanes(c.backward + at)) & (slide2 <= load_lanes(c.slide2 + at)) &
         (e * e <= kSeries * kSeries);
}

VOUSSOIR_INLINE VecLanes scaled_sum(Lanes f, VecLanes a, VecLanes b) noexcept { return {f * a.x + b.x, f * a.y + b.y, f * a.z + b.z}; }

/// Advances the sides `live` of a group of lanes; does nothing and returns false if the sides are not certain to stay whole.
template <int axis>
VOUSSOIR_INLINE bool advance_group(const SideBlock& block, int at, unsigned live, std::int64_t first, const Rows& rows) noexcept {
  const WholeConstants& c = *block.whole;
  const RowPointers a = row_pointers(rows.pose, kPoseStride, block.master + at);
  const RowPointers b = row_pointers(rows.pose, kPoseStride, block.slave + at);
  Standing k;
  stand<axis>(c, at, 0, a, b, &VecLanes::x, k);
  stand<axis>(c, at, 1, a, b, &VecLanes::y, k);
  stand<axis>(c, at, 2, a, b, &VecLanes::z, k);
  SolidFaces solid;
  if constexpr (axis == kSolidFaces) {
    solid = solid_faces(block, at, k.n, k.es, load_lanes(c.twist + at));
    k.a = solid.along_s(k.a), k.b = solid.along_t(k.b);
  }
  const Lanes e = 0.25 * dot(k.n, k.n) - 1.0;
  const Lanes dn = dot(k.d, k.n), an = dot(k.a, k.n), bn = dot(k.b, k.n);
  if ((bits(inside(c, at, k, e, dn, an, bn)) & live) != live) return false;
  // K u / k̄_s = u + (k̄_n − k̄_s)/k̄_s (u·n) n / n², and 1/n² = 1 − e + e² − e³.
  const Lanes f = load_lanes(c.normal + at) * (1.0 - e * (1.0 - e * (1.0 - e)));
  const VecLanes force = load_lanes(c.force + at) * scaled_sum(f * dn, k.n, k.d);
  VecLanes along_s = load_lanes(c.about_s + at) * scaled_sum(f * an, k.n, k.a);
  VecLanes along_t = load_lanes(c.about_t + at) * scaled_sum(f * bn, k.n, k.b);
  if constexpr (axis == kSolidFaces) along_s = solid.along_s(along_s), along_t = solid.along_t(along_t);
  const VecLanes m = cross_plus(k.es, along_s, cross(k.et, along_t));
  assemble(block, at, first, {force, cross_plus(k.arm_a, force, m), cross_plus(k.arm_b, force, m)}, live, rows, false);
  note_copies(rows, first + at, live);
  return true;
}

/// Prefetches the constants that the kernel of an axis reads.
template <int axis>
VOUSSOIR_INLINE void prefetch_constants(const WholeConstants& c) noexcept {
  prefetch(&c, axis < 0 ? sizeof c : offsetof(WholeConstants, es));
}

/// Advances blocks of the run from block `i` on while their normals lie along `axis`. False: block i is not certain to stay whole, except
/// for its `lanes`, which are done.
template <int axis>
[[gnu::noinline]] bool advance_along(const WholeRun& run, std::size_t& i, const Rows& rows, unsigned& lanes) noexcept {
  for (; i < run.numbers.size(); ++i) {
    const auto number = static_cast<std::size_t>(run.numbers[i]);
    const SideBlock& block = run.blocks[number];
    if (block.axis != axis) return true;
    lanes = 0;
    if (i < run.prefetch.size()) prefetch_constants<axis>(*nth(run.blocks, run.prefetch[i]).whole);
    for (int at = 0; at < kLanes; at += kWidth) {
      const unsigned live = run.live_lanes[number] >> at & kGroup;
      if (live == 0) continue;
      if (!advance_group<axis>(block, at, live, run.first_side + static_cast<std::int64_t>(number) * kLanes, rows)) return false;
      lanes |= live << at;
    }
  }
  return true;
}

}  // namespace

std::size_t advance_whole(const WholeRun& run, const Rows& rows, unsigned& lanes) noexcept {
  std::size_t i = 0;
  for (bool certain = true; certain && i < run.numbers.size();) {
    switch (nth(run.blocks, run.numbers[i]).axis) {
      case 0:
        certain = advance_along<0>(run, i, rows, lanes);
        break;
      case 1:
        certain = advance_along<1>(run, i, rows, lanes);
        break;
      case 2:
        certain = advance_along<2>(run, i, rows, lanes);
        break;
      case kSolidFaces:
        certain = advance_along<kSolidFaces>(run, i, rows, lanes);
        break;
      default:
        certain = advance_along<-1>(run, i, rows, lanes);
    }
  }
  return i;
}

}  // namespace voussoir::kernels
