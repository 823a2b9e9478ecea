// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "solver/run/run.h"

/// What a run tells its Recorder.
namespace voussoir::solver {

/// Keeps the buffers and the running figures of one run.
class Reporter {
 public:
  Reporter(Simulation& sim, RunState& state, Recorder& out) : sim_(sim), state_(state), out_(out) {}

  void frame() { take_frame(), tell_frame(); }
  /// Copies poses, to be told of later if they turn out to be a state of rest.
  void take_frame();
  void tell_frame() { out_.frame({frame_time_, displacement_, quaternion_, broken_}); }
  void samples(double time);
  void ledger(double time);
  void cracks();

 private:
  void ties(double time);

  Simulation& sim_;
  RunState& state_;
  Recorder& out_;
  std::vector<TieSample> ties_;
  std::vector<CrackRow> cracks_;
  double frame_time_ = 0.0;  // s
  std::vector<float> displacement_, quaternion_, broken_;
};

}  // namespace voussoir::solver
