// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace voussoir::io {

class Hdf5File;

/// When each tie breaks in a run [s], in the order of /model/tie; infinity: not in this run. Of a run without results, or from before it
/// wrote them: never. \throw FileError
std::vector<float> tie_ends_of_life(const Hdf5File& run);

}  // namespace voussoir::io
