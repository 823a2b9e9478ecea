// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "cases/forward.h"
#include "cases/model.h"
#include "cases/tables/loads.h"

/// Loads and the elements on which they act.
namespace voussoir::cases {

/// Checks that every load names a free-standing block that can move. \throw InputError with the key at fault.
void check_loads(const Case& c);

/// The unit vector along which a quasi-static analysis measures displacement and drift: analysis.direction; where the loads that grow are
/// vertical, their direction.
Vec3 push_direction(const Case& c);

/// The share of a load on one element.
struct LoadShare {
  std::int32_t element = 0;
  double part = 1.0;  // fraction of the load's force and moment
  Vec3 point;         // m, point of action of this share
};

/// The elements on which load `index` acts: a block, a stone, or each stone of a group, if free to move. A block in cells or a stone in
/// pieces bears the load as a whole: at Load::at on the part that contains the point (the first of two), else shared by mass, each share at
/// the centroid of its part, so that the resultant goes through the centroid of the whole.
/// Without a name, the first element that the force meets from Load::at on.
/// \throw InputError at load[index].block if nothing has that name, or everything with that name is fixed, so that the load would have no
/// effect; at load[index].at if a load without a name meets nothing that can move
std::vector<LoadShare> load_shares(const Model& model, const Load& load, std::size_t index);

/// The share of a load that acts on the first element that its force meets from a point on. \param from  m, relative to the model's origin
/// \throw InputError at `key` if it meets nothing that can move
LoadShare share_met(const Model& model, const Load& load, Vec3 from, const std::string& key);

}  // namespace voussoir::cases
