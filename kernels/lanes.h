// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "geometry/vec3.h"

/// Several doubles at a time: as many as one vector register holds. Plain operators on compiler vectors, no intrinsics.
/// Every lane is computed alone, so a result does not depend on its neighbours.
namespace voussoir::kernels {

/// Lane helpers must be inlined: a call would pass every vector through memory.
#define VOUSSOIR_INLINE [[gnu::always_inline]] inline

#if defined(__AVX512F__)
inline constexpr int kWidth = 8;
typedef double Lanes __attribute__((vector_size(64)));
typedef long long LaneMask __attribute__((vector_size(64)));
#else
inline constexpr int kWidth = 4;
typedef double Lanes __attribute__((vector_size(32)));
typedef long long LaneMask __attribute__((vector_size(32)));
#endif

VOUSSOIR_INLINE Lanes load_lanes(const double* p) noexcept {
  Lanes x;
  __builtin_memcpy(&x, p, sizeof x);
  return x;
}
VOUSSOIR_INLINE void store_lanes(double* p, Lanes x) noexcept { __builtin_memcpy(p, &x, sizeof x); }

VOUSSOIR_INLINE Lanes lanes(double x) noexcept { return x - Lanes{}; }

VOUSSOIR_INLINE Lanes sqrt(Lanes x) noexcept {
  Lanes y;
  for (int i = 0; i < kWidth; ++i) y[i] = std::sqrt(x[i]);
  return y;
}
VOUSSOIR_INLINE Lanes min(Lanes a, Lanes b) noexcept { return a < b ? a : b; }
VOUSSOIR_INLINE Lanes max(Lanes a, Lanes b) noexcept { return a > b ? a : b; }
VOUSSOIR_INLINE Lanes select(LaneMask m, Lanes a, Lanes b) noexcept { return m ? a : b; }
/// Bit i is set where lane i is true. The one place where the compiler does not find the machine's instruction by itself.
VOUSSOIR_INLINE unsigned bits(LaneMask m) noexcept {
#if defined(__AVX__) && !defined(__AVX512F__)
  return static_cast<unsigned>(__builtin_ia32_movmskpd256(reinterpret_cast<Lanes>(m)));
#else
  unsigned r = 0;
  for (int i = 0; i < kWidth; ++i) r |= (m[i] ? 1U : 0U) << i;
  return r;
#endif
}
/// kWidth bytes, widened to lanes.
VOUSSOIR_INLINE LaneMask widened(const unsigned char* p) noexcept {
  typedef unsigned char Bytes __attribute__((vector_size(kWidth)));
  Bytes b;
  __builtin_memcpy(&b, p, sizeof b);
  return __builtin_convertvector(b, LaneMask);
}

/// Vec3 over lanes.
struct VecLanes {
  Lanes x, y, z;
};
VOUSSOIR_INLINE VecLanes operator+(VecLanes a, VecLanes b) noexcept { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
VOUSSOIR_INLINE VecLanes operator-(VecLanes a, VecLanes b) noexcept { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
VOUSSOIR_INLINE VecLanes operator*(Lanes f, VecLanes a) noexcept { return {f * a.x, f * a.y, f * a.z}; }
VOUSSOIR_INLINE Lanes dot(VecLanes a, VecLanes b) noexcept { return a.x * b.x + a.y * b.y + a.z * b.z; }
VOUSSOIR_INLINE VecLanes cross(VecLanes a, VecLanes b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
struct MatLanes {
  VecLanes r0, r1, r2;
};
VOUSSOIR_INLINE VecLanes operator*(const MatLanes& m, VecLanes v) noexcept { return {dot(m.r0, v), dot(m.r1, v), dot(m.r2, v)}; }

}  // namespace voussoir::kernels
