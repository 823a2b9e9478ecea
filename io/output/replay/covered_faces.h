// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace voussoir::io {

class Hdf5File;

/// Whether joints without bonds, of the law "dry", count as those that cover a face: they open without a trace, but not before all moves.
enum class DryJoints { cover, open };

/// Faces that joints cover whole: of bonded joints, nobody sees them as long as no bond of their element is broken.
struct CoveredFaces {
  std::vector<std::int32_t> element;
  std::vector<float> normal;  // outward, in the reference configuration; three a face
};

/// \param run  its joints (a joint with the base counts) \throw FileError
CoveredFaces covered_faces(const Hdf5File& run, DryJoints dry = DryJoints::open);
/// The same as a flag for every row of /model/face. \throw FileError
std::vector<std::uint8_t> covered_face_rows(const Hdf5File& run, DryJoints dry = DryJoints::open);

}  // namespace voussoir::io
