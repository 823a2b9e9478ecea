// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "kernels/lanes.h"
#include "kernels/law.h"
#include "kernels/laws/laws_of_side.h"
#include "kernels/rows.h"
#include "kernels/side.h"

/// Contact between a free patch (segments of one face that are in no joint) and other elements: paper 2.5, THEORY.md (17)-(21).
///
/// A contact point of A touches B when it is inside B. It has one partner at a time, kept until the point has left. Its depth is measured
/// to the face of B chosen at first touch: the least penetrated face that opposes the patch (n_A·n_B < −0.5; at corners sharper than a
/// brick's also a face that no face of A opposes so well, if this patch opposes it most). A point deeper than kSlight under this face came
/// in past an edge, and is held by the face through which it just came. A point that was inside before the step in which it is found begins
/// with its depth as an offset, hence without force. Among several partners, one in which the point is not deep comes first, then the
/// element that the patch was joined to, then the one in which the point was deepest. Contact that points miss (edges across edges) is
/// found by solver/contact/overlap_contact.h.
namespace voussoir::kernels {

inline constexpr double kSlight = 1e-3;    // m, depth above which a point did not just come through a face or slide along it
inline constexpr double kOpposing = -0.5;  // cosine between the outward normals
inline constexpr double kAsMuch = 0.05;    // difference of cosines below which two faces of a corner oppose alike
inline constexpr int kMostFaces = 65535;   // of one element, since Patch::face_count has 16 bits
inline constexpr std::int32_t kNobody = -1;
inline constexpr std::int32_t kNoFace = -1;
inline constexpr std::int32_t kSeveralFaces = -2;
inline constexpr std::int32_t kUnknownFace = -3;
inline constexpr double kLookNow = -1e300;  // m, below every travel bound: the pair is tested in the next step
inline constexpr double kRoundOff = 1e-9;   // m, far above the round-off of any distance between a point and a face

/// A face of an element in its body frame, centred at the centroid; the base has one face (the plane z = 0 of its row). One cache line.
struct alignas(64) Face {
  Vec3 normal;                                    // outward
  double distance = 0.0;                          // m, ℓ
  double compliance_n = 0.0, compliance_s = 0.0;  // m/Pa, ℓ (1 − ν²)/E and 2 ℓ (1 + ν)/E; 0 for the ground
  double mass = 0.0;                              // kg/m2, ρ ℓ (Eq. 10); 0 for the ground
  std::int32_t material = 0;                      // index into ContactOptions::friction

  /// Whether the face is of the base or of a part of the base: rigid, and without points.
  [[nodiscard]] bool is_ground() const noexcept { return mass == 0.0; }
};

/// Constants of a free patch. Reference axes, relative to the centroid of its element.
struct Patch {
  std::int32_t element = 0, face = 0;
  std::int32_t origin = kNobody;                  // element that the patch was joined to, if it comes from a broken joint
  std::uint16_t face_number = 0, face_count = 0;  // number of `face` among the consecutive faces of its element, and their count
  Vec3 centre, es, et;
  std::int32_t origin_face = -1;                        // face of `origin` that the patch was joined to
  float normal_sign = 1.0F;                             // outward normal = sign · es × et (−1 for the slave's share of a merged side)
  double s_low = 0, s_high = 0, t_low = 0, t_high = 0;  // m, bounding rectangle of its points
  double origin_kn = 0.0, origin_ks = 0.0;              // Pa/m, stiffness of the joint that the patch comes from, against `origin_face`
};

/// Springs of kWidth points of a patch, processed together. Whole cache lines, so that a few touching points cost few lines.
struct alignas(64) PointSprings {
  double slip_x[kWidth] = {}, slip_y[kWidth] = {}, slip_z[kWidth] = {};  // m, elongation of the shear spring in A's body frame
  double closure[kWidth] = {};  // m, offset of the depth: by crushing, from a joint (see hand_over), or of a point that came past an edge
};

/// History of the points of a patch.
struct ContactPoints {
  std::int32_t* partner = nullptr;  // element, kNobody: free
  std::int32_t* face = nullptr;     // index in the table of faces, of the partner; kNoFace: inside but carries no force
  PointSprings* springs = nullptr;
  double* crushed = nullptr;  // m, by point, crushed depth; nullptr: contacts bear any pressure
  double* pressed = nullptr;  // m, by point, indentation (kernels/laws/restitution.h); nullptr: contact.restitution is off

