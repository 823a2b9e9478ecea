// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cases/case.h"
#include "solver/run/recorder.h"
#include "solver/world/world.h"

/// Forces through cuts: planes named in the case (output.cut), along which the structure is thought to be parted.
namespace voussoir::solver {

/// An element lies before a plane (where the normal points) or behind it by its centroid in the reference configuration; the base lies
/// below an element, on its vertical line. A cut's force is the sum over all pairs of elements, one on either side, that push or pull each
/// other, whether by a joint, by contact or by overlap, with their dashpots. With a box those pairs count whose middle (of the two
/// centroids; of an element and the base that of the centroid and its foot) lies in it. Ties count with what they do to what they hold
/// behind the plane, if they also hold something before it (the base by the hold's own point) and, with a box, if their middle lies in it.
class Cuts {
 public:
  Cuts() = default;
  /// \throw cases::InputError if a cut separates no initial contact between elements or with the base
  Cuts(const World& w, std::span<const cases::Cut> cuts);

  [[nodiscard]] bool any() const noexcept { return !cuts_.empty(); }
  /// In the order of the case. \pre the forces of the step have been computed with World::keep_pairs
  void measure(const World& w, std::vector<CutSample>& out) const;

 private:
  struct Crossing {
    std::int64_t side = 0;                // of a joint
    std::int32_t behind = 0, before = 0;  // elements; the base's row is the base
  };
  struct Plane {
    cases::Cut cut;
    std::vector<Crossing> crossings;      // ascending
    std::vector<std::int32_t> tie_holds;  // behind, of ties that cross; ascending, into Ties::hold
  };
  static void find_ties(const World& w, Plane& plane);
  [[nodiscard]] static int crosses(const World& w, const cases::Cut& cut, std::int32_t a, std::int32_t b);

  std::vector<Plane> cuts_;
};

}  // namespace voussoir::solver
