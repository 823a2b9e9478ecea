// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/input/files/hdf5/handle.h"

/// Rows that a virtual dataset takes from other files. For the sources of Hdf5File alone, which reads them itself: HDF5 would give fill
/// values in place of rows that it cannot read.
namespace voussoir::io::hdf5 {

struct Piece {
  std::string file, dataset;
  std::uint64_t first = 0, rows = 0;  // of the virtual dataset; the first ones of `dataset`
};

/// Whether a name is that of a part: parts/NNNN.h5.
bool is_part(const std::string& file);

/// A name as virtual datasets have it, in which % begins a format.
std::string virtual_name(const std::string& name);

/// The pieces of a dataset; none if it holds its values itself.
/// \throw FileError if its values are in other files than parts/NNNN.h5, or if the pieces are not the rows in order
std::vector<Piece> pieces_of(const Doing& doing, std::int64_t dataset);

}  // namespace voussoir::io::hdf5
