// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "cases/walls/wall_plan.h"

/// Where beams end in a layer of bricks. Internal to cases/.
namespace voussoir::cases {

/// A place in a layer that the same beams fill all along: one, or two from both sides of the wall. Places may touch.
struct FilledPlace {
  LegCut low, high;
  std::size_t floor = 0, other = 0;         // of the case: the last and the first of those whose beams are here
  std::vector<std::array<double, 2>> rest;  // m, ranges of d that bricks fill beside the beams
  bool crossed = false;                     // two beams would be in one place
};

/// The beams that reach into a layer of a leg, ascending. \param height  of the course \param from, to  range of d of the layer
std::vector<FilledPlace> beams_in_layer(const Leg& leg, Interval height, double from, double to);

}  // namespace voussoir::cases
