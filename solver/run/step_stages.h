// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/world/stage_order.h"
#include "solver/world/step_log.h"

/// The step as a list of stages: what each needs, and what it makes. Simulation::advance (simulation.cpp) runs them.
/// tests/solver/run/step_stages_test.cpp compares the list with the steps of runs, and with the picture in LIFE_OF_A_STEP.md.
namespace voussoir::solver {

namespace made {
inline constexpr std::uint32_t
    // Before the step.
    kPoses = 1U << 0,       // x(n), but of moved supports
    kVelocities = 1U << 1,  // v(n−½)
    kHistories = 1U << 2,   // of segments and contact points; which pairs may touch
    // In it.
    kSupports = 1U << 3,        // x(n) of moved supports
    kPairs = 1U << 4,           // which pairs may touch, now
    kLevels = 1U << 5,          // of pairs in contact
    kGatherLists = 1U << 6,     // which slots an element gathers
    kMoves = 1U << 7,           // the level at which a batch is moved on
    kOwnJoints = 1U << 8,       // forces of joints of a thread's own share, on rows of elements; what broke
    kAllJoints = 1U << 9,       // of all joints
    kSlots = 1U << 10,          // forces of contacts, in slots
    kOverlaps = 1U << 11,       // which bodies overlap, and by how much
    kContacts = 1U << 12,       // forces of contacts, on rows
    kBreaks = 1U << 13,         // what broke and came apart, sorted
    kBodies = 1U << 14,         // forces of overlapping bodies, on rows
    kTies = 1U << 15,           // forces of ties, on rows
    kDamage = 1U << 16,         // cracks; sides that came apart are patches; debris has lost its damping
    kImpulses = 1U << 17,       // forces of pairs of higher levels, on the rows of all others, with the impulse of their steps
    kFactor = 1U << 18,         // load factor of a quasi-static analysis
    kLoads = 1U << 19,          // forces on single elements, on rows
    kGround = 1U << 20,         // velocities of moved supports
    kNewVelocities = 1U << 21,  // v(n+½)
    kNewPoses = 1U << 22,       // x(n+1), travel bounds
    kWeights = 1U << 25,        // weights on rows, and the damping of a relaxation; else kick has them
    // For observers.
    kBooksBefore = 1U << 23, kVelocitiesBefore = 1U << 24;
inline constexpr std::uint32_t kAtFirst = kPoses | kVelocities | kHistories;
/// All forces between bodies, each counted once.
inline constexpr std::uint32_t kForces = kAllJoints | kContacts | kBodies | kTies;
}  // namespace made

struct StepStageEntry {
  StepStage stage;
  const char* function;        // in which it is done
  bool always;                 // else where the model or the observers of the step ask for it
  std::uint32_t needs, makes;  // of `made`
};

namespace detail {
using namespace made;
using enum StepStage;
inline constexpr StepStageEntry kStepStages[] = {
    {supports, "place_supports", true, kPoses, kSupports},
    {search, "search_contacts", false, kPoses | kSupports | kHistories, kPairs},
    {contact_levels, "renew_contact_levels", false, kPairs, kLevels},
    {gather_lists, "build_gather", false, kPairs | kLevels, kGatherLists},
    {moves, "renew_moves", false, kLevels | kGatherLists, kMoves},
    {own_joints, "advance_own_joints", true, kPoses | kSupports | kVelocities | kHistories, kOwnJoints},
    {contacts, "advance_contacts", true, kPoses | kSupports | kVelocities | kHistories | kPairs, kSlots},
    {overlaps, "find_overlaps", true, kPoses | kSupports | kPairs, kOverlaps},
    {late_joints, "help_with_joints", true, kOwnJoints, kAllJoints},
    {gather, "gather", true, kAllJoints | kSlots | kGatherLists, kContacts},
    {findings, "collect", true, kAllJoints, kBreaks},
    {overlap_forces, "apply_overlaps", true, kOverlaps | kContacts, kBodies},
    {ties, "apply_ties", true, kPoses | kSupports | kBodies, kTies},
    {cuts, "Cuts::measure", false, kForces, 0},
    {damage, "record_damage", true, kBreaks | kForces, kDamage},
    {base_forces, "measure_base_forces", false, kForces, 0},
    {impulses, "add_impulses", false, kForces | kMoves, kImpulses},
    {ledger_before, "before_kick", false, kForces | kDamage | kImpulses, kBooksBefore},
    {support_work, "add_support_work", true, kForces | kImpulses, 0},
    {velocities_before, "note_velocities", false, kVelocities, kVelocitiesBefore},
    {load_program, "advance", false, kForces, kFactor},
    {loads, "apply_loads", true, kFactor | kForces | kImpulses, kLoads},
    {support_velocities, "move_supports_on", true, kForces | kImpulses, kGround},
    {relaxation, "Relaxation::look", false, kForces | kDamage | kLoads, kWeights},
    {kick, "kick", true, kForces | kDamage | kImpulses | kLoads | kGround | kWeights, kNewVelocities},
    {samples, "take_samples", false, kPoses | kVelocitiesBefore | kNewVelocities, 0},
    {drift, "drift", true, kMoves | kNewVelocities, kNewPoses},
    {support_spins, "spin_supports", false, kGround | kNewPoses, 0},
    {ledger_after, "after_drift", false, kBooksBefore | kNewVelocities | kNewPoses, 0},
};
}  // namespace detail
inline constexpr auto& kStepStages = detail::kStepStages;
static_assert(in_order(kStepStages, made::kAtFirst), "a stage of the step comes before what it needs");

}  // namespace voussoir::solver
