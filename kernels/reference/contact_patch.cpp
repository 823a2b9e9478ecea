// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/nth.h"
#include "kernels/contact/patch_work.h"
#include "kernels/laws/contact_law.h"

namespace voussoir::kernels {

namespace {

/// Traction of one touching point; updates its slip.
void touch(const Facing& f, const Pose& master, double s, double t, double area, ContactPoints q, int i, double step, GlobalSums& total,
           GlobalSums& dash, PatchResult& r) noexcept {
  const double xn = f.depth.at(s, t) - q.closure(i);
  if (xn >= 0.0) {  // inside, but above its offset
    record_opening(f, master, s, t, area, q, i, step, r);
    q.set_slip(i, {});
    return;
  }
  const Vec3 v = f.v0 + s * f.vs + t * f.vt;
  const ContactStep c = advance_contact(xn, f.n, v, apply(master, q.slip(i)), f.k, f.tan_phi, step, f.excess);
  const double da = f.factor * area, vn = dot(v, f.n);
  const Vec3 x = c.spring, vt = v - vn * f.n;
  total.add(da * (c.elastic + c.dashpot), s, t);
  dash.add(da * c.dashpot, s, t);
  q.set_slip(i, apply_transposed(master, x));
  const double xn_before = std::min(0.0, xn - step * vn);
  r.stored += 0.5 * da * (f.k.kn * xn * xn + f.k.ks * dot(x, x));
  r.friction += 0.5 * da * f.k.ks * (dot(c.before, c.before) - dot(x, x) + step * dot(c.before + x, vt));
  r.impact += 0.5 * da * f.k.kn * (xn_before * xn_before - xn * xn + (xn_before + xn) * step * vn);
}

/// Signed distance of a point from the candidate, the greatest over its faces [m]: negative inside.
double distance(const PlaneFields& planes, double s, double t) noexcept {
  double most = -1e300;
  for (int f = 0; f < planes.count; ++f) most = std::max(most, planes.g[f].at(s, t));
  return most;
}

/// Whether a point stays with the candidate that it touches: inside all its faces but the touched one, and outside the touched face by no
/// more than the point's offset.
bool stays(const Work& w, const Candidate& c, const PlaneFields& planes, int i) noexcept {
  for (int f = 0; f < planes.count; ++f) {
    const bool own = c.first_face + f == w.q.face[i];
    if (planes.g[f].at(w.points.s[i], w.points.t[i]) >= (own ? std::max(0.0, w.q.closure(i)) : 0.0)) return false;
  }
  return true;
}

/// Tests all points against candidate k.
void look_at(Work& w, std::int32_t k, const InSlave& y, bool apart) noexcept {
  const Candidate& c = nth(w.candidates, k);
  const PlaneFields planes = plane_fields(y, w.faces, c, w.scratch.planes);
  for (int i = 0; i < w.points.n; ++i) {
    if (w.q.partner[i] == c.element) {
      look_at_point(w, k, y, planes, i, stays(w, c, planes, i));
    } else if (w.q.partner[i] == kNobody) {
      look_at_point(w, k, y, planes, i, !apart && distance(planes, w.points.s[i], w.points.t[i]) < 0.0);
    }
  }
}

/// Forces of all points that touch candidate k. Returns whether any point carries force.
bool evaluate(Work& w, std::int32_t k, PairWrench& wrench) noexcept {
  const Candidate& c = nth(w.candidates, k);
  int first = 0;
  while (first < w.points.n && w.q.partner[first] != c.element) ++first;
  if (first == w.points.n) return false;
  const InSlave y = slave_frame(w, c);
  GlobalSums total, dash;
  Facing f{};
  std::int32_t face = kNoFace;
  for (int i = first; i < w.points.n; ++i) {
    if (w.q.partner[i] != c.element) continue;
    ++w.r.touching;
    if (w.q.face[i] == kNoFace) continue;
    if (w.q.face[i] != face) {
      face = w.q.face[i];
      f = facing(w.patch, w.m, y, c, face, w.bodies, w.faces, w.o);
    }
    if (w.q.crushed != nullptr) crush_point(f, w.points.s[i], w.points.t[i], w.points.area[i], w.q, i, w.o, w.r);
    const double cn = f.k.cn;
    if (w.q.pressed != nullptr && !press_point(f, w.points.s[i], w.points.t[i], w.points.area[i], w.q, i, w.o, w.r)) f.k.cn = 0.0;
    touch(f, w.m.pose, w.points.s[i], w.points.t[i], w.points.area[i], w.q, i, w.o.step, total, dash, w.r);
    f.k.cn = cn;
  }
  if (face == kNoFace) return false;
  const Vec3 arm_b = (w.m.ref - reference(w.bodies, c.element)) + (w.m.centre - load_pose(w.bodies.pose, c.element).u);
  write_wrench(w.m, arm_b, total, dash, wrench);
  return true;
}

}  // namespace

PatchResult advance_patch_reference(const Patch& patch, PointsView points, ContactPoints q, int touching, std::span<Candidate> candidates,
                                    const Bodies& bodies, const Face* faces, const ContactOptions& o, PatchScratch scratch,
                                    PairWrench* wrench, std::uint8_t* active) noexcept {
  Work w{patch, points, q, candidates, bodies, faces, o, scratch, master_of(patch, bodies), {}};
  std::fill_n(scratch.candidate, points.n, -1);
  const auto count = static_cast<std::int32_t>(candidates.size());
  for (std::int32_t k = 0; k < count; ++k) {
    const Candidate& c = nth(candidates, k);
    const InSlave y = slave_frame(w, c);
    const bool apart = separation(patch, y, faces, c) >= 0.0;
    if (!apart || touching > 0) look_at(w, k, y, apart);
  }
  take_partners(w);
  for (std::int32_t k = 0; k < count; ++k) active[k] = evaluate(w, k, wrench[k]) ? 1 : 0;
  return w.r;
}

}  // namespace voussoir::kernels