  /// Closure of a free point [m]: minus its crushed depth.
  [[nodiscard]] double recess(int i) const noexcept { return crushed == nullptr ? 0.0 : -crushed[i]; }
  [[nodiscard]] PointSprings& springs_at(int i) const noexcept { return springs[i / kWidth]; }
  [[nodiscard]] double& closure(int i) const noexcept { return springs_at(i).closure[i % kWidth]; }
  [[nodiscard]] Vec3 slip(int i) const noexcept {
    const PointSprings& k = springs_at(i);
    const int l = i % kWidth;
    return {k.slip_x[l], k.slip_y[l], k.slip_z[l]};
  }
  void set_slip(int i, Vec3 x) const noexcept {
    PointSprings& k = springs_at(i);
    const int l = i % kWidth;
    k.slip_x[l] = x.x, k.slip_y[l] = x.y, k.slip_z[l] = x.z;
  }
};

/// An element that a patch may touch, and cached knowledge of the pair, so that most steps need not visit the points.
struct Candidate {
  std::int32_t element = 0;
  std::int32_t first_face = 0, face_count = 0;  // range in the table of faces
  // Points with this partner lie in [first, last) and push against `face` (kNoFace: none does; kUnknownFace: set for all candidates of a
  // patch or for none, partners must be listed).
  std::int32_t face = kUnknownFace, first = 0, last = 0;
  double safe = kLookNow;  // m, sum of both travel bounds below which no point can come in, or leave through a face other than `face`
};

/// tan φ of all pairs of materials (Eq. 8), a square table.
struct FrictionTable {
  const double* tan_phi = nullptr;
  std::int32_t materials = 0;

  [[nodiscard]] double of(std::int32_t a, std::int32_t b) const noexcept { return tan_phi[a * materials + b]; }
};

struct ContactOptions {
  double step = 0.0;     // s
  double damping = 1.0;  // h_n = h_s
  FrictionTable friction;
  bool master_normal = false;  // contact.normal = master
  // Whether points also meet the face through which they came, if it does not oppose their own face (see patch_work.h). false where points
  // lie on the edges of their faces: such a point lies on the adjacent faces too, whose own points carry it. Such a point stays free, and
  // the whole bodies are in contact.
  bool crossed_faces = true;
  Crushing crushing{};
  double dashpot_excess = kBounded;  // kBounded or kUnbounded
  double restitution = 0.0;          // of free bodies; 0: that of the dashpots
};

/// Constants of a body.
struct BodyConstants {
  Vec3 ref;           // m, centroid in the reference configuration
  double beta = 0.0;  // 1/s, bound on the damping rate of the body (semi-implicit dashpots), as its contacts are now
};

/// All data of bodies that the kernel reads.
struct Bodies {
  const double* pose = nullptr;   // rows
  const double* twist = nullptr;  // rows
  const BodyConstants* constants = nullptr;
  const double* travel = nullptr;  // m, by body: upper bound on the path of any of its points since contacts of the body were searched
};

/// Signed distance to a plane over a patch [m]: g(s,t) = g0 + s·gs + t·gt, negative inside.
struct PlaneField {
  double g0, gs, gt;
  [[nodiscard]] double at(double s, double t) const noexcept { return g0 + s * gs + t * gt; }
};

struct PatchScratch {
  // Space for one value per point.
  double* depth = nullptr;
  std::int32_t* candidate = nullptr;
  std::int32_t* face = nullptr;
  PlaneField* planes = nullptr;  // space for one value per face of the element with most faces
};

struct PatchResult {
  double stored = 0.0, friction = 0.0, impact = 0.0, fracture = 0.0;  // J
  int touching = 0;                                                   // points with a partner after the step
};

/// Displacement u_n [m] (negative: inside) of the point (s, t) of a patch under a face of another element, along the normal that the law
/// uses.
double depth_under_face(const Patch& patch, double s, double t, std::int32_t slave, std::int32_t face, const Bodies& bodies,
                        const Face* faces, const ContactOptions& o) noexcept;

/// Advances one patch by one step against its candidates. `wrench[k]` and `active[k]` are set for each candidate (active 0: wrench not
/// written).
/// \param touching  number of points with a partner after the last step
/// \pre there is a candidate, and no travel bound has decreased since the candidate was new
/// \pre histories of the points are padded to kLanes with points that have no partner
using AdvancePatch = PatchResult(const Patch& patch, PointsView points, ContactPoints q, int touching, std::span<Candidate> candidates,
                                 const Bodies& bodies, const Face* faces, const ContactOptions& o, PatchScratch scratch, PairWrench* wrench,
                                 std::uint8_t* active) noexcept;
AdvancePatch advance_patch;            // several points at a time; skips points that cannot have come in or left
AdvancePatch advance_patch_reference;  // the plain twin: visits every point and does not use cached knowledge of candidates

/// Whether the pair exerts no force and cannot have changed: a patch of which this holds for all candidates needs no step.
inline bool quiet(const Candidate& c, double travel_of_patch, double travel_of_candidate) noexcept {
  return c.face == kNoFace && travel_of_patch + travel_of_candidate < c.safe;
}

}  // namespace voussoir::kernels
