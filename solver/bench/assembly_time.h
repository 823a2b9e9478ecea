// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/schedule/joint_tasks.h"

namespace voussoir::solver {

/// After a step: adds zeros to the elements' rows for all joints, in the order of a step and by a team of the same size. This
/// changes nothing and takes what adding the forces takes alone, which cannot be timed within the kernels.
/// \param tasks  of its own, or the shares of the step would follow what this takes
/// \return s, of the mean thread, without its waiting
double assembly_time(World& w, JointTasks& tasks);

}  // namespace voussoir::solver
