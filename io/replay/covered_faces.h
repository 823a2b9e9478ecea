// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace voussoir::io {

class Hdf5File;

/// Faces that bonded joints cover whole: nobody sees them as long as no bond of their element is broken.
struct CoveredFaces {
  std::vector<std::int32_t> element;
  std::vector<float> normal;  // outward, in the reference configuration; three a face
};

/// \param run  its joints (a joint with the base counts), less those of the law "dry", which bonds nothing \throw FileError
CoveredFaces covered_faces(const Hdf5File& run);
/// The same as a flag for every row of /model/face. \throw FileError
std::vector<std::uint8_t> covered_face_rows(const Hdf5File& run);

}  // namespace voussoir::io
