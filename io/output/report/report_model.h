// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/input/files/hdf5_file.h"

/// Data of a model without a run for the page of `voussoir view`.
namespace voussoir::io {

struct ReportModel {
  std::string json;                    // {laws: [{name, joints}], fault, faults: elements}
  std::vector<std::uint8_t> fixed;     // by element, 1: fixed
  std::vector<float> joint_ends;       // m, both ends of each joint edge on the surface
  std::vector<std::uint8_t> edge_law;  // by edge, row of /model/law (255 for rows above 254)
};

/// \param run  a run.h5 without frames \param fault  reason why the model is refused; empty: accepted \param faults  elements named by the
/// fault
ReportModel report_model(const Hdf5File& run, const std::string& fault, const std::vector<std::int32_t>& faults);

/// Faces of elements that are several cells, or a tetrahedron: a sequence of element, number of corners, corners (rows of /model/vertex).
/// Empty for a run.h5 without /model/face/corners.
std::vector<std::int32_t> polyhedron_loops(const Hdf5File& run);

}  // namespace voussoir::io
