// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "io/input/files/hdf5_file.h"
#include "io/output/measures/capacity/capacity.h"

namespace voussoir::io {

/// Compares the capacity of a run with a demand: fills Capacity::performance. The shape φ is that of the first frame at which base shear
/// has reached 15 % of its largest value. Without a capacity curve, or without frames, nothing is filled. \param direction  of the push
/// \throw FileError
void look_at_demand(const Hdf5File& run, const std::array<double, 2>& direction, const DemandSpectrum& demand, Capacity& c);

/// The methods on a capacity with its curve: fills Capacity::performance. \pre a first stiffness
void look_at_demand(const EquivalentSystem& system, const DemandSpectrum& demand, Capacity& c);

}  // namespace voussoir::io
