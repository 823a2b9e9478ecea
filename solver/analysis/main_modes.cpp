// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/analysis/main_modes.h"

#include "cases/case.h"
#include "geometry/nth.h"
#include "solver/setup/setup.h"

namespace voussoir::solver {

std::array<MainMode, 2> main_modes(const cases::Case& c, const cases::Model& model, DryJoints dry) {
  constexpr double kMechanism = 1e-3;  // Hz
  cases::Case undamped = c;
  undamped.damping = {};
  const std::vector<Mode> modes = natural_modes(*build_world(undamped, model, {}), kMainModesOf, dry);
  std::array<MainMode, 2> found;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const std::array share{modes[i].mass_share.x, modes[i].mass_share.y};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      MainMode& best = found[axis];
      if (share[axis] < kLeastMassShare || share[axis] <= best.mass_share || modes[i].frequency < kMechanism) continue;
      best = {static_cast<int>(i) + 1, modes[i].frequency, share[axis]};
    }
  }
  return found;
}

std::array<MainMode, 2> main_modes_of_all(const cases::Case& c, const cases::Model& model, DryJoints dry) {
  cases::Case undamped = c;
  undamped.damping = {};
  const auto world = build_world(undamped, model, {});
  std::array<MainMode, 2> found;
  for (int axis = 0; axis < 2; ++axis) {
    const std::vector<Mode> modes = modes_along(*world, axis, 1, dry);
    if (modes.empty()) continue;
    const double share = axis == 0 ? modes.front().mass_share.x : modes.front().mass_share.y;
    if (share >= kLeastMassShare) nth(found, axis) = {0, modes.front().frequency, share};
  }
  return found;
}

}  // namespace voussoir::solver
