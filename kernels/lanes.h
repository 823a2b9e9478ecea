// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#if defined(__AVX__)
#include <immintrin.h>
#endif

#include <cmath>

#include "geometry/vec3.h"

/// Several doubles at a time: as many as one vector register holds. Plain operators on compiler vectors; intrinsics only in `sqrt`, `bits`,
/// `lanes_of`, `load_halves` and `store_streaming`, where the compiler does not find the machine's instruction. (g++ 12 compiles a loop
/// over lanes into two halves that are joined through memory, and the load of the whole waits for both stores.) Every lane is computed
/// alone, so a result does not depend on the neighbouring lanes.
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

/// A vector of floats with the number of lanes of Lanes.
typedef float Floats __attribute__((vector_size(4 * kWidth)));

VOUSSOIR_INLINE Lanes load_lanes(const double* p) noexcept {
  Lanes x;
  __builtin_memcpy(&x, p, sizeof x);
  return x;
}
VOUSSOIR_INLINE void store_lanes(double* p, Lanes x) noexcept { __builtin_memcpy(p, &x, sizeof x); }

VOUSSOIR_INLINE Lanes lanes(double x) noexcept { return x - Lanes{}; }

VOUSSOIR_INLINE Lanes sqrt(Lanes x) noexcept {
#if defined(__AVX512F__)
#if defined(__clang__)
  return _mm512_sqrt_pd(x);
#else
  return __builtin_ia32_sqrtpd512_mask(x, x, -1, _MM_FROUND_CUR_DIRECTION);  // _mm512_sqrt_pd; g++ 12 warns of the macro
#endif
#elif defined(__AVX__)
  return _mm256_sqrt_pd(x);
#else
  Lanes y{};
  for (int i = 0; i < kWidth; ++i) y[i] = std::sqrt(x[i]);
  return y;
#endif
}
VOUSSOIR_INLINE Lanes min(Lanes a, Lanes b) noexcept { return a < b ? a : b; }
VOUSSOIR_INLINE Lanes max(Lanes a, Lanes b) noexcept { return a > b ? a : b; }
VOUSSOIR_INLINE Lanes select(LaneMask m, Lanes a, Lanes b) noexcept { return m ? a : b; }
/// Bit i is set where lane i is true.
VOUSSOIR_INLINE unsigned bits(LaneMask m) noexcept {
#if defined(__AVX512DQ__)
  return static_cast<unsigned>(__builtin_ia32_cvtq2mask512(m));
#elif defined(__AVX__) && !defined(__AVX512F__)
  return static_cast<unsigned>(__builtin_ia32_movmskpd256(reinterpret_cast<Lanes>(m)));
#else
  unsigned r = 0;
  for (int i = 0; i < kWidth; ++i) r |= (m[i] ? 1U : 0U) << i;
  return r;
#endif
}
/// Inverse of `bits`: lane i is true where bit i is set.
VOUSSOIR_INLINE LaneMask lanes_of(unsigned bits) noexcept {
#if defined(__AVX512DQ__)
  return __builtin_ia32_cvtmask2q512(static_cast<unsigned char>(bits));
#else
  LaneMask m;
  for (int i = 0; i < kWidth; ++i) m[i] = -static_cast<long long>(bits >> i & 1U);
  return m;
#endif
}
/// kWidth bytes, widened to lanes.
VOUSSOIR_INLINE LaneMask widened(const unsigned char* p) noexcept {
  typedef unsigned char Bytes __attribute__((vector_size(kWidth)));
  Bytes b;
  __builtin_memcpy(&b, p, sizeof b);
  return __builtin_convertvector(b, LaneMask);
}

/// Four doubles: the unit in which rows are read and written whatever the width of the lanes.
typedef double Quad __attribute__((vector_size(32)));
typedef double Pair __attribute__((vector_size(16)));

VOUSSOIR_INLINE Quad load_quad(const double* p) noexcept {
  Quad x;
  __builtin_memcpy(&x, p, sizeof x);
  return x;
}
VOUSSOIR_INLINE Pair load_pair(const double* p) noexcept {
  Pair x;
  __builtin_memcpy(&x, p, sizeof x);
  return x;
}
VOUSSOIR_INLINE void store_quad(double* p, Quad x) noexcept { __builtin_memcpy(p, &x, sizeof x); }
/// Stores past the caches, without fetching the line first: for data that is not read again before the caches would have dropped it.
/// Visible to other threads after kernels::finish_stores. \pre p is a multiple of 32 bytes
VOUSSOIR_INLINE void store_streaming(double* p, Quad x) noexcept {
#if defined(__AVX__)
  _mm256_stream_pd(p, x);
#else
  store_quad(p, x);
#endif
}
VOUSSOIR_INLINE void add_quad(double* p, Quad x) noexcept { store_quad(p, load_quad(p) + x); }
VOUSSOIR_INLINE void add_pair(double* p, Pair x) noexcept {
  x = load_pair(p) + x;
  __builtin_memcpy(p, &x, sizeof x);
}
/// Transposes four rows of four numbers.
VOUSSOIR_INLINE void transpose(Quad& a, Quad& b, Quad& c, Quad& d) noexcept {
  const Quad ab02 = __builtin_shufflevector(a, b, 0, 4, 2, 6), ab13 = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Quad cd02 = __builtin_shufflevector(c, d, 0, 4, 2, 6), cd13 = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab02, cd02, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab13, cd13, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab02, cd02, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab13, cd13, 2, 3, 6, 7);
}
#if defined(__AVX512F__)
VOUSSOIR_INLINE Quad quad_of(Lanes x, int at) noexcept {
  return at == 0 ? __builtin_shufflevector(x, x, 0, 1, 2, 3) : __builtin_shufflevector(x, x, 4, 5, 6, 7);
}
#else
VOUSSOIR_INLINE Quad quad_of(Lanes x, int) noexcept { return x; }
#endif
inline constexpr int kQuads = kWidth / 4;

