// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace voussoir::io {

class Hdf5File;

/// Whether joints without bonds (law "dry") count as covering a face. Their opening is not recorded, so they may count only while nothing
/// has moved.
enum class DryJoints { cover, open };

/// Faces entirely covered by joints: with bonded joints, they are invisible as long as no bond of their element is broken.
struct CoveredFaces {
  std::vector<std::int32_t> element;
  std::vector<float> normal;  // outward, in the reference configuration; three per face
};

/// Finds the covered faces. \param run  with its joints (joints with the base count) \throw FileError
CoveredFaces covered_faces(const Hdf5File& run, DryJoints dry = DryJoints::open);
/// Flags of covered faces, one for every row of /model/face. \throw FileError
std::vector<std::uint8_t> covered_face_rows(const Hdf5File& run, DryJoints dry = DryJoints::open);

}  // namespace voussoir::io
