// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/solids/mesh.h"

namespace voussoir::geometry {

/// The closed surfaces that a mesh consists of, in the order of their first faces. Faces are connected across edges; where more than two
/// faces meet at an edge (stones side by side in one heap of triangles), each is connected to the face that comes next on its inner side.
/// Two boxes with a common face, edge or corner are therefore two shells. Each connected part of an open surface is one shell.
std::vector<Mesh> shells(const Mesh& m);

}  // namespace voussoir::geometry
