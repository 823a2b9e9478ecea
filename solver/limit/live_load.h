// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cases/case.h"
#include "cases/model.h"
#include "solver/limit/contacts.h"

/// The forces of limit analysis: dead ones, which stay, and live ones, which the multiplier multiplies.
namespace voussoir::solver {

/// What the multiplier multiplies.
struct LiveLoad {
  enum class Kind : std::uint8_t {
    weight,  // the weight of bodies, as a force along `direction`
    force,   // a force of `force` along `direction` on each block of `on`, or at `at`
    loads,   // the [[load]]s of the case that grow
  };
  Kind kind = Kind::weight;
  Vec3 direction{1.0, 0.0, 0.0};  // unit vector
  std::vector<std::string> on;    // names of blocks, stones or groups; of weights: empty for all bodies
  double force = 1000.0;          // N
  std::optional<Vec3> at;         // m, a point of the block of `on`, or (none is named) of the block that holds it
};

/// Of each body: forces [N], and moments about its centre of mass [N m].
struct BodyForces {
  std::vector<Vec3> force, moment;
};

struct LimitForces {
  BodyForces dead, live;
  double weight = 0.0;  // N, of all bodies
  double length = 1.0;  // m, a mean lever: moments over it are compared with forces
};

/// \throw cases::InputError for loads with a history, names of no block, live loads without a force, and growing loads beside another live
/// load
LimitForces limit_forces(const cases::Case& c, const cases::Model& model, const LimitContacts& contacts, const LiveLoad& live);

/// Where the friction cones have a corner: along the live load, of growing loads along their sum. Zero if that is nothing.
Vec3 main_direction(const cases::Case& c, const LiveLoad& live);

/// Where a force that comes along `direction` meets the model: at `from`, if that lies in an element, else on the first one that it hits.
struct LoadedPlace {
  std::int32_t element = -1;  // −1: it hits nothing
  Vec3 at;
};
LoadedPlace place_of_load(const cases::Model& model, Vec3 from, Vec3 direction);

}  // namespace voussoir::solver
