// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdint>
#include <numbers>

#include "solver/run/simulation.h"

// The part of a step that relaxation adds, and what a state of rest means for the path.
namespace voussoir::solver {

/// Adds the weights, measures how far the structure is from rest, and goes on along the path.
void Simulation::relax() {
  const Vec3 gravity = gravity_at(static_cast<double>(step_) * world_->dt);
  lead_.step(path_.pull());  // 0 while settling
  relaxation_.look(*world_, phase_ == Phase::settling ? gravity : gravity + program_.acceleration(), path_.pull() > 0.0, lead_);
  if (phase_ == Phase::shaking) path_.iterated(program_.factor());
}

void Simulation::accept_rest() {
  const World& w = *world_;
  const double sense = program_.sense();
  program_.rest_at(w, -dot(forces_.base_shear, program_.across()), step_);
  lead_.accept(w, program_.sense() == sense ? path_.increment() : 0.0);
  RestPoint p{.factor = program_.factor(), .done = program_.way(), .left = program_.way_left()};
  if (!w.supports.empty() && program_.analysis().kind == cases::AnalysisKind::settlement) {
    p.done = path_.clock(), p.left = program_.last_support() - path_.clock();
    if (p.left <= 0.0) program_.end_at(step_);
  }
  p.broken = damage_.tension + damage_.shear + damage_.compression, p.slipped = damage_.slipped;
  for (const std::int32_t bonds : w.elements.bonds_at_start) p.bonds += bonds;
  path_.accept(p, 2.0 * std::numbers::pi / std::max(relaxation_.frequency() * w.dt, 1e-6), lead_.open());
}

}  // namespace voussoir::solver
