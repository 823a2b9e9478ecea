// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cases/house/house_plan.h"

/// Heights of the courses. Internal to cases/.
namespace voussoir::cases {

/// A height at which a course must end, and the key that requires it.
struct Level {
  Tick at = 0;
  std::string key;                  // empty: the foot of the walls
  double value = 0.0;               // of the key, m
  bool is_size = false;             // the key is a height above another level, so above zero
  int sign = 1;                     // the level moves up (1) or down with the value
  int on = -1;                      // index of the level that this one is measured from, and moves with; -1: none
  Tick below = 0;                   // what moves with it ends another course so far below it
  std::vector<Interval> allowed{};  // where it may be; empty: anywhere
};

/// Refuses levels too near to an earlier one that is kept. \param lowest  course \return those that are kept
std::vector<Level> kept_levels(const std::vector<Level>& levels, Tick lowest, Faults& faults);

/// Lays out HousePlan::courses, equal for all walls. Between consecutive levels (foot and top of the walls, sills, heads, tops of lintels)
/// lie whole courses; the remaining height is a course of cut bricks, or, below half a course, is shared with the last whole course.
/// \pre each opening has been checked
/// \throw InputError with the key at fault and the nearest value that fits: two levels nearer than half a course.
void plan_courses(const House& house, HousePlan& plan);

}  // namespace voussoir::cases
