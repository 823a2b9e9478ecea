// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "kernels/lanes.h"
#include "kernels/law.h"
#include "kernels/laws/crushing.h"
#include "kernels/rows.h"
#include "kernels/side.h"

/// Contact between a free patch (segments of one face that are in no joint) and other elements: paper 2.5, THEORY.md (17)-(21).
///
/// A contact point of A touches B when it is inside B. It has one partner at a time, kept until it has left. Its depth is measured to the
/// face of B chosen at first touch: the least penetrated one that opposes the patch (n_A·n_B < −0.5, or where no face of A does, as at a
/// corner sharper than a brick's, that which opposes most). A point that is deeper than kSlight under this one came in past an edge: it is
/// held by the face through which it just came. One that was inside before the step in which it is found begins with that depth as an
/// offset, hence without force. Of several partners one in which it is not deep is first, then the element that the patch was joined to,
/// then the one in which the point was deepest. What points do not see, solver/contact/overlap_contact.h does.
namespace voussoir::kernels {

inline constexpr double kSlight = 1e-3;    // m, deeper than this under a face no point is that just came through it or slid along it
inline constexpr double kOpposing = -0.5;  // cosine between the outward normals
inline constexpr double kAsMuch = 0.05;    // of such cosines, when two faces of a corner oppose alike
inline constexpr int kMostFaces = 65535;   // of one element: Patch::face_count has 16 bits
inline constexpr std::int32_t kNobody = -1;
inline constexpr std::int32_t kNoFace = -1;
inline constexpr std::int32_t kSeveralFaces = -2;
inline constexpr std::int32_t kUnknownFace = -3;
inline constexpr double kLookNow = -1e300;  // m, below every travel bound: the pair is looked at in the next step
inline constexpr double kRoundOff = 1e-9;   // m, far more than that of any distance between a point and a face

/// A face of an element in its body frame, centred at the centroid; the base has one (the plane z = 0 of its row). One cache line.
struct alignas(64) Face {
  Vec3 normal;                                    // outward
  double distance = 0.0;                          // m, ℓ
  double compliance_n = 0.0, compliance_s = 0.0;  // m/Pa, ℓ (1 − ν²)/E and 2 ℓ (1 + ν)/E; 0 for the ground
  double mass = 0.0;                              // kg/m2, ρ ℓ (Eq. 10); 0 for the ground
  std::int32_t material = 0;                      // of ContactOptions::friction

  /// Of the base or of a part of it: rigid, and without points of its own.
  [[nodiscard]] bool is_ground() const noexcept { return mass == 0.0; }
};

/// Constants of a free patch. Reference axes, from the centroid of its element.
struct Patch {
  std::int32_t element = 0, face = 0;
  std::int32_t origin = kNobody;                  // the element it was joined to, if it comes from a broken joint
  std::uint16_t face_number = 0, face_count = 0;  // of `face` among those of its element, which lie together; how many these are
  Vec3 centre, es, et;
  std::int32_t origin_face = -1;                        // of `origin`
  float normal_sign = 1.0F;                             // outward normal = sign · es × et (−1 for a slave's share of a merged side)
  double s_low = 0, s_high = 0, t_low = 0, t_high = 0;  // m, rectangle round its points
  double origin_kn = 0.0, origin_ks = 0.0;              // Pa/m, stiffness of the joint it comes from, against `origin_face`
};

/// Springs of kWidth points of a patch, which go through the kernel side by side: whole cache lines, so that a few points that touch cost
/// few.
struct alignas(64) PointSprings {
  double slip_x[kWidth] = {}, slip_y[kWidth] = {}, slip_z[kWidth] = {};  // m, elongation of the shear spring in A's body frame
  double closure[kWidth] = {};  // m, offset of the depth: of crushing, of a joint (see hand_over), or of a point that came round an edge
};

/// History of the points of a patch.
struct ContactPoints {
  std::int32_t* partner = nullptr;  // element, kNobody: free
  std::int32_t* face = nullptr;     // of the partner, in the table of faces; kNoFace: inside but carries no force
  PointSprings* springs = nullptr;
  double* crushed = nullptr;  // m, by point; nullptr: contacts bear any pressure

