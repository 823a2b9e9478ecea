// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "cases/tables/blocks.h"

/// Table [base] of the case file, with its parts.
namespace voussoir::cases {

/// A part of the ground at another height, or a moving one: a rectangle in plan, or the ground under a wall of the house.
struct BasePart {
  std::optional<std::array<double, 2>> x, y;  // m
  std::string wall;                           // front | rear | left | right, or the name of an inner wall
  std::optional<double> from, to;             // m, along the wall from the outer corner; none: the ends of the wall
  double level = 0.0;                         // m, height of its top above Base::z
  std::optional<SupportMotion> motion;
};
struct Base {
  double z = 0.0;                        // m
  std::array<double, 2> tilt{0.0, 0.0};  // degrees about x and y; rotates gravity
  std::vector<BasePart> parts;           // key: part
};

}  // namespace voussoir::cases
