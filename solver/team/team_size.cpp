// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/team/team_size.h"

#include <algorithm>
#include <cmath>

#include "geometry/nth.h"

namespace voussoir::solver {

namespace {

constexpr int kFirstSteps = 3;       // of a spell, that do not count: rows have to come to the caches of other threads first
constexpr int kLeastSteps = 24;      // of a spell: in a collapse one step in a dozen has a search
constexpr double kLeastTime = 0.01;  // s, of a spell: where two programs share a core, each has it for some milliseconds at a time
constexpr double kShortest = 0.1;    // s, to the first trial, and to the next after one that changed the size
constexpr double kLongest = 4.0;     // s, but for ...
constexpr double kShare = 200.0;     // ... so many times what the last trial lost
constexpr double kFaster = 0.95;     // of the time: so much faster must the other size be
constexpr double kSlower = 1.05;     // of the time: then the trial ends early

}  // namespace

TeamSize::TeamSize(int most) : most_(std::max(most, 1)), size_(most_), pause_(kShortest) {}

void TeamSize::note(double time) {
  if (most_ == 1) return;
  all_time_ += time;
  if (size() < most_) fewer_time_ += time;
  if (!in_trial()) {
    since_ += time;
    if (since_ >= pause_) begin_trial();
    return;
  }
  if (++steps_ <= kFirstSteps) return;
  time_ += time;
  const int counted = steps_ - kFirstSteps;
  if (counted >= kLeastSteps && time_ >= kLeastTime) end_spell(time_ / counted);
}

void TeamSize::begin_trial() {
  if (size_ == most_) fewer_ = true;
  if (size_ == 1) fewer_ = false;
  other_ = fewer_ ? size_ - std::max(1, size_ / 4) : std::min(most_, size_ + std::max(1, size_ / 3));
  lost_ = 0.0;
  begin_spell(0);
}

void TeamSize::begin_spell(int spell) { spell_ = spell, steps_ = 0, time_ = 0.0; }

void TeamSize::end_spell(double pace) {
  nth(pace_, spell_) = pace;
  if (tries_other()) lost_ += steps_ * std::max(0.0, pace - pace_[0]);
  begin_spell(spell_ + 1);
  if (spell_ == 2 && pace_[1] > kSlower * pace_[0]) end_trial(false);
  if (spell_ == kSpells) end_trial(pace_[1] + pace_[2] < kFaster * (pace_[0] + pace_[3]));
}

void TeamSize::end_trial(bool other_is_faster) {
  begin_spell(kSpells);
  since_ = 0.0;
  if (other_is_faster) {
    size_ = other_, in_vain_ = 0, pause_ = kShortest;
    return;
  }
  fewer_ = !fewer_;
  pause_ = std::max(std::min(std::ldexp(kShortest, ++in_vain_), kLongest), kShare * lost_);
}

}  // namespace voussoir::solver
