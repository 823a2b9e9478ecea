// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cases/forward.h"
#include "cases/model.h"
#include "cases/tables/loads.h"

/// Loads and the elements on which they act.
namespace voussoir::cases {

/// Checks that every load names a free-standing block that can move. \throw InputError with the key at fault.
void check_loads(const Case& c);

/// Along which displacements and drifts of a quasi-static analysis count: analysis.direction, but the way of the loads that grow where they
/// are vertical. Unit.
Vec3 push_direction(const Case& c);

/// The share of a load on one element.
struct LoadShare {
  std::int32_t element = 0;
  double part = 1.0;  // fraction of the load's force and moment
  Vec3 point;         // m, point of action of this share
};

/// The elements on which load `index` acts: a block, a stone, or each stone of a group, if free to move. A block in halves or a stone in
/// pieces bears the load as a whole: at Load::at on the part that contains the point (the first of two), else shared by mass, each share at
/// the centroid of its part, so that the resultant goes through the centroid of the whole.
/// Without a name, the first element that the force meets from Load::at on.
/// \throw InputError at load[index].block if nothing has that name, or everything with that name is fixed, so that the load would have no
/// effect; at load[index].at if a load without a name meets nothing that can move
std::vector<LoadShare> load_shares(const Model& model, const Load& load, std::size_t index);

/// A station of a load that moves: the share of the element that it meets there, and the force on it over time.
struct MovingShare {
  LoadShare share;
  SupportHistory force;  // N, in place of m
};

/// The stations of a load that moves along a path. From each to the next the force passes linearly in time, so that resultant force and
/// moment are those of a force that moves evenly from one to the other.
/// \param path  t, and places [m] in the axes of the case file
/// \throw InputError at load[index].path if the force meets nothing that can move at one of them
std::vector<MovingShare> moving_shares(const Model& model, const Load& load, std::size_t index, const SupportHistory& path);

}  // namespace voussoir::cases
