// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/schedule/joint_tasks.h"

namespace voussoir::solver {

/// Measures the addition of forces to the elements' rows, which cannot be timed within the kernels: after a step, adds zeros for all
/// joints, in the order of a step and by a team of the same size. Changes no results.
/// \param tasks  separate ones, since the shares of the step adapt to measured times
/// \return mean time of a thread without waiting [s]
double assembly_time(World& w, JointTasks& tasks);

}  // namespace voussoir::solver
