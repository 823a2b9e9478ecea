// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace voussoir::io {

/// Writes the files for ParaView (5.11 and newer, each of its three XDMF readers) beside the run.h5 of `folder`: run.xdmf, the description,
/// and paraview.h5, the data. As ParaView does not handle orientations, every frame has the coordinates of all vertices, float32: hexahedra
/// and wedges that share no vertices, with the cell arrays
///
///   element, material   rows of /model/element and /model/material of run.h5
///   broken              fraction of the element's bonds
///   displacement        of the element's centroid from the reference configuration, m
///
/// There is one dataset per step and array (ParaView's Xdmf3 readers show zeros for hyperslabs of a common one), and file names have no
/// folders, so that DIR can be moved.
/// \throw FileError if one of the two exists and `overwrite` is false, if run.h5 is no run, or if the files cannot be written
void write_paraview(const std::string& folder, bool overwrite);

}  // namespace voussoir::io
