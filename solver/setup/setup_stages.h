// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "cases/forward.h"
#include "solver/setup/setup.h"
#include "solver/world/stage_order.h"

/// The set-up as a list of stages over one World. Any order that their needs allow makes the same world, bit by bit
/// (tests/solver/setup/setup_stages_test.cpp).
namespace voussoir::solver {

/// What stages make.
namespace part {
inline constexpr std::uint32_t kStep = 1U << 0,  // World::dt, bound
    kFriction = 1U << 1,                         // World::friction, contact
    kElements = 1U << 2,                         // mass, inertia, extent, poses at rest
    kFaces = 1U << 3,                            // World::faces, most_faces
    kDashpotBound = 1U << 4,                     // β of bodies (THEORY.md (20))
    kLevels = 1U << 5,                           // Multirate
    kSides = 1U << 6,                            // who is in which lane, constants, state; bonds of elements; points of joints
    kPatches = 1U << 7,                          // free patches; points of theirs, behind those of joints
    kSideViews = 1U << 8,                        // Sides::parts look at their points and their segments' state
    kShapes = 1U << 9,                           // Overlaps
    kLaws = 1U << 10,                            // Sides::laws, law_state
    kPairBuffer = 1U << 11,                      // Sides::pair_*, gather
    kTies = 1U << 12, kLoads = 1U << 13, kTravel = 1U << 14;
}  // namespace part

struct SetUpStage {
  const char* name;
  std::uint32_t needs, makes;  // of `part`
  void (*run)(World& w, const cases::Case& c);
};

/// Those of build_world, in its order.
std::span<const SetUpStage> setup_stages();

/// The same world by the stages in another order.
std::unique_ptr<World> build_world(const cases::Case& c, const cases::Model& m, const Options& o, std::span<const SetUpStage> stages);

}  // namespace voussoir::solver
