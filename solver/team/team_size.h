// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace voussoir::solver {

/// How many threads a run goes on with, by what steps take with them. Fewer are faster where a core has other work, or where a model is so
/// small that threads wait for each other most of the time.
///
/// Now and then some steps are made with fewer threads, or more, in turn with as many as before. Whatever is faster by a margin is kept.
/// What was tried in vain is tried again later and later, so that trials cost little where nothing changes.
class TeamSize {
 public:
  /// \param most  threads; the run begins with them
  explicit TeamSize(int most = 1);

  /// Of the next step.
  [[nodiscard]] int size() const { return in_trial() && tries_other() ? other_ : size_; }
  [[nodiscard]] int most() const { return most_; }
  /// What that step has taken [s].
  void note(double time);
  /// Time of steps so far with fewer threads than there may be, and of all steps [s]; zero with one thread.
  [[nodiscard]] double time_of_fewer() const { return fewer_time_; }
  [[nodiscard]] double time_of_all() const { return all_time_; }

 private:
  // A trial has four spells: as before, other, other, as before. What changes steadily meanwhile changes both alike.
  static constexpr int kSpells = 4;
  [[nodiscard]] bool in_trial() const { return spell_ < kSpells; }
  [[nodiscard]] bool tries_other() const { return spell_ == 1 || spell_ == 2; }
  void begin_trial();
  void begin_spell(int spell);
  void end_spell(double pace);
  void end_trial(bool other_is_faster);

  int most_, size_, other_ = 1;
  bool fewer_ = true;                 // the next trial is of fewer threads
  int in_vain_ = 0;                   // trials since the size changed
  double since_ = 0.0, pause_ = 0.0;  // s, since the last trial; from that to the next
  int spell_ = kSpells, steps_ = 0;   // of the trial; in the spell
  double time_ = 0.0;                 // s, of the spell, without its first steps
  double lost_ = 0.0;                 // s, by the trial
  double fewer_time_ = 0.0, all_time_ = 0.0;
  std::array<double, kSpells> pace_{};  // s a step
};

}  // namespace voussoir::solver
