// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace voussoir::io {

class Hdf5File;

/// Faces with an opened joint, and the times of opening.
struct OpenedFaces {
  std::vector<std::int32_t> element;
  std::vector<float> normal;  // outward, in the reference configuration; three per face
  std::vector<float> time;    // s
};

/// Finds the opened faces. \param run  with its joints and faces
OpenedFaces opened_faces(const Hdf5File& run, const std::vector<double>& since);

}  // namespace voussoir::io
