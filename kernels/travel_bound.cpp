// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "kernels/travel_bound.h"

#include <cmath>

#include "kernels/lanes.h"

namespace voussoir::kernels {

namespace {

/// Squared bound on the displacement of a point. A point turns by at most 2 |Δq| r to first order; the square of a sum is at most twice the
/// sum of squares. The factor 1.1 covers higher orders for the turns that occur between searches.
template <class Real>
VOUSSOIR_INLINE Real squared_displacement(Real dx, Real dy, Real dz, Real dw, Real da, Real db, Real dc, Real radius) noexcept {
  const Real turn2 = 4.0 * radius * radius * (dw * dw + da * da + db * db + dc * dc);
  return 2.0 * (dx * dx + dy * dy + dz * dz + 1.1 * turn2);
}

VOUSSOIR_INLINE Lanes difference(const double* a, const double* b, std::int64_t i) noexcept {
  return load_lanes(a + i) - load_lanes(b + i);
}
/// Length of vectors with the digits of a float, whose root takes a third of the time. 1e-30 keeps the squares of slow motions above the
/// smallest float, since zero would not be a bound.
VOUSSOIR_INLINE Lanes length(const double* x, const double* y, const double* z, std::int64_t i) noexcept {
  const VecLanes v{load_lanes(x + i), load_lanes(y + i), load_lanes(z + i)};
  Floats f = __builtin_convertvector(dot(v, v) + 1e-30, Floats);
  for (int l = 0; l < kWidth; ++l) f[l] = std::sqrt(f[l]);
  return __builtin_convertvector(f, Lanes);
}

// Greatest ratio of `squared_displacement`'s root to travel: the value of a sum of small motions is at most the sum of their values, and
// that of one motion at most sqrt(2.2) times its travel.
constexpr double kDisplacementOfTravel = 1.5;

VOUSSOIR_INLINE Lanes displacements_of_group(const ElementsView& e, const SearchedPoses& at, std::int64_t i) noexcept {
  return sqrt(squared_displacement(difference(e.ux, at.ux, i), difference(e.uy, at.uy, i), difference(e.uz, at.uz, i),
                                   difference(e.qw, at.qw, i), difference(e.qx, at.qx, i), difference(e.qy, at.qy, i),
                                   difference(e.qz, at.qz, i), load_lanes(at.radius + i)));
}

VOUSSOIR_INLINE double largest(Lanes x) noexcept {
  double most = 0.0;
  for (int l = 0; l < kWidth; ++l) most = x[l] > most ? x[l] : most;
  return most;
}

/// Displacements above their limits; 0 for the others.
VOUSSOIR_INLINE Lanes over(Lanes moved, Lanes limit) noexcept {
  Lanes result{};
  for (int l = 0; l < kWidth; ++l) result[l] = moved[l] > limit[l] ? moved[l] : 0.0;
  return result;
}

/// Advances a batch in which each element has its own bound. \return the displacements above their limits
VOUSSOIR_INLINE Lanes advance_each(const ElementsView& e, const TravelView& t, Lanes step, std::int64_t first) noexcept {
  constexpr unsigned kAll = (1U << kWidth) - 1U;
  Lanes farthest{};
  for (std::int64_t i = first; i < first + kBatch; i += kWidth) {
    const Lanes speed = length(e.vx, e.vy, e.vz, i), spin = length(e.wx, e.wy, e.wz, i);
    const Lanes bound = load_lanes(t.element.bound + i) + step * (speed + spin * load_lanes(t.at.radius + i));
    store_lanes(t.element.bound + i, bound);
    if (bits(bound <= load_lanes(t.element.safe + i)) == kAll) continue;
    const Lanes moved = displacements_of_group(e, t.at, i);
    const Lanes limit = load_lanes(t.reach + i) - t.margin;
    store_lanes(t.element.safe + i, bound + (limit - moved) * (1.0 / kDisplacementOfTravel));
    farthest = max(farthest, over(moved, limit));
  }
  return farthest;
}

/// Advances a batch with one bound, which grows by the travel of the fastest element with the radius of the largest.
VOUSSOIR_INLINE Lanes advance_together(const ElementsView& e, const TravelView& t, Lanes step, std::int64_t first) noexcept {
  const std::int64_t batch = first / kBatch;
  const Lanes radius = lanes(t.largest_radius[batch]);
  Lanes travel{};
  for (std::int64_t i = first; i < first + kBatch; i += kWidth) {
    travel = max(travel, step * (length(e.vx, e.vy, e.vz, i) + length(e.wx, e.wy, e.wz, i) * radius));
  }
  double& bound = t.batch.bound[batch];
  bound += largest(travel);
  if (bound <= t.batch.safe[batch]) return Lanes{};
  Lanes most{}, farthest{};
  double nearest = 1e300;
  for (std::int64_t i = first; i < first + kBatch; i += kWidth) {
    const Lanes moved = displacements_of_group(e, t.at, i), limit = load_lanes(t.reach + i) - t.margin;
    for (int l = 0; l < kWidth; ++l) nearest = limit[l] < nearest ? limit[l] : nearest;
    most = max(most, moved), farthest = max(farthest, over(moved, limit));
  }
  t.batch.safe[batch] = bound + (nearest - largest(most)) / kDisplacementOfTravel;
  return farthest;
}

}  // namespace

double displacement_since_search(const ElementsView& e, const SearchedPoses& at, std::int64_t i) noexcept {
  return std::sqrt(squared_displacement(e.ux[i] - at.ux[i], e.uy[i] - at.uy[i], e.uz[i] - at.uz[i], e.qw[i] - at.qw[i], e.qx[i] - at.qx[i],
                                        e.qy[i] - at.qy[i], e.qz[i] - at.qz[i], at.radius[i]));
}

double advance_travel(const ElementsView& e, const TravelView& t, std::int64_t first, std::int64_t last) noexcept {
  const Lanes step = lanes(1.001 * t.dt);  // 1.001: covers round-off and the truncation in `drift`
  Lanes farthest{};
  for (std::int64_t i = first; i < last; i += kBatch) {
    const bool each = t.active == nullptr || t.active[i / kBatch] != 0;
    farthest = max(farthest, each ? advance_each(e, t, step, i) : advance_together(e, t, step, i));
  }
  return largest(farthest);
}

}  // namespace voussoir::kernels
