// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/results/checkpoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "io/input/files/run_folder.h"

namespace voussoir::io {
namespace fs = std::filesystem;
namespace {

/// Number of a checkpoint. \pre path is one of checkpoint_files
long number_in(const std::string& path) { return *checkpoint_number(fs::path(path).filename().string()); }

std::string name_of(long number) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "checkpoint-%06ld.h5", number);
  return text.data();
}

}  // namespace

std::vector<std::string> checkpoint_files(const std::string& folder) {
  std::vector<std::pair<long, std::string>> found;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const auto number = checkpoint_number(entry.path().filename().string());
    if (number) found.emplace_back(*number, entry.path().string());
  }
  std::ranges::sort(found, std::greater<>());
  std::vector<std::string> paths;
  for (auto& [number, path] : found) paths.push_back(std::move(path));
  return paths;
}

Checkpoints::Checkpoints(std::string folder, CheckpointFacts facts, CheckpointSchedule schedule, const std::string& from)
    : folder_(std::move(folder)), facts_(std::move(facts)), schedule_(schedule) {
  const std::vector<std::string> there = checkpoint_files(folder_);
  if (there.empty()) return;
  next_ = number_in(there.front()) + 1;
  if (from.empty()) return;
  damaged_first_ = number_in(from) + 1;
  damaged_last_ = next_;
}

bool Checkpoints::due(const solver::RunStatus& s) const {
  if (!tried_ || s.last) return true;
  if (std::chrono::duration<double>(Clock::now() - *tried_).count() >= schedule_.wall_clock) return true;
  // The simulated clock restarts with the shaking.
  return schedule_.simulated && std::abs(s.time - saved_at_) >= *schedule_.simulated * (1.0 - 1e-9);
}

void Checkpoints::save(solver::Simulation& sim, solver::RunState& plan, const RowCounts& rows) {
  tried_ = Clock::now();
  saved_at_ = sim.time();
  write(folder_ + "/" + name_of(next_), sim, plan, rows);
  ++next_;
  remove_old();
}

void Checkpoints::remove_old() const {
  int whole = 0;
  try {
    for (const std::string& path : checkpoint_files(folder_)) {
      if (whole == kKeptCheckpoints) fs::remove(path);
      const long number = number_in(path);
      if (whole < kKeptCheckpoints && (number < damaged_first_ || number >= damaged_last_)) ++whole;
    }
  } catch (const fs::filesystem_error&) {  // failure to list or remove old checkpoints is harmless
  }
}

void Checkpoints::save_failed(solver::Simulation& sim, solver::RunState& plan, const RowCounts& rows) {
  write(folder_ + "/checkpoint-failed.h5", sim, plan, rows);
}

void Checkpoints::write(const std::string& path, solver::Simulation& sim, solver::RunState& plan, const RowCounts& rows) {
  facts_.time = sim.time();
  facts_.rows = rows;
  write_checkpoint(path, facts_, solver::fields(sim, plan));
}

}  // namespace voussoir::io
