// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Displacements and tractions of a segment, as the laws of joints have them. u = x_slave − x_master, so tension is positive.
namespace voussoir::kernels {

/// A vector in the frame of a side: along the outward normal of the master, and two tangents.
struct Local {
  double n = 0.0, s1 = 0.0, s2 = 0.0;
};
constexpr Local operator+(Local a, Local b) noexcept { return {a.n + b.n, a.s1 + b.s1, a.s2 + b.s2}; }
constexpr Local operator-(Local a, Local b) noexcept { return {a.n - b.n, a.s1 - b.s1, a.s2 - b.s2}; }
constexpr Local operator*(double f, Local a) noexcept { return {f * a.n, f * a.s1, f * a.s2}; }
constexpr double dot(Local a, Local b) noexcept { return a.n * b.n + a.s1 * b.s1 + a.s2 * b.s2; }

}  // namespace voussoir::kernels
