// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernels/lanes.h"
#include "kernels/law.h"
#include "kernels/laws/local.h"

/// Views of the segments of one side, for the laws that look at them one by one.
namespace voussoir::kernels {

/// Contact points of a side, in its frame; n entries.
struct PointsView {
  const double *s = nullptr, *t = nullptr, *area = nullptr;
  int n = 0;
};

/// What kWidth segments of a side have been through for good [m]. They go through the kernel side by side, so their numbers lie together.
struct alignas(sizeof(Lanes)) SegmentSprings {
  double slip1[kWidth], slip2[kWidth], closure[kWidth];
};

/// History of the segments of a side; n entries, in the order of its points.
struct SegmentsView {
  Bond* bond = nullptr;
  Mode* first_mode = nullptr;
  double* first_time = nullptr;  // s
  SegmentSprings* springs = nullptr;

  [[nodiscard]] SegmentSprings& springs_at(int i) const noexcept { return springs[i / kWidth]; }
  [[nodiscard]] double& slip1(int i) const noexcept { return springs_at(i).slip1[i % kWidth]; }
  [[nodiscard]] double& slip2(int i) const noexcept { return springs_at(i).slip2[i % kWidth]; }
  [[nodiscard]] double& closure(int i) const noexcept { return springs_at(i).closure[i % kWidth]; }
  /// Of the segments from `i` on, a multiple of kWidth.
  [[nodiscard]] SegmentsView from(int i) const noexcept { return {bond + i, first_mode + i, first_time + i, &springs_at(i)}; }
};

/// What the faces of a side do along their normal: u_n(s,t) [m] and its rate [m/s], d + s·ds + t·dt.
struct NormalFields {
  double d, ds, dt, v, vs, vt;
};
/// Sums of tractions over a side, in its frame: Σ f dA, Σ s f dA, Σ t f dA.
struct SideSums {
  Local f, sf, tf;
};

/// What segments did in a step.
struct SegmentTotals {
  SideSums total, dash;                                 // springs and dashpots; dashpots alone
  double friction = 0.0, impact = 0.0, fracture = 0.0;  // J, lost in this step
  int held = 0;                                         // bonded after the step
  bool touching = false;                                // some segment that is not bonded carries force
};

/// What springs lost before the law of contact was asked [J].
struct GaveWay {
  double fracture = 0.0, impact = 0.0;  // by crushing; within the steps of the hyperbola
};

}  // namespace voussoir::kernels
