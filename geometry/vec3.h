// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

/// Small vector maths, shared by every layer. Plain doubles; units are those of the caller.
namespace voussoir {

/// A vector of three components in the unit of its context (m unless said).
struct Vec3 {
  double x = 0.0, y = 0.0, z = 0.0;

  constexpr Vec3& operator+=(Vec3 o) noexcept {
    x += o.x, y += o.y, z += o.z;
    return *this;
  }
  constexpr Vec3& operator-=(Vec3 o) noexcept {
    x -= o.x, y -= o.y, z -= o.z;
    return *this;
  }
  constexpr Vec3& operator*=(double f) noexcept {
    x *= f, y *= f, z *= f;
    return *this;
  }
  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};

constexpr Vec3 operator+(Vec3 a, Vec3 b) noexcept { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(Vec3 a, Vec3 b) noexcept { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator-(Vec3 a) noexcept { return {-a.x, -a.y, -a.z}; }
constexpr Vec3 operator*(double f, Vec3 a) noexcept { return {f * a.x, f * a.y, f * a.z}; }
constexpr Vec3 operator*(Vec3 a, double f) noexcept { return f * a; }
constexpr Vec3 operator/(Vec3 a, double f) noexcept { return (1.0 / f) * a; }

constexpr double dot(Vec3 a, Vec3 b) noexcept { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(Vec3 a, Vec3 b) noexcept { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline double norm(Vec3 a) noexcept { return std::sqrt(dot(a, a)); }
/// Divides by the length (not by its reciprocal), so a vector along a global axis becomes that axis exactly.
inline Vec3 normalised(Vec3 a) noexcept {
  const double length = norm(a);
  return {a.x / length, a.y / length, a.z / length};
}

/// A 3×3 matrix by rows: (M v)_i = dot(row_i, v).
struct Mat3 {
  Vec3 r0{1, 0, 0}, r1{0, 1, 0}, r2{0, 0, 1};

  static constexpr Mat3 zero() noexcept { return {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}; }
  static constexpr Mat3 diagonal(double a, double b, double c) noexcept { return {{a, 0, 0}, {0, b, 0}, {0, 0, c}}; }
  friend constexpr bool operator==(const Mat3&, const Mat3&) = default;
};

constexpr Vec3 operator*(const Mat3& m, Vec3 v) noexcept { return {dot(m.r0, v), dot(m.r1, v), dot(m.r2, v)}; }
constexpr Mat3 operator+(const Mat3& a, const Mat3& b) noexcept { return {a.r0 + b.r0, a.r1 + b.r1, a.r2 + b.r2}; }
constexpr Mat3 operator-(const Mat3& a, const Mat3& b) noexcept { return {a.r0 - b.r0, a.r1 - b.r1, a.r2 - b.r2}; }
constexpr Mat3 operator*(double f, const Mat3& a) noexcept { return {f * a.r0, f * a.r1, f * a.r2}; }
constexpr Mat3 transposed(const Mat3& m) noexcept { return {{m.r0.x, m.r1.x, m.r2.x}, {m.r0.y, m.r1.y, m.r2.y}, {m.r0.z, m.r1.z, m.r2.z}}; }
constexpr Mat3 operator*(const Mat3& a, const Mat3& b) noexcept {
  const Mat3 t = transposed(b);
  return {t * a.r0, t * a.r1, t * a.r2};
}
/// The dyad a bᵀ.
constexpr Mat3 outer(Vec3 a, Vec3 b) noexcept { return {a.x * b, a.y * b, a.z * b}; }

/// Unit quaternion w + (x, y, z): the rotation from the reference to the current configuration.
struct Quaternion {
  double w = 1.0, x = 0.0, y = 0.0, z = 0.0;
  friend constexpr bool operator==(const Quaternion&, const Quaternion&) = default;
};

/// R(q) − I without cancellation: exact to round-off also for rotations of 1e-12 rad, whose digits are lost in R.
constexpr Mat3 rotation_minus_identity(Quaternion q) noexcept {
  const double xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
  const double xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z;
  const double wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
  return {{-2 * (yy + zz), 2 * (xy - wz), 2 * (xz + wy)},
          {2 * (xy + wz), -2 * (xx + zz), 2 * (yz - wx)},
          {2 * (xz - wy), 2 * (yz + wx), -2 * (xx + yy)}};
}
constexpr Mat3 rotation(Quaternion q) noexcept { return Mat3{} + rotation_minus_identity(q); }

}  // namespace voussoir
