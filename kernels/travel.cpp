// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "kernels/travel.h"

#include <cmath>

#include "kernels/lanes.h"

namespace voussoir::kernels {

namespace {

/// A point turns by at most 2 |Δq| r to first order; the square of a sum is at most twice the sum of squares. 1.1: what lies beyond first
/// order, for turns that a search waits for.
template <class Real>
VOUSSOIR_INLINE Real squared_move(Real dx, Real dy, Real dz, Real dw, Real da, Real db, Real dc, Real radius) noexcept {
  const Real turn2 = 4.0 * radius * radius * (dw * dw + da * da + db * db + dc * dc);
  return 2.0 * (dx * dx + dy * dy + dz * dz + 1.1 * turn2);
}

VOUSSOIR_INLINE Lanes difference(const double* a, const double* b, std::int64_t i) noexcept {
  return load_lanes(a + i) - load_lanes(b + i);
}
/// To the digits of a float, whose root takes a third of the time. The square of a slow one is below the smallest float, and nothing would
/// be no bound: hence a little more.
VOUSSOIR_INLINE Lanes length(const double* x, const double* y, const double* z, std::int64_t i) noexcept {
  const VecLanes v{load_lanes(x + i), load_lanes(y + i), load_lanes(z + i)};
  Floats f = __builtin_convertvector(dot(v, v) + 1e-30, Floats);
  for (int l = 0; l < kWidth; ++l) f[l] = std::sqrt(f[l]);
  return __builtin_convertvector(f, Lanes);
}

// `move_of` of a sum is at most the sum of those of its parts, and that of a part at most sqrt(2.2) of its way.
constexpr double kMoveOfWay = 1.5;

VOUSSOIR_INLINE Lanes moves_of_group(const ElementsView& e, const SearchedPoses& at, std::int64_t i) noexcept {
  return sqrt(squared_move(difference(e.ux, at.ux, i), difference(e.uy, at.uy, i), difference(e.uz, at.uz, i), difference(e.qw, at.qw, i),
                           difference(e.qx, at.qx, i), difference(e.qy, at.qy, i), difference(e.qz, at.qz, i), load_lanes(at.radius + i)));
}

VOUSSOIR_INLINE double largest(Lanes x) noexcept {
  double most = 0.0;
  for (int l = 0; l < kWidth; ++l) most = x[l] > most ? x[l] : most;
  return most;
}

/// Each element of a batch has its own way. \return moves of those that had to be looked at
VOUSSOIR_INLINE Lanes measure_each(const ElementsView& e, const Moves& m, Lanes step, std::int64_t first) noexcept {
  constexpr unsigned kAll = (1U << kWidth) - 1U;
  Lanes farthest{};
  for (std::int64_t i = first; i < first + kBatch; i += kWidth) {
    const Lanes speed = length(e.vx, e.vy, e.vz, i), spin = length(e.wx, e.wy, e.wz, i);
    const Lanes path = load_lanes(m.element.path + i) + step * (speed + spin * load_lanes(m.at.radius + i));
    store_lanes(m.element.path + i, path);
    if (bits(path <= load_lanes(m.element.until + i)) == kAll) continue;
    const Lanes move = moves_of_group(e, m.at, i);
    store_lanes(m.element.until + i, path + (m.limit - move) * (1.0 / kMoveOfWay));
    farthest = max(farthest, move);
  }
  return farthest;
}

/// All of them have one: as long as that of the fastest, with the radius of the largest.
VOUSSOIR_INLINE Lanes measure_together(const ElementsView& e, const Moves& m, Lanes step, std::int64_t first) noexcept {
  const std::int64_t batch = first / kBatch;
  const Lanes radius = lanes(m.largest_radius[batch]);
  Lanes way{};
  for (std::int64_t i = first; i < first + kBatch; i += kWidth) {
    way = max(way, step * (length(e.vx, e.vy, e.vz, i) + length(e.wx, e.wy, e.wz, i) * radius));
  }
  double& path = m.batch.path[batch];
  path += largest(way);
  if (path <= m.batch.until[batch]) return Lanes{};
  Lanes farthest{};
  for (std::int64_t i = first; i < first + kBatch; i += kWidth) farthest = max(farthest, moves_of_group(e, m.at, i));
  m.batch.until[batch] = path + (m.limit - largest(farthest)) / kMoveOfWay;
  return farthest;
}

}  // namespace

double move_of(const ElementsView& e, const SearchedPoses& at, std::int64_t i) noexcept {
  return std::sqrt(squared_move(e.ux[i] - at.ux[i], e.uy[i] - at.uy[i], e.uz[i] - at.uz[i], e.qw[i] - at.qw[i], e.qx[i] - at.qx[i],
                                e.qy[i] - at.qy[i], e.qz[i] - at.qz[i], at.radius[i]));
}

double measure_moves(const ElementsView& e, const Moves& m, std::int64_t first, std::int64_t last) noexcept {
  const Lanes step = lanes(1.001 * m.dt);  // a little more for round-off and what `drift` cuts off
  Lanes farthest{};
  for (std::int64_t i = first; i < last; i += kBatch) {
    const bool each = m.active == nullptr || m.active[i / kBatch] != 0;
    farthest = max(farthest, each ? measure_each(e, m, step, i) : measure_together(e, m, step, i));
  }
  const double most = largest(farthest);
  return most > m.limit ? most : 0.0;
}

}  // namespace voussoir::kernels
