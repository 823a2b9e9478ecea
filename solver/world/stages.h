// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <chrono>
#include <cstddef>

#include "geometry/nth.h"

/// Wall-clock times of the parts of a run. Never part of the state.
namespace voussoir::solver {

enum class Stage : std::size_t { search, forces, damage, update, ledger, output };
inline constexpr std::array<const char*, 6> kStageNames = {"search", "forces", "damage", "update", "ledger", "output"};

using StageTimes = std::array<double, kStageNames.size()>;  // s

/// Adds the time of its lifetime to one stage.
class StageTimer {
 public:
  StageTimer(StageTimes& times, Stage stage) : total_(nth(times, stage)) {}
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;
  ~StageTimer() { total_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  double& total_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Work of the threads of a team in the stage of forces, each at its own pace. `assembly` is the transfer of forces from contact slots to
/// elements; joints add their forces immediately (see assembly_time).
enum class ForcePart : std::size_t { whole_joints, damaged_joints, contacts, assembly };
inline constexpr std::size_t kForceParts = 4;
using ForceTimes = std::array<double, kForceParts>;  // s

/// Divides a thread's time among the parts of ForcePart. A disabled clock is never read: reading takes as long as a joint or two.
class LapClock {
 public:
  explicit LapClock(bool on = false) : on_(on) {}
  /// Begins a lap, ignoring the time before.
  void begin() {
    if (on_) last_ = Clock::now();
  }
  /// Ends the lap, counts it for `part`, and begins the next.
  void lap(ForcePart part) {
    if (!on_) return;
    const Clock::time_point now = Clock::now();
    nth(times_, part) += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }
  [[nodiscard]] double time(ForcePart part) const { return nth(times_, part); }  // s
  [[nodiscard]] const ForceTimes& times() const { return times_; }

 private:
  using Clock = std::chrono::steady_clock;
  bool on_;
  Clock::time_point last_;
  ForceTimes times_{};
};

}  // namespace voussoir::solver
