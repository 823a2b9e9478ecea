// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "cases/loads/loads.h"

/// A load that moves along a path (Load::path), as fixed loads whose forces come and go.
namespace voussoir::cases {

/// A point of the path (station): the element that the load acts on there, and the force on it over time.
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
