// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "geometry/vec3.h"

/// Table [output] of the case file, with what is followed and cut.
namespace voussoir::cases {

struct HistoryPoint {
  std::string name;
  Vec3 point;  // m
};
/// A plane through the structure; the force through it is written (Output::cuts).
struct Cut {
  std::string name;
  Vec3 point, normal{0, 0, 1};             // m; normal of any length but zero, towards the part that exerts the force
  std::optional<std::array<Vec3, 2>> box;  // m, two corners: only pairs of elements with their middle in the box count
};
struct Output {
  double history_interval = 0.001;       // s
  std::optional<double> frame_interval;  // s; absent = "auto", see cases/census.h
  double ledger_interval = 0.01;         // s: rows of /energy, /forces, /damage
  std::vector<HistoryPoint> history;
  std::vector<Cut> cuts;  // key: cut
};

}  // namespace voussoir::cases