  /// Closure of a free point: by what it has been crushed.
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

/// An element that a patch may touch, and what is known of the pair, so that most steps need no look at its points.
struct Candidate {
  std::int32_t element = 0;
  std::int32_t first_face = 0, face_count = 0;  // into the table of faces
  // Points with this partner lie in [first, last); they push against `face` (kNoFace: none does; kUnknownFace, for all of a
  // patch or none: partners are to be listed).
  std::int32_t face = kUnknownFace, first = 0, last = 0;
  double safe = kLookNow;  // m, sum of both travel bounds below which no point can come in, or leave through another face than `face`
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
  // Points also meet the face through which they came, if it does not oppose theirs (see patch_work.h). false, where points lie on the
  // edges of their faces: such a point stands on the faces beside it too, whose own points carry it. It stays free, and whole bodies meet.
  bool crossed_faces = true;
  Crushing crushing{};
  double dashpot_excess = kBounded;  // or kUnbounded
};

/// What never changes of a body.
struct BodyConstants {
  Vec3 ref;           // m, centroid in the reference configuration
  double beta = 0.0;  // 1/s, bound on its damping rate (semi-implicit dashpots)
};

/// Everything about bodies that the kernel reads.
struct Bodies {
  const double* pose = nullptr;   // rows
  const double* twist = nullptr;  // rows
  const BodyConstants* constants = nullptr;
  const double* travel = nullptr;  // m, by body: upper bound on the path of any of its points since it was searched
};

/// Signed distance to a plane over a patch: g(s,t) = g0 + s·gs + t·gt, negative inside.
struct PlaneField {
  double g0, gs, gt;
  [[nodiscard]] double at(double s, double t) const noexcept { return g0 + s * gs + t * gt; }
};

struct PatchScratch {
  // Room for one value a point.
  double* depth = nullptr;
  std::int32_t* candidate = nullptr;
  std::int32_t* face = nullptr;
  PlaneField* planes = nullptr;  // room for one value a face of the element that has most
};

struct PatchResult {
  double stored = 0.0, friction = 0.0, impact = 0.0, fracture = 0.0;  // J
  int touching = 0;                                                   // points with a partner after the step
};

/// Depth u_n [m] (negative: inside) of the point (s, t) of a patch under a face of another element, along the normal that the law uses.
double depth_under_face(const Patch& patch, double s, double t, std::int32_t slave, std::int32_t face, const Bodies& bodies,
                        const Face* faces, const ContactOptions& o) noexcept;

/// One step of one patch against its candidates. `wrench[k]` and `active[k]` are set for each candidate (active 0: wrench not written).
/// \param touching  points that have a partner from the last step
/// \pre  there is a candidate, and since it was new no travel bound has become smaller
/// \pre  histories of the points are padded to kLanes with points that have no partner
using AdvancePatch = PatchResult(const Patch& patch, PointsView points, ContactPoints q, int touching, std::span<Candidate> candidates,
                                 const Bodies& bodies, const Face* faces, const ContactOptions& o, PatchScratch scratch, PairWrench* wrench,
                                 std::uint8_t* active) noexcept;
AdvancePatch advance_patch;            // several points at a time, and no look at those that cannot have come in or left
AdvancePatch advance_patch_reference;  // the plain twin: looks at every point, and leaves what candidates know alone

/// True if nothing of the pair can have changed and it pushes nowhere: a patch of which this holds for all candidates needs no step.
inline bool quiet(const Candidate& c, double travel_of_patch, double travel_of_candidate) noexcept {
  return c.face == kNoFace && travel_of_patch + travel_of_candidate < c.safe;
}

}  // namespace voussoir::kernels
