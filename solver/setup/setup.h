// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "cases/forward.h"
#include "cases/tables/contact.h"
#include "solver/world/world.h"

/// Builds the arrays of the step from the model.
namespace voussoir::solver {

/// Of the bound of Eq. 19, what a chosen step takes with contact.restitution. Of bodies of the stiffest elements a restitution of 1 is off
/// by up to 0.06 at the whole bound, depending on the instant at which they meet, by 0.01 at half of it.
inline constexpr double kImpactShare = 0.5;
/// Share of the bound of Eq. 19 that a chosen step takes.
double share_of_bound(const cases::Case& c) noexcept;

/// The step of a run [s]: the given one, or the largest ≤ 0.995 × bound (Eq. 19, see cases/census.h) × its share such that a whole number
/// of cycles of multi-rate stepping (else of steps) makes history_interval.
double choose_step(const cases::Case& c, const Options& o, double bound);

/// Builds the world at rest in the reference configuration. `m` must outlive it.
/// \throw cases::InputError for inconsistent data (mortar thicker than its bricks, a load on an unknown block)
std::unique_ptr<World> build_world(const cases::Case& c, const cases::Model& m, const Options& o);

/// What the stages of build_world do; their order and what each needs stands in setup_stages.h.
void set_up_elements(World& w, const cases::Case& c);
void set_up_faces(World& w);
void set_up_damping_bound(World& w);
/// The levels of all elements, for a case with multi-rate stepping.
void set_up_multirate(World& w, const cases::Case& c);
/// Elements evaluated in a time of dt at this `time.multirate`, over those at one rate; nothing where the case has one rate only. Above 1
/// where whole cycles need a shorter step.
[[nodiscard]] std::optional<double> share_evaluated(const World& w, const cases::Case& c, int multirate);
/// Distance [m] by which an element is searched earlier, since a search waits for the first step of a cycle: the travel of a flying element
/// meanwhile, but at most a small part of the skin (THEORY.md, section 7, "Late pairs").
[[nodiscard]] double search_margin(const World& w, double skin);
/// Pairs of elements that are joined, or that may touch.
using Pairs = std::vector<std::pair<std::int32_t, std::int32_t>>;
/// Lowers levels of elements until neighbours differ by at most one.
void grade(std::vector<std::uint8_t>& level, const Pairs& neighbours);
void set_up_sides(World& w, const cases::Case& c);
void set_up_patches(World& w);
void set_up_overlaps(World& w);
/// Points each side at its points and its segments' history.
void set_up_side_views(World& w);
/// How contacts give way under pressure, as the case says it: the one optional law (laws/optional_laws.h) that free patches follow too.
kernels::Crushing crushing_of(const cases::Contact& c);
/// Memory for the forces of sides, if cuts need them.
void set_up_pair_forces(World& w, const cases::Case& c);
/// Ties, their stiffness no more than the step allows.
void set_up_ties(World& w);
void set_up_loads(World& w, const cases::Case& c);

/// Sets the velocities that the case gives its blocks at time zero, all others to zero. \pre orientations are current
void set_initial_velocities(World& w);

/// Reserves memory for a total number of free patches and of their points. Otherwise arrays end with up to twice the necessary size.
void reserve_patches(World& w, std::size_t patches, std::size_t points);
/// Appends a free patch without partners.
void append_patch(World& w, const kernels::Patch& patch, std::int32_t set, std::int32_t from_side, bool mastered);

}  // namespace voussoir::solver
