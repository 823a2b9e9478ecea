// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <chrono>
#include <cstddef>

/// Where the wall-clock of a run goes. Never part of the state.
namespace voussoir::solver {

enum class Stage : std::size_t { search, forces, damage, update, ledger, output };
inline constexpr std::array<const char*, 6> kStageNames = {"search", "forces", "damage", "update", "ledger", "output"};

using StageTimes = std::array<double, kStageNames.size()>;  // s

/// Adds the time until it goes out of scope to one stage.
class StageTimer {
 public:
  StageTimer(StageTimes& times, Stage stage) : total_(times[static_cast<std::size_t>(stage)]) {}
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;
  ~StageTimer() { total_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  double& total_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace voussoir::solver
