// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cases/forward.h"
#include "geometry/vec3.h"
#include "kernels/rows.h"

/// Ties in limit analysis: forces along the line between their ends as it is at first, up to the force at which they yield.
namespace voussoir::solver {

struct LimitContacts;

struct LimitTie {
  struct Hold {
    std::int32_t body = -1;  // −1: fixed
    double share = 0.0;      // of the force; the shares of an end sum to 1
    Vec3 at;                 // m
  };
  std::int32_t number = 0;  // in cases::Model::ties
  std::array<std::vector<Hold>, 2> ends;
  Vec3 along;          // unit vector from the first end to the second
  double most = 0.0;   // N, tension at which it yields; infinite: never
  double least = 0.0;  // N, compression at which it yields, <= 0
};

/// What a tie does to a body per newton of tension.
struct TiePull {
  std::int32_t body = 0;
  Vec3 force, moment;  // -; m, about the body's centre
};

/// The ties of a model that hold bodies which can move, and not one alone. \param body_of  by element; −1: fixed
std::vector<LimitTie> limit_ties(const cases::Model& model, const std::vector<std::int32_t>& body_of);

/// Pulls of a tie, each body once; fixed ones are left out.
std::vector<TiePull> pulls_of(const LimitTie& tie, const LimitContacts& contacts);

/// Speed at which a tie gets longer in a motion of the bodies.
double stretching(const LimitTie& tie, const LimitContacts& contacts, const std::vector<kernels::Twist>& motion);

}  // namespace voussoir::solver
