// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace voussoir::solver {

/// Bounds on the rate at which dashpots slow an element (THEORY.md (20)), constants. The bound of now, BodyConstants::beta, is that of the
/// faces that have something near (contact/near_faces.h).
struct DashpotBounds {
  std::vector<double> all;  // 1/s, by element: with all its faces in contact
  std::vector<double> face;  // 1/s, by index into World::faces: with that face alone
};

}  // namespace voussoir::solver
