// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "cases/forward.h"
#include "cases/motion.h"
#include "io/output/results/results_model.h"

/// The motion of the base as applied to the model: the group /motion of run.h5.
namespace voussoir::io {

/// The base at one time, in axes of the case.
struct BaseRow {
  double time = 0.0;                          // s
  Vec3 acceleration, velocity, displacement;  // m/s2, m/s, m
};

/// Motion of the base, row by row. Accelerations are linear between the samples and zero after the last one (cases::acceleration_at), as in
/// the solver; velocity and displacement are exact integrals from rest at time zero. Calls `take` at every `every`-th step of `dt` [s],
/// from 0 to `last`.
void base_motion(const cases::GroundMotion& motion, double dt, std::int64_t every, std::int64_t last,
                 const std::function<void(const BaseRow&)>& take);

/// The datasets of /motion: rows at the times of /history, up to the case's duration. Their values are made anew whenever they are written:
/// the memory that they take does not grow with the duration.
/// \param dt  the step of the run [s] \param cycle  Simulation::cycle of the run \return empty for a case without motion
std::vector<StaticDataset> motion_datasets(const cases::Case& c, const cases::GroundMotion& motion, double dt, std::int64_t cycle);

}  // namespace voussoir::io
