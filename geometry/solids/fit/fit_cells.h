// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/separation.h"
#include "geometry/solids/fit/fit_work.h"

/// Planes of a stone whose face has several neighbours. Internal to geometry/solids/fit/.
namespace voussoir::geometry {

/// What one neighbour asks of a face.
struct FaceShare {
  std::size_t face = 0;
  HalfSpace plane;         // outward
  std::vector<Vec3> area;  // convex polygon in that plane, where both touch
};

/// The planes of the cells that a convex body is cut into, so that each share keeps nine tenths of its area under the planes of the others;
/// mostly there is one cell. A cell has the planes of the shares in it, of faces without any share their own, and the cuts around it.
/// \param own  planes of all faces of the body \param stone  of the body \throw ModelError as FitWork
std::vector<std::vector<HalfSpace>> fitted_cells(std::span<const HalfSpace> own, std::span<const FaceShare> shares, FitWork& work,
                                                 std::int32_t stone);

}  // namespace voussoir::geometry
