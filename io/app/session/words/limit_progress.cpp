// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/session/words/limit_progress.h"

#include <cstdio>

#include "geometry/message.h"

namespace voussoir::io {

namespace {
constexpr std::chrono::seconds kBetweenLines{10};  // of a log
}

LimitProgress::LimitProgress(bool quiet, bool coulomb)
    : mode_(Progress::mode_for(2, quiet)),
      least_(coulomb ? solver::LimitResult::kLeastProgrammes : 1),
      most_(coulomb ? solver::LimitResult::kMostProgrammes : 1) {}

LimitProgress::~LimitProgress() {
  if (pending_) std::fputc('\n', stderr);
}

void LimitProgress::watch(solver::LimitOptions& options) {
  if (mode_ == Progress::Mode::quiet || mode_ == Progress::Mode::json) return;
  options.tick = [this](int programmes, double multiplier) { took(programmes, multiplier); };
  options.iterated = [this](int iteration, double gap) { iterated(iteration, gap); };
}

void LimitProgress::took(int programmes, double multiplier) {
  const std::string of = least_ == most_ ? std::to_string(most_) : geometry::printed("%d to %d", least_, most_);
  write(geometry::printed("linear programme %d of %s: multiplier %.5f", programmes, of.c_str(), multiplier).c_str());
}

void LimitProgress::iterated(int iteration, double gap) {
  write(geometry::printed("solving a linear programme: iteration %d, relative gap %.1e", iteration, gap).c_str());
}

void LimitProgress::write(const char* text) {
  if (mode_ == Progress::Mode::terminal) {
    std::fprintf(stderr, "\r%-72s", text);
    pending_ = true;
  } else if (Clock::now() - last_ >= kBetweenLines) {
    std::fprintf(stderr, "%s\n", text);
    last_ = Clock::now();
  }
}

}  // namespace voussoir::io
