// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "cases/forward.h"
#include "geometry/polyhedron.h"

/// The origin of a model: a point of the file's axes near the model. Inside the program all coordinates are relative to it, so a model far
/// from the origin of its axes is computed as well as one that stands there.
namespace voussoir::cases {

inline constexpr double kFarthest = 1e7;  // m, greatest coordinate of what a model is made of

/// Refuses coordinates of blocks, house, base and stones beyond kFarthest. \pre Case::origin is not chosen yet
/// \throw InputError with the key at fault
void check_reach(const Case& c);

/// The origin that suits a case. Of each axis: zero where the model reaches nearer to zero than 100 m or its own length; else its least
/// coordinate, rounded to a metre. Every coordinate of the model, less the origin, is then a double without rounding.
/// \param stones  boxes of stones from files that are not in the case yet \pre Case::origin is not chosen yet
Vec3 suitable_origin(const Case& c, std::span<const geometry::Box3> stones = {});

/// The case with its coordinates relative to `origin`. \pre Case::origin is not chosen yet
void move_origin(Case& c, Vec3 origin);

/// The case with the coordinates of its file again: those of the model bit for bit; points far off the model, to the round-off of the
/// model's distance.
Case as_in_file(Case c);

/// What a message that says places adds where they are relative to another origin than the file's; else nothing.
std::string origin_note(Vec3 origin, const std::string& message);

}  // namespace voussoir::cases
