// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "io/output/measures/capacity/capacity.h"
#include "solver/analysis/drive.h"
#include "solver/run/run.h"
#include "tests/solver/no_rows.h"
#include "tests/verification/fixture.h"

/// Quasi-static analyses in-process: the run of a case, and what `voussoir summary` would say of it but for the mechanism.
namespace voussoir::testing {

class AssessmentRows final : public testing::NoRows {
 public:
  void history(double, std::span<const solver::HistorySample> points) override {
    if (!points.empty()) path.push_back(points.front().displacement);
  }
  void energy(const solver::EnergyRow& e) override {
    if (e.time < 0.0) return;
    curve.input.push_back(e.input), curve.kinetic.push_back(e.kinetic), curve.damping.push_back(e.damping);
    curve.losses.push_back(e.dashpot + e.friction + e.fracture + e.damping);
    curve.stored.push_back(e.kinetic + e.strain + e.contact + e.gravity);
  }
  void drive(const solver::Drive& d) override { chosen = d; }
  void assessment(const solver::AssessmentRow& r) override {
    curve.time.push_back(r.time), curve.factor.push_back(r.factor), curve.displacement.push_back(r.displacement);
    curve.drift.push_back(r.drift), curve.moved.push_back(r.moved), curve.base_shear.push_back(r.base_shear);
    curve.support_moved.push_back(r.support_moved), curve.over.push_back(r.over);
    if (!std::isnan(r.unbalanced)) curve.unbalanced.push_back(r.unbalanced);
  }

  io::CapacityCurve curve;
  solver::Drive chosen;
  std::vector<Vec3> path;  // m, of the first followed point from time zero
};

/// \param rows  if not null: what the run has told
inline io::Capacity assess(const cases::Case& c, AssessmentRows* rows = nullptr) {
  const cases::Model m = cases::build_model(c);
  solver::Options o;
  o.threads = 1;
  o.reference_kernels = reference_kernels();
  solver::Simulation sim(c, m, {}, o);
  solver::choose_drive(sim, c);
  AssessmentRows out;
  solver::RunState plan;
  solver::run(sim, plan, c, c.end(), out, [](const solver::RunStatus&) { return true; });
  if (rows != nullptr) *rows = out;
  return io::capacity_of(c.analysis.kind, c.analysis.drop, out.chosen.pace, out.chosen.weight, out.chosen.quiet, out.curve);
}

}  // namespace voussoir::testing
