// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

namespace voussoir::solver {

/// Where the shares of a team of threads end. They follow what shares take, step after step: none has to wait for another, or to help it,
/// though one of them has half a core only, or the harder half of the work.
class ShareBorders {
 public:
  /// All alike at first.
  explicit ShareBorders(int threads);

  /// By thread: where its share ends, from 0 (the first task's begin) to 1 (the last one's end).
  [[nodiscard]] std::span<const double> ends() const { return ends_; }

  /// Once a round. \param times  by thread, what its share took [s] \return true if borders have moved, as they do now and then
  bool note(std::span<const double> times);

 private:
  bool move();
  std::vector<double> ends_, excess_;  // by thread; its share of the mean time, less 1, over the steps since borders were looked at last
  int steps_ = 0;                      // since then
};

}  // namespace voussoir::solver
