// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/house/house_plan.h"

/// Heights of the courses. Internal to cases/.
namespace voussoir::cases {

/// Lays out HousePlan::courses, equal for all walls. Between consecutive levels (foot and top of the walls, sills, heads, tops of lintels)
/// lie whole courses; the remaining height is a course of cut bricks, or, below half a course, is shared with the last whole course.
/// \pre each opening has been checked
/// \throw InputError with the key at fault and the nearest value that fits: two levels nearer than half a course.
void plan_courses(const House& house, HousePlan& plan);

}  // namespace voussoir::cases
