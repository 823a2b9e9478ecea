// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cases/forward.h"
#include "solver/run/simulation.h"

namespace voussoir::io {

/// Where the wall-clock time of a run went, along its simulated time. Part of no result.
class RunClock {
 public:
  /// \param wall  s, since the run began here \param stages  since the simulation was built
  void note(double time, bool settling, double wall, const solver::StageTimes& stages);

  /// Wall-clock time after this simulated time [s].
  [[nodiscard]] double after(double time) const;
  [[nodiscard]] double total() const { return looks_.empty() ? 0.0 : looks_.back().second; }
  /// Of the shaking alone [s].
  [[nodiscard]] const solver::StageTimes& shaking() const { return shaking_; }

 private:
  std::vector<std::pair<double, double>> looks_;  // s: simulated, wall-clock; some 0.1 s of simulated time apart
  solver::StageTimes settled_{}, shaking_{};
};

/// Lines on what would have made this run faster, by a tenth at least; none for a run of less than kWorthAdvice of wall-clock time.
/// \param collapse  s, of the building; < 0: none
std::string advice_lines(const cases::Case& c, const solver::Simulation& sim, const RunClock& clock, double collapse);

inline constexpr double kWorthAdvice = 20.0;  // s

}  // namespace voussoir::io
