// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "solver/run/recorder.h"

namespace voussoir::testing {

/// A recorder that keeps nothing; tests override what they look at.
class NoRows : public solver::Recorder {
 public:
  void history(double /*time*/, std::span<const solver::HistorySample> /*samples*/) override {}
  void energy(const solver::EnergyRow& /*row*/) override {}
  void forces(const solver::ForcesRow& /*row*/) override {}
  void damage(const solver::DamageRow& /*row*/) override {}
  void cracks(std::span<const solver::CrackRow> /*rows*/) override {}
  void frame(const solver::FrameView& /*frame*/) override {}
  void summary(const solver::Summary& /*s*/) override {}
};

}  // namespace voussoir::testing
