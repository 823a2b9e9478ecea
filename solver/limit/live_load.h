// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cases/forward.h"
#include "geometry/vec3.h"
#include "solver/limit/contacts.h"

/// The forces of limit analysis: constant dead forces, and live forces, which are scaled by the multiplier.
namespace voussoir::solver {

/// Definition of the live load.
struct LiveLoad {
  enum class Kind : std::uint8_t {
    weight,  // the weight of bodies, as a force along `direction`
    force,   // a force of `force` along `direction` on each block of `on`, or at `at`
    loads,   // the growing [[load]]s of the case
  };
  Kind kind = Kind::weight;
  Vec3 direction{1.0, 0.0, 0.0};  // unit vector
  std::vector<std::string> on;    // names of blocks, stones or groups; for weights, empty means all bodies
  double force = 1000.0;          // N
  std::optional<Vec3> at;         // m, a point of the block of `on`, or (if none is named) of the block that contains it
};

/// By body: forces [N], and moments about its centre of mass [N m].
struct BodyForces {
  std::vector<Vec3> force, moment;
};

struct LimitForces {
  BodyForces dead, live;
  double weight = 0.0;  // N, of all bodies
  double length = 1.0;  // m, a mean lever, by which moments are divided for comparison with forces
};

/// Forces on all bodies. \throw cases::InputError for loads with a history, names of no block, live loads without a force, and growing
/// loads beside another live load
LimitForces limit_forces(const cases::Case& c, const cases::Model& model, const LimitContacts& contacts, const LiveLoad& live);

/// Direction of a corner of the friction cones: along the live load, for growing loads along their sum. Zero if the sum is zero.
Vec3 main_direction(const cases::Case& c, const LiveLoad& live);

}  // namespace voussoir::solver
