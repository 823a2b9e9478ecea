// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "cases/house/house_case.h"
#include "cases/input_error.h"

/// Rods and meshes of a house as points in axes of the case, before the elements that they hold are known.
namespace voussoir::cases {

/// A tie with its ends, and the index of its entry in House::ties.
struct PlannedTie {
  Tie tie;
  std::size_t index = 0;
};

/// Refuses ties that name walls which are not there, or heights above the house. If the house itself cannot be laid out, nothing is
/// checked: its own faults come first. \throw InputError of one tie, InputErrors of several
void check_house_ties(const House& house);

/// The rods of `house.ties` in all copies of the house.
///
/// along: through a wall, an inner one too, from end to end, so that its plates press on the outer faces of the walls that it meets;
/// across: from the outer face of a wall to that of the opposite wall; corner: from the outer face of a wall to that of the next, across
/// the corner between the two. \param foot  m, height of the walls' foot \throw InputError with the key at fault
std::vector<PlannedTie> house_ties(const House& house, double foot);

/// Findings for rods along a wall that run through an opening of the wall: probably unintended. \pre house_ties has accepted the house
std::vector<InputError> rods_in_openings(const House& house);

/// A mesh before the elements that its nodes hold are known.
struct PlannedMesh {
  struct Strap {
    std::array<std::int32_t, 2> nodes{};
    double width = 0.0;  // m, width of the mesh that the strap represents
  };
  std::vector<Vec3> nodes;
  std::vector<Strap> straps;
  std::vector<std::array<std::int32_t, 2>> connectors;  // nodes on the outer and the inner face
  double cell = 0.0;                                    // m2, area of the mesh that a node represents
};

/// The mesh `house.meshes[index]` on all copies of the house. Nodes lie on the faces of the walls in rows and columns, symmetric in the
/// wall; rows of neighbouring walls are connected round their outer corner. \param foot  m, height of the walls' foot \throw InputError
/// with the key at fault
PlannedMesh house_mesh(const House& house, std::size_t index, double foot);

}  // namespace voussoir::cases
