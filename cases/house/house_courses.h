// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/house/house_plan.h"

/// Heights of the courses. Internal to cases/.
namespace voussoir::cases {

/// Lays out HousePlan::courses, the same all round the house. From each level at which something begins or ends (foot and top of the walls,
/// sills, heads, tops of lintels) whole courses go up to the next; what is left is a course of cut bricks, or, below half a course, shares
/// its height with the last whole one.
/// \pre the openings have been checked by themselves
/// \throw InputError with the key at fault and the nearest value that fits: two levels nearer than half a course.
void plan_courses(const House& house, HousePlan& plan);

}  // namespace voussoir::cases
