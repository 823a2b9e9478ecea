// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cases/forward.h"
#include "cases/model.h"

/// Shortening of levers where contact points lie at the centres of segments: THEORY.md (2).
namespace voussoir::cases {

/// Walls of one thickness, or, with height 0, the coarsest joint of a model without walls.
struct Lever {
  double width = 0.0, height = 0.0;  // m; a wall's thickness and height, or the extent of the joint
  double segments = 0.0;             // number across `width`
  std::int32_t joint = -1;           // of the model; −1: a lever of walls

  /// Share of ½ width by which the lever is short: distance of the outermost points from the edge.
  [[nodiscard]] double short_by() const noexcept { return 1.0 / segments; }
};

/// Levers of the bearing walls of a house, then of the other walls if their thickness differs, each if one of them is built; without a
/// house, of [[wall]] by thickness; without either, of the joint with the fewest segments across either edge (the first of equals). Empty
/// under SegmentRule::rim, where no lever is short, and without a joint.
std::vector<Lever> levers(const Case& c, const Model& model);

}  // namespace voussoir::cases
