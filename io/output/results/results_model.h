// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "cases/forward.h"
#include "io/input/files/hdf5_file.h"

/// The group /model of run.h5, which is constant during a run.
namespace voussoir::io {

/// Makes the values of a dataset as they are written: calls its argument with some whole rows after the other.
using RowSource = std::function<void(const std::function<void(std::span<const double>)>&)>;

/// A dataset to be written: numbers as bytes of `type`, or made as they are written.
struct StaticDataset {
  std::string name;
  Hdf5Type type = Hdf5Type::f64;
  Shape shape;
  std::vector<std::byte> bytes;
  RowSource source;  // used if set, of type f64
  Hdf5Note note;
};

/// Writes all datasets of /model, SI units, one after the other.
///
/// Cells follow VTK: /model/cells is n×8, rows of vertex numbers into /model/vertex, −1 where a cell has no more corners; /model/cell_type
/// is 10 (tetrahedron), 12 (hexahedron) or 13 (wedge); /model/cell_element is the element a cell belongs to. Hexahedra and triangular
/// prisms are one cell each; a prism over k corners is k − 2 wedges; any other polyhedron is tetrahedra (cells.h), and /model/face/corners
/// has its original faces. Corners are reordered where needed, so that each cell has the orientation VTK asks for.
///
/// \throw std::invalid_argument if assembly and blocks do not match; FileError
void write_model(Hdf5File& file, const cases::Model& model);

/// The group /loads: the shares of all [[load]] tables on elements, with the force of each over time; empty without loads.
/// \pre the histories and paths of the model have been read (support_motion.h) \throw InputError as cases::load_shares
std::vector<StaticDataset> load_datasets(const cases::Case& c, const cases::Model& model);

void write_datasets(Hdf5File& file, const std::vector<StaticDataset>& datasets);

}  // namespace voussoir::io
