// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace voussoir::io {

class Hdf5File;

/// When each joint of a run came open, s: as soon as the springs of half of its area are broken; infinity: never.
/// \param run  its joints and cracks \throw FileError
std::vector<double> joint_opening_times(const Hdf5File& run);

}  // namespace voussoir::io