/// Interleaves a and b: even_of takes lanes 0, 2, ... of a to the even lanes of the result and those of b to the odd ones; odd_of likewise
/// lanes 1, 3, ...
#if defined(__AVX512F__)
VOUSSOIR_INLINE Lanes even_of(Lanes a, Lanes b) noexcept { return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14); }
VOUSSOIR_INLINE Lanes odd_of(Lanes a, Lanes b) noexcept { return __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15); }
#else
VOUSSOIR_INLINE Lanes even_of(Lanes a, Lanes b) noexcept { return __builtin_shufflevector(a, b, 0, 4, 2, 6); }
VOUSSOIR_INLINE Lanes odd_of(Lanes a, Lanes b) noexcept { return __builtin_shufflevector(a, b, 1, 5, 3, 7); }
#endif

/// Two pairs, or two quads, side by side; the second load fills its half directly. (g++ 12 turns equivalent shuffles into a load, a move
/// and a shuffle.)
#if defined(__AVX512F__)
VOUSSOIR_INLINE Lanes load_halves(const double* low, const double* high) noexcept {
  const Lanes x = _mm512_castpd256_pd512(load_quad(low));
#if defined(__clang__)
  return _mm512_insertf64x4(x, load_quad(high), 1);
#else
  return __builtin_ia32_insertf64x4_mask(x, load_quad(high), 1, x, 0xff);    // _mm512_insertf64x4; g++ 12 warns of the macro
#endif
}
#elif defined(__AVX__)
VOUSSOIR_INLINE Lanes load_halves(const double* low, const double* high) noexcept {
  return _mm256_insertf128_pd(_mm256_castpd128_pd256(load_pair(low)), load_pair(high), 1);
}
#else
VOUSSOIR_INLINE Lanes load_halves(const double* low, const double* high) noexcept {
  return __builtin_shufflevector(load_pair(low), load_pair(high), 0, 1, 2, 3);
}
#endif

/// Loads four columns, from column `at` on, of the rows that `row(lane)` points to, one row a lane.
template <class Row>
VOUSSOIR_INLINE void load_columns(Row row, int at, Lanes& c0, Lanes& c1, Lanes& c2, Lanes& c3) noexcept {
#if defined(__AVX512F__)
  const auto rows = [&](int l) { return load_halves(row(l) + at, row(l + 2) + at); };
  const Lanes r02 = rows(0), r13 = rows(1), r46 = rows(4), r57 = rows(5);
  // even_low, odd_low: columns 0 2 0 2 and 1 3 1 3 of rows 0 to 3; even_high, odd_high: of rows 4 to 7.
  const Lanes even_low = even_of(r02, r13), odd_low = odd_of(r02, r13), even_high = even_of(r46, r57), odd_high = odd_of(r46, r57);
  c0 = __builtin_shufflevector(even_low, even_high, 0, 1, 4, 5, 8, 9, 12, 13);
  c1 = __builtin_shufflevector(odd_low, odd_high, 0, 1, 4, 5, 8, 9, 12, 13);
  c2 = __builtin_shufflevector(even_low, even_high, 2, 3, 6, 7, 10, 11, 14, 15);
  c3 = __builtin_shufflevector(odd_low, odd_high, 2, 3, 6, 7, 10, 11, 14, 15);
#else
  const auto pairs = [&](int l, int from) { return load_halves(row(l) + from, row(l + 2) + from); };
  const Lanes even01 = pairs(0, at), odd01 = pairs(1, at), even23 = pairs(0, at + 2), odd23 = pairs(1, at + 2);
  c0 = even_of(even01, odd01), c1 = odd_of(even01, odd01), c2 = even_of(even23, odd23), c3 = odd_of(even23, odd23);
#endif
}

