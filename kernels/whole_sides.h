// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "kernels/side.h"

/// Whole sides in closed form (THEORY.md (16)) with as few operations as possible, for undamaged blocks: most of an intact building, in
/// every step. Constants are brought into the form in which they are used, tangents are principal axes of the points, and where the normals
/// of all sides of a block lie along one axis, tangents are columns of the rows and need no product.
/// The plain form, for blocks of any kind: kernels/certificate.h.
namespace voussoir::kernels {

/// Constants of kLanes whole sides. Unused lanes give no force.
struct alignas(64) WholeConstants {
  double ca[3][kLanes], cb[3][kLanes];      // m, from the centroids of master and slave to the centre of the side
  double force[kLanes];                     // N/m, k̄_s Σ dA
  double about_s[kLanes], about_t[kLanes];  // N m, ½ k̄_s Σ s² dA, ½ k̄_s Σ t² dA: weights of a tangent, not of an axis
  double normal[kLanes];                    // ¼ (k̄_n − k̄_s) / k̄_s
  double reach_s[kLanes], reach_t[kLanes];  // m, largest |s| and |t|
  // Limits of the bound, slightly inside those of the law: twice u_n along the normal of the kernel and against it [m]; a third of |u_s|²
  // [m2].
  double forward[kLanes], backward[kLanes], slide2[kLanes];
  // Tangents; share of the slave in mean tangents and point of action; whether the normal turns (0: on the base, THEORY.md (10a)).
  double es[3][kLanes], et[3][kLanes], mean[kLanes], normal_turns[kLanes];
  double twist[kLanes];  // Side::twist
  int axis;  // 0, 1, 2: every side acts at the midpoint, its normal lies along this axis and its tangents along the next two; −1: any
             // block; kSolidFaces
};

/// The axis of the normal of a side whose tangents lie along the other two axes; −1: none. Sides of one axis belong in one block.
int axis_of_side(Vec3 es, Vec3 et) noexcept;

/// Constants of a block of whole sides. \param on_base  bit mask: the slave is the base
WholeConstants whole_constants(const SideConstants& sides, unsigned on_base) noexcept;

inline void set_whole(SideBlock& block, const WholeConstants& c) noexcept { block.whole = &c, block.axis = c.axis; }

/// A sequence of blocks whose live sides are all whole.
struct WholeRun {
  const SideBlock* blocks = nullptr;
  const std::uint8_t* live_lanes = nullptr;  // by block: bit mask of the lanes that take part
  std::span<const std::int32_t> numbers;     // of the blocks
  std::int64_t first_side = 0;               // number of the first side of block 0
  std::span<const std::int32_t> prefetch;    // blocks whose constants are prefetched: the i-th with the i-th of the run
};

/// Whether the bound of `advance_whole` holds under these options: it takes c for the least shear limit in tension.
inline bool has_short_form(FailureOptions o) noexcept { return o.in_tension != ShearInTension::coulomb; }

/// Advances the blocks of a run by one step, up to the first side for which the bound does not prove that it stays whole: adds the forces
/// to the elements' rows.
/// \param lanes  set to the lanes that are also done of the block after the last finished one, if the run is not finished
/// \return number of finished blocks
/// \pre has_short_form
std::size_t advance_whole(const WholeRun& run, const Rows& rows, unsigned& lanes) noexcept;

}  // namespace voussoir::kernels
