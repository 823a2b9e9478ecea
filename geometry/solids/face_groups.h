// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/solids/facing.h"
#include "geometry/solids/flatten.h"

/// Which faces of rough solids belong into one plane. Internal to geometry/solids/.
namespace voussoir::geometry {

/// Faces of all solids, one after the other.
struct RoughFaces {
  std::vector<std::size_t> first;  // of each solid, and the end
  std::vector<std::int32_t> solid;
  std::vector<FlatFace> face;
};
RoughFaces faces_of(std::span<const RoughSolid> solids);

/// Faces that hang together.
struct FaceGroup {
  std::vector<std::size_t> faces;  // of RoughFaces, ascending
  bool exact = true;               // they lie in one plane already
  bool bed = false;                // of mortar
  bool on_base = false;
};

/// Groups of two faces or more, and faces on the base, in the order of their first faces.
std::vector<FaceGroup> face_groups(std::span<const RoughSolid> solids, const RoughFaces& faces, std::optional<double> base_z);

}  // namespace voussoir::geometry
