// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace voussoir::io {

class Hdf5File;

/// Faces on which a joint has come open, and since when.
struct OpenedFaces {
  std::vector<std::int32_t> element;
  std::vector<float> normal;  // outward, in the reference configuration; three a face
  std::vector<float> time;    // s
};

/// \param run  its joints and faces
/// \param since  when each joint counts as open [s], infinity: never; as joint_opening_times or JointCracks::shown \throw FileError
OpenedFaces opened_faces(const Hdf5File& run, const std::vector<double>& since);

}  // namespace voussoir::io
