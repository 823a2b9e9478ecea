// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

namespace voussoir::solver {

/// Borders between the shares of a team of threads. They follow the times that shares take, step after step, so that no thread has to wait
/// for another or to help it, even if one has only half a core, or the harder half of the work.
class ShareBorders {
 public:
  /// Equal shares initially.
  explicit ShareBorders(int threads);

  /// By thread: end of its share, from 0 (begin of the first task) to 1 (end of the last one).
  [[nodiscard]] std::span<const double> ends() const { return ends_; }

  /// Takes the times of a round. \param times  by thread, of its share [s] \return true if borders have moved, as they do occasionally
  bool note(std::span<const double> times);

 private:
  bool move();
  std::vector<double> ends_, excess_;  // by thread; share of the mean time, less 1, summed over the steps since the last test of borders
  int steps_ = 0;                      // number of these steps
};

}  // namespace voussoir::solver
