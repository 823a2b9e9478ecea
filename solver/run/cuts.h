// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cases/tables/output.h"
#include "solver/run/recorder.h"
#include "solver/world/world.h"

/// Forces through cuts: planes named in the case (output.cut) that divide the structure into two parts.
namespace voussoir::solver {

/// The centroid of an element in the reference configuration decides whether it is before the plane (where the normal points) or behind it;
/// the base counts as the point vertically below an element. A cut's force is the sum over all pairs of elements on opposite sides, by
/// joints, contact and overlap, with their dashpots. With a box, only pairs with their middle in the box count (that of the two centroids;
/// for an element and the base, of the centroid and the point below). The force of a tie on elements behind the plane counts if the tie
/// also holds an element before it (for the base, the hold's own point decides) and, with a box, if the tie's middle is in the box.
class Cuts {
 public:
  Cuts() = default;
  /// \throw cases::InputError if a cut separates no initial contact between elements or with the base
  Cuts(const World& w, std::span<const cases::Cut> cuts);

  [[nodiscard]] bool any() const noexcept { return !cuts_.empty(); }
  /// Measures all cuts, in the order of the case. \pre the forces of the step have been computed with World::keep_pairs
  void measure(const World& w, std::vector<CutSample>& out) const;

 private:
  struct Crossing {
    std::int64_t side = 0;                // of a joint
    std::int32_t behind = 0, before = 0;  // elements; the base's row is the base
  };
  struct Plane {
    cases::Cut cut;
    std::vector<Crossing> crossings;      // ascending
    std::vector<std::int32_t> tie_holds;  // holds behind the plane of ties that cross it; ascending, indices into Ties::hold
  };
  static void find_ties(const World& w, Plane& plane);
  [[nodiscard]] static int crosses(const World& w, const cases::Cut& cut, std::int32_t a, std::int32_t b);

  std::vector<Plane> cuts_;
};

}  // namespace voussoir::solver
