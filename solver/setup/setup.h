// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "cases/case.h"
#include "solver/world/world.h"

/// From the model to the arrays of the step.
namespace voussoir::solver {

/// The step of a run [s]: as given, or the largest ≤ 0.995 × bound (Eq. 19, see cases/census.h) of which whole cycles
/// of multi-rate stepping (else whole steps) make history_interval.
double choose_step(const cases::Case& c, const Options& o, double bound);

/// Builds the world at rest in the reference configuration. `m` must outlive it.
/// \throw cases::InputError where data that belong together do not (a mortar thicker than its bricks, a load on an unknown block)
std::unique_ptr<World> build_world(const cases::Case& c, const cases::Model& m, const Options& o);

/// The rooms of build_world, in the order they are called.
void set_up_elements(World& w, const cases::Case& c);
void set_up_faces(World& w);
void set_up_damping_bound(World& w);
/// The levels of all elements, for a case with multi-rate stepping. \pre elements
void set_up_multirate(World& w, const cases::Case& c);
/// m, by which an element is searched earlier, because a search waits for the first step of a cycle: what one that flies moves meanwhile,
/// but a small part of the skin at most (THEORY.md, section 7, "Late pairs").
[[nodiscard]] double search_margin(const World& w, double skin);
/// Pairs of elements that are joined, or that may touch.
using Pairs = std::vector<std::pair<std::int32_t, std::int32_t>>;
/// Lowers levels of elements until those of neighbours differ by one at most.
void grade(std::vector<std::uint8_t>& level, const Pairs& neighbours);
void set_up_sides(World& w, const cases::Case& c);
void set_up_patches(World& w);
void set_up_overlaps(World& w);
/// Points each side at its points and its segments' history, when all arrays have their size.
void set_up_side_views(World& w);
/// How bonds soften, and what each has gone through, where a law asks for it. \pre sides have their views
void set_up_softening(World& w);
/// Which joints stiffen as they close, and how.
void set_up_closing(World& w);
/// How contacts give way under pressure, as the case says it.
kernels::Crushing crushing_of(const cases::Contact& c);
/// What each segment has gone through of it. \pre sides have their views
void set_up_crushing(World& w, const cases::Contact& c);
/// Room for the forces of sides, where cuts ask for them.
void set_up_pair_forces(World& w, const cases::Case& c);
/// Ties, their stiffness no more than the step allows. \pre sides have their views
void set_up_ties(World& w);
void set_up_loads(World& w, const cases::Case& c);

/// The velocities that the case gives its blocks for time zero, all others zero. \pre orientations are as they stand
void set_initial_velocities(World& w);

/// Room for so many free patches and their points in all. Without it arrays end with up to twice of what they need.
void reserve_patches(World& w, std::size_t patches, std::size_t points);
/// Appends a free patch with no partners.
void append_patch(World& w, const kernels::Patch& patch, std::int32_t set, std::int32_t from_side, bool mastered);

}  // namespace voussoir::solver
