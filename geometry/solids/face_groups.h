// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/solids/facing.h"
#include "geometry/solids/flatten.h"

/// Groups of faces of rough solids that belong in one plane. Internal to geometry/solids/.
namespace voussoir::geometry {

/// Faces of all solids, one after the other.
struct RoughFaces {
  std::vector<std::size_t> first;  // by solid, index of its first face; the last entry is the number of faces
  std::vector<std::int32_t> solid;
  std::vector<FlatFace> face;
};
RoughFaces faces_of(std::span<const RoughSolid> solids);

/// Faces connected by contacts.
struct FaceGroup {
  std::vector<std::size_t> faces;  // indices into RoughFaces, ascending
  bool exact = true;               // the faces are exactly coplanar already
  bool bed = false;                // the faces are separated by a mortar bed
  bool on_base = false;
};

/// All groups of two or more faces, and faces on the base, in the order of their first faces.
std::vector<FaceGroup> face_groups(std::span<const RoughSolid> solids, const RoughFaces& faces, std::optional<double> base_z);

}  // namespace voussoir::geometry