/// Four columns as rows, one row a lane.
VOUSSOIR_INLINE void to_rows(Lanes c0, Lanes c1, Lanes c2, Lanes c3, Quad (&r)[kWidth]) noexcept {
#if defined(__AVX512F__)
  const Lanes even01 = even_of(c0, c1), odd01 = odd_of(c0, c1), even23 = even_of(c2, c3), odd23 = odd_of(c2, c3);
  const auto put = [&](int l, Lanes rows) { r[l] = quad_of(rows, 0), r[l + 2] = quad_of(rows, 1); };
  put(0, __builtin_shufflevector(even01, even23, 0, 1, 8, 9, 2, 3, 10, 11));
  put(1, __builtin_shufflevector(odd01, odd23, 0, 1, 8, 9, 2, 3, 10, 11));
  put(4, __builtin_shufflevector(even01, even23, 4, 5, 12, 13, 6, 7, 14, 15));
  put(5, __builtin_shufflevector(odd01, odd23, 4, 5, 12, 13, 6, 7, 14, 15));
#else
  r[0] = c0, r[1] = c1, r[2] = c2, r[3] = c3;
  transpose(r[0], r[1], r[2], r[3]);
#endif
}

/// Stores four columns into the rows that `row(lane)` points to: the inverse of load_columns.
template <class Row>
VOUSSOIR_INLINE void store_columns(Row row, int at, Lanes c0, Lanes c1, Lanes c2, Lanes c3) noexcept {
  Quad r[kWidth];
  to_rows(c0, c1, c2, c3, r);
  for (int l = 0; l < kWidth; ++l) store_quad(row(l) + at, r[l]);
}

/// The sums over the lanes of a, of b, of c and of d.
VOUSSOIR_INLINE Quad sums_of(Lanes a, Lanes b, Lanes c, Lanes d) noexcept {
  Quad sum{};
  for (int k = 0; k < kQuads; ++k) {
    Quad q[4] = {quad_of(a, k), quad_of(b, k), quad_of(c, k), quad_of(d, k)};
    transpose(q[0], q[1], q[2], q[3]);
    sum = sum + ((q[0] + q[1]) + (q[2] + q[3]));
  }
  return sum;
}

/// Rows of a force and a torque, one row a lane.
struct SixColumns {
  Quad head[kWidth];  // fx fy fz tx
  Pair tail[kWidth];  // ty tz
};
VOUSSOIR_INLINE SixColumns rows_of(const Lanes (&c)[6]) noexcept {
  SixColumns r;
  to_rows(c[0], c[1], c[2], c[3], r.head);
  const Lanes even = even_of(c[4], c[5]), odd = odd_of(c[4], c[5]);
  r.tail[0] = __builtin_shufflevector(even, even, 0, 1), r.tail[1] = __builtin_shufflevector(odd, odd, 0, 1);
  r.tail[2] = __builtin_shufflevector(even, even, 2, 3), r.tail[3] = __builtin_shufflevector(odd, odd, 2, 3);
#if defined(__AVX512F__)
  r.tail[4] = __builtin_shufflevector(even, even, 4, 5), r.tail[5] = __builtin_shufflevector(odd, odd, 4, 5);
  r.tail[6] = __builtin_shufflevector(even, even, 6, 7), r.tail[7] = __builtin_shufflevector(odd, odd, 6, 7);
#endif
  return r;
}
VOUSSOIR_INLINE void store_row(double* row, const SixColumns& r, int lane) noexcept {
  store_quad(row, r.head[lane]);
  __builtin_memcpy(row + 4, &r.tail[lane], sizeof r.tail[lane]);
}
VOUSSOIR_INLINE void store_opposite(double* row, const SixColumns& r, int lane) noexcept {
  store_quad(row, -r.head[lane]);
  const Pair tail = -r.tail[lane];
  __builtin_memcpy(row + 4, &tail, sizeof tail);
}
VOUSSOIR_INLINE void add_row(double* row, const SixColumns& r, int lane) noexcept {
  add_quad(row, r.head[lane]);
  add_pair(row + 4, r.tail[lane]);
}
VOUSSOIR_INLINE void subtract_row(double* row, const SixColumns& r, int lane) noexcept {
  add_quad(row, -r.head[lane]);
  add_pair(row + 4, -r.tail[lane]);
}

/// Vec3 over lanes.
struct VecLanes {
  Lanes x, y, z;
};
VOUSSOIR_INLINE VecLanes spread(Vec3 v) noexcept { return {lanes(v.x), lanes(v.y), lanes(v.z)}; }
VOUSSOIR_INLINE VecLanes select3(LaneMask m, VecLanes a, VecLanes b) noexcept {
  return {select(m, a.x, b.x), select(m, a.y, b.y), select(m, a.z, b.z)};
}
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
VOUSSOIR_INLINE MatLanes operator-(const MatLanes& a, const MatLanes& b) noexcept { return {a.r0 - b.r0, a.r1 - b.r1, a.r2 - b.r2}; }
VOUSSOIR_INLINE MatLanes operator+(const MatLanes& a, const MatLanes& b) noexcept { return {a.r0 + b.r0, a.r1 + b.r1, a.r2 + b.r2}; }
VOUSSOIR_INLINE MatLanes operator*(Lanes f, const MatLanes& m) noexcept { return {f * m.r0, f * m.r1, f * m.r2}; }

}  // namespace voussoir::kernels
