// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/nth.h"
#include "kernels/contact/contact_patch.h"
#include "kernels/laws/crushing.h"
#include "kernels/laws/restitution.h"

/// Parts shared by the kernel of free patches and its plain twin: geometry of a patch against a candidate, and the choice of partners.
namespace voussoir::kernels {

/// The patch in the body frame of a candidate: y(s,t) = y0 + s·ys + t·yt, relative to the candidate's centroid.
struct InSlave {
  Vec3 y0, ys, yt, normal;
};

struct Master {
  Pose pose;
  Twist twist;
  Vec3 ref, centre, es, et, normal;  // ref: reference centroid [m]; centre: relative to it, displaced [m]; current axes
};

inline Vec3 apply(const Pose& p, Vec3 r) noexcept { return r + p.d * r; }
inline Vec3 apply_transposed(const Pose& p, Vec3 r) noexcept { return r + transposed(p.d) * r; }
inline Vec3 reference(const Bodies& b, std::int32_t e) noexcept { return b.constants[e].ref; }

inline Master master_of(const Patch& p, const Bodies& b) noexcept {
  Master m;
  m.pose = load_pose(b.pose, p.element);
  m.twist = load_twist(b.twist, p.element);
  m.ref = reference(b, p.element);
  m.centre = m.pose.u + apply(m.pose, p.centre);
  m.es = apply(m.pose, p.es);
  m.et = apply(m.pose, p.et);
  m.normal = p.normal_sign * cross(m.es, m.et);
  return m;
}

inline InSlave in_slave(const Master& m, const Pose& slave, Vec3 slave_ref) noexcept {
  const Vec3 from = (m.ref - slave_ref) + (m.centre - slave.u);
  return {apply_transposed(slave, from), apply_transposed(slave, m.es), apply_transposed(slave, m.et), apply_transposed(slave, m.normal)};
}

inline PlaneField plane_field(const InSlave& y, const Face* faces, int face) noexcept {
  const Vec3 n = faces[face].normal;
  return {dot(n, y.y0) - faces[face].distance, dot(n, y.ys), dot(n, y.yt)};
}

/// Least distance to a plane over the rectangle of the patch [m].
inline double least_distance(const Patch& p, PlaneField g) noexcept {
  const double s = g.gs > 0.0 ? p.s_low : p.s_high, t = g.gt > 0.0 ? p.t_low : p.t_high;
  return g.at(s, t);
}

/// Greatest distance [m] that any one face of the candidate keeps to the whole patch; negative: no face separates the two.
inline double separation(const Patch& p, const InSlave& y, const Face* faces, const Candidate& c) noexcept {
  double most = -1e300;
  for (int f = c.first_face; f < c.first_face + c.face_count; ++f) most = std::max(most, least_distance(p, plane_field(y, faces, f)));
  return most;
}

/// Signed distances of the patch to all faces of a candidate.
struct PlaneFields {
  const PlaneField* g = nullptr;
  int count = 0;
};
inline PlaneFields plane_fields(const InSlave& y, const Face* faces, const Candidate& c, PlaneField* room) noexcept {
  for (int f = 0; f < c.face_count; ++f) room[f] = plane_field(y, faces, c.first_face + f);
  return {room, c.face_count};
}

/// Whether the patch opposes a face of another element: the normals oppose well enough (kOpposing), or no face of the patch's element
/// opposes that face better. Without the second rule a corner sharper than a brick's would find no hold, and sink.
inline bool opposes(const Patch& p, const Master& m, const InSlave& y, const Pose& slave, std::int32_t face, const Face* faces) noexcept {
  const double own = dot(y.normal, faces[face].normal);
  if (own < kOpposing) return true;
  if (own >= 0.0) return false;
  const Vec3 other = apply_transposed(m.pose, apply(slave, faces[face].normal));
  double least = own;
  for (int k = 0; k < p.face_count; ++k) least = std::min(least, dot(faces[p.face - p.face_number + k].normal, other));
  return least >= kOpposing && own <= least + kAsMuch;
}

/// The least penetrated face that opposes the patch; kNoFace if there is none.
inline std::int32_t entry_face(double s, double t, const Patch& p, const Master& m, const InSlave& y, const Pose& slave,
                               const PlaneFields& planes, const Face* faces, const Candidate& c) noexcept {
  std::int32_t best = kNoFace;
  double depth = 1e300;
  for (int f = 0; f < planes.count; ++f) {
    const double d = -planes.g[f].at(s, t);
    if (d < depth && opposes(p, m, y, slave, c.first_face + f, faces)) {
      depth = d;
      best = c.first_face + f;
    }
  }
  return best;
}

inline void release(ContactPoints q, int i) noexcept {
  q.partner[i] = kNobody;
  q.face[i] = kNoFace;
  q.set_slip(i, {});
  q.closure(i) = q.recess(i);
  if (q.pressed != nullptr) q.pressed[i] = 0.0;
}

/// Stiffness and damping between the patch and one face: Eqs. 2, 9, 10, THEORY.md (4), (20).
inline Stiffness stiffness(const Patch& p, std::int32_t slave, int face, const Bodies& b, const Face* t, const ContactOptions& o) noexcept {
  Stiffness k;
  if (slave == p.origin && face == p.origin_face) {
    k.kn = p.origin_kn, k.ks = p.origin_ks;
  } else {
    k.kn = 1.0 / (t[p.face].compliance_n + t[face].compliance_n);
    k.ks = 1.0 / (t[p.face].compliance_s + t[face].compliance_s);
  }
  const bool ground = t[face].is_ground();
  const double mass = t[p.face].mass + (ground ? t[p.face].mass : t[face].mass);
  const double beta = b.constants[p.element].beta + b.constants[ground ? p.element : slave].beta;
  const double f = 2.0 * o.damping / (1.0 + o.step * beta);
  k.cn = f * std::sqrt(mass * k.kn);
  k.cs = f * std::sqrt(mass * k.ks);
  return k;
}

/// The pair of a patch and one face, with all quantities that its points need.
struct Facing {
  Vec3 n;            // direction of u_n: outward from the patch (−n_B, or n_A under master_normal)
  PlaneField depth;  // u_n(s,t) [m], negative inside
  Vec3 v0, vs, vt;   // m/s, 1/s, 1/s: velocity of the slave relative to the master, v0 + s·vs + t·vt
  Stiffness k;
  double tan_phi = 0.0, factor = 0.5;
  double excess = kBounded;  // ContactOptions::dashpot_excess
};

inline Facing facing(const Patch& p, const Master& m, const InSlave& y, const Candidate& c, int face, const Bodies& b, const Face* faces,
                     const ContactOptions& o) noexcept {
  const Pose slave = load_pose(b.pose, c.element);
  const Twist twist = load_twist(b.twist, c.element);
  const Vec3 nb = apply(slave, faces[face].normal);
  const PlaneField g = plane_field(y, faces, face);
  Facing f;
  // Under `master` the point is pushed along the normal of its own face, by the distance to B's face along that normal.
  // Faces that hardly oppose each other have no such distance, so the normal of B is used for them.
  const double opposed = -dot(m.normal, nb);
  const bool along_own = o.master_normal && opposed > -kOpposing;
  const double stretch = along_own ? 1.0 / opposed : 1.0;
  f.n = along_own ? m.normal : -nb;
  f.depth = {stretch * g.g0, stretch * g.gs, stretch * g.gt};
  const Vec3 arm_a = m.centre - m.pose.u;
  const Vec3 arm_b = (m.ref - reference(b, c.element)) + (m.centre - slave.u);
  const Vec3 w = twist.w - m.twist.w;
  f.v0 = (twist.v + cross(twist.w, arm_b)) - (m.twist.v + cross(m.twist.w, arm_a));
  f.vs = cross(w, m.es);
  f.vt = cross(w, m.et);
  f.k = stiffness(p, c.element, face, b, faces, o);
  f.tan_phi = o.friction.of(faces[p.face].material, faces[face].material);
  f.excess = o.dashpot_excess;
  f.factor = faces[face].is_ground() ? 1.0 : 0.5;  // Eq. 11: both bodies are masters, but the ground has no segments
  return f;
}

/// Counts the energy left in the springs of a point that opened in this step as lost (trapezoid rule, as in advance_segment).
inline void record_opening(const Facing& f, const Pose& master, double s, double t, double area, ContactPoints q, int i, double step,
                           PatchResult& r) noexcept {
  const double un = f.depth.at(s, t) - q.closure(i);
  const Vec3 v = f.v0 + s * f.vs + t * f.vt;
  const double vn = dot(v, f.n);
  const double before = std::min(0.0, un - step * vn);
  const Vec3 slip = apply(master, q.slip(i));
  const double da = f.factor * area;
  r.impact += 0.5 * da * f.k.kn * (before * before + before * step * vn);
  r.friction += 0.5 * da * f.k.ks * (dot(slip, slip) + step * dot(slip, v - vn * f.n));
}

/// Crushes point i, which touches, as far as its pressure exceeds its strength, before the law of contact is applied
/// (kernels/laws/crushing.h).
inline void crush_point(const Facing& f, double s, double t, double area, ContactPoints q, int i, const ContactOptions& o,
                        PatchResult& r) noexcept {
  const double xn = f.depth.at(s, t) - q.closure(i), by = crushed_further(xn, q.crushed[i], f.k.kn, o.crushing);
  if (by == 0.0) return;
  const double du = o.step * dot(f.v0 + s * f.vs + t * f.vt, f.n);
  r.fracture += f.factor * area * lost_by_crushing(xn, by, du, f.k.kn);
  q.crushed[i] += by;
  q.closure(i) -= by;
}

/// Updates the indentation of point i, which touches, and moves its closure by the change, before the law of contact is applied
/// (kernels/laws/restitution.h). The closure recovers no farther than to that of a free point; a point from a joint may begin beyond it.
/// \return whether the normal dashpot of the point acts: the point closes and has been deeper
inline bool press_point(const Facing& f, double s, double t, double area, ContactPoints q, int i, const ContactOptions& o,
                        PatchResult& r) noexcept {
  const double depth = f.depth.at(s, t), xn = depth - q.closure(i), before = q.pressed[i], p = before - xn;
  const double vn = dot(f.v0 + s * f.vs + t * f.vt, f.n);
  const bool deeper = was_deeper(p, before, o.restitution);
  q.pressed[i] = pressed_at(p, before, o.restitution);
  const double by = std::max(q.pressed[i] - before, std::min(0.0, q.closure(i) - q.recess(i)));
  if (by != 0.0) {
    r.impact += f.factor * area * lost_by_crushing(xn, by, o.step * vn, f.k.kn);
    q.closure(i) -= by;
  }
  return deeper && vn < 0.0 && xn + by < 0.0;
}

/// Data shared by all passes of one advance_patch call.
struct Work {
  const Patch& patch;
  PointsView points;
  ContactPoints q;
  std::span<Candidate> candidates;
  const Bodies& bodies;
  const Face* faces;
  const ContactOptions& o;
  PatchScratch scratch;
  Master m;
  PatchResult r;
  bool looked = false;   // `scratch.candidate` is set
  bool noted = false;    // some free point has a new partner in `scratch`
  bool changed = false;  // some point has changed its partner
};

inline InSlave slave_frame(const Work& w, const Candidate& c) noexcept {
  return in_slave(w.m, load_pose(w.bodies.pose, c.element), reference(w.bodies, c.element));
}

/// The face of a candidate that holds a free point inside the candidate.
struct Entry {
  std::int32_t face = kNoFace;
  double depth = 0.0;  // m, under the face at the beginning of the step; above 0: inside
};

/// Whether the entry has no face, or lies deeper than kSlight under it.
inline bool is_deep(const Entry& e) noexcept { return e.face == kNoFace || e.depth > kSlight; }

/// The face through which point i came into candidate c in this step, the last one if it crossed several; kNoFace: none.
inline std::int32_t crossed_face(const Work& w, const Candidate& c, const InSlave& y, const PlaneFields& planes, int i) noexcept {
  const double s = w.points.s[i], t = w.points.t[i];
  const Pose slave = load_pose(w.bodies.pose, c.element);
  const Facing f = facing(w.patch, w.m, y, c, c.first_face, w.bodies, w.faces, w.o);
  const Vec3 v = apply_transposed(slave, f.v0 + s * f.vs + t * f.vt);  // velocity relative to the point, in the candidate's body axes
  std::int32_t last = kNoFace;
  double ago = w.o.step;
  for (int k = 0; k < planes.count; ++k) {
    const double speed = dot(v, w.faces[c.first_face + k].normal);  // inward, through the face
    const double depth = -planes.g[k].at(s, t);
    if (speed <= 0.0 || depth > ago * speed) continue;
    ago = depth / speed;
    last = c.first_face + k;
  }
  return last;
}

/// The least penetrated face with a normal component against the patch; kNoFace if there is none.
inline std::int32_t nearest_face(double s, double t, const InSlave& y, const PlaneFields& planes, const Face* faces,
                                 const Candidate& c) noexcept {
  std::int32_t best = kNoFace;
  double depth = 1e300;
  for (int f = 0; f < planes.count; ++f) {
    const double d = -planes.g[f].at(s, t);
    if (d >= depth || dot(y.normal, faces[c.first_face + f].normal) >= 0.0) continue;
    depth = d;
    best = c.first_face + f;
  }
  return best;
}

/// Depth of point i under a face of candidate c.
inline Entry entry_under(const Work& w, const Candidate& c, const InSlave& y, std::int32_t face, int i) noexcept {
  if (face == kNoFace) return {};
  const double s = w.points.s[i], t = w.points.t[i];
  const Facing f = facing(w.patch, w.m, y, c, face, w.bodies, w.faces, w.o);
  const double taken = std::min(0.0, w.o.step * dot(f.v0 + s * f.vs + t * f.vt, f.n));
  return {face, taken - f.depth.at(s, t)};
}

/// The face of candidate c that holds point i: one that opposes the patch and under which the point is not deep; else the face through
/// which the point has just come; else the least penetrated one that opposes the patch, or, if none does, that faces against it at all.
/// Without ContactOptions::crossed_faces only the first of these.
inline Entry entry_of(const Work& w, const Candidate& c, const InSlave& y, const PlaneFields& planes, int i) noexcept {
  const double s = w.points.s[i], t = w.points.t[i];
  const Pose slave = load_pose(w.bodies.pose, c.element);
  const std::int32_t opposing = entry_face(s, t, w.patch, w.m, y, slave, planes, w.faces, c);
  const Entry e = entry_under(w, c, y, opposing, i);
  if (!is_deep(e)) return e;
  if (!w.o.crossed_faces) return {};
  const std::int32_t crossed = crossed_face(w, c, y, planes, i);
  if (crossed != kNoFace) return entry_under(w, c, y, crossed, i);
  return opposing != kNoFace ? e : entry_under(w, c, y, nearest_face(s, t, y, planes, w.faces, c), i);
}

/// Whether candidate k has precedence over `other` for a free point that both claim: one in which the point is not deep before one in which
/// it is, and the latter before one without a face; then the element that the patch was joined to, then the one in which the point was
/// deeper.
inline bool has_more_claim(const Work& w, std::int32_t k, const Entry& e, std::int32_t other, const Entry& than) noexcept {
  const auto rank = [](const Entry& x) { return x.face == kNoFace ? 0 : is_deep(x) ? 1 : 2; };
  if (rank(e) != rank(than)) return rank(e) > rank(than);
  if (e.face == kNoFace) return false;
  const auto is_origin = [&](std::int32_t c) { return nth(w.candidates, c).element == w.patch.origin; };
  if (is_origin(k) != is_origin(other)) return is_origin(k);
  return e.depth > than.depth;
}

/// Updates a point that is free or touches candidate k: releases the point if it leaves, or notes candidate k as its partner if no other
/// has precedence so far. `in`: the point is inside the candidate, or stays with it.
inline void look_at_point(Work& w, std::int32_t k, const InSlave& y, const PlaneFields& planes, int i, bool in) noexcept {
  const Candidate& c = nth(w.candidates, k);
  if (w.q.partner[i] == c.element) {
    if (in) return;
    if (w.q.face[i] != kNoFace) {
      record_opening(facing(w.patch, w.m, y, c, w.q.face[i], w.bodies, w.faces, w.o), w.m.pose, w.points.s[i], w.points.t[i],
                     w.points.area[i], w.q, i, w.o.step, w.r);
    }
    release(w.q, i);
    w.changed = true;
  } else if (in) {
    const Entry e = entry_of(w, c, y, planes, i);
    if (e.face == kNoFace && !w.o.crossed_faces) return;  // left free for another body
    const std::int32_t other = w.scratch.candidate[i];
    if (other >= 0 && !has_more_claim(w, k, e, other, {w.scratch.face[i], w.scratch.depth[i]})) return;
    w.scratch.candidate[i] = k;
    w.scratch.face[i] = e.face;
    w.scratch.depth[i] = e.depth;
    w.noted = true;
  }
}

/// Gives free points the partners found for them. A point that was inside before this step keeps that depth as an offset: its springs begin
/// without force, so that they return no more energy than they took.
inline void take_partners(Work& w) noexcept {
  for (int i = 0; i < w.points.n; ++i) {
    const std::int32_t k = w.scratch.candidate[i];
    if (k < 0 || w.q.partner[i] != kNobody) continue;
    w.q.partner[i] = nth(w.candidates, k).element;
    w.q.face[i] = w.scratch.face[i];
    w.changed = true;
    if (w.q.face[i] != kNoFace) w.q.closure(i) = std::min(w.q.recess(i), -w.scratch.depth[i]);
  }
}

/// Sums of tractions in global axes.
struct GlobalSums {
  Vec3 f, sf, tf;
  void add(Vec3 v, double s, double t) noexcept {
    f += v;
    sf += s * v;
    tf += t * v;
  }
};

inline void write_wrench(const Master& m, Vec3 arm_b, const GlobalSums& total, const GlobalSums& dash, PairWrench& w) noexcept {
  const Vec3 arm_a = m.centre - m.pose.u;
  const auto moment = [&](const GlobalSums& g) { return cross(m.es, g.sf) + cross(m.et, g.tf); };
  const Vec3 mt = moment(total), md = moment(dash);
  w.force = total.f;
  w.torque_a = cross(arm_a, total.f) + mt;
  w.torque_b = -(cross(arm_b, total.f) + mt);
  w.dash_force = dash.f;
  w.dash_torque_a = cross(arm_a, dash.f) + md;
  w.dash_torque_b = -(cross(arm_b, dash.f) + md);
}

}  // namespace voussoir::kernels
