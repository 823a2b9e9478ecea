// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/input/files/hdf5_file.h"

/// What a page shows of a model alone, before any run (`voussoir view`).
namespace voussoir::io {

struct ReportModel {
  std::string json;                    // {laws: [{name, joints}], fault, faults: elements}
  std::vector<std::uint8_t> fixed;     // by element, 1: fixed
  std::vector<float> joint_ends;       // both ends of each edge of a joint that lies on the surface, m
  std::vector<std::uint8_t> edge_law;  // of each edge, a row of /model/law (from 255 on: 255)
};

/// \param run  a run.h5 without frames \param fault  why the model is refused; empty: it is not \param faults  elements that the fault
/// names
ReportModel report_model(const Hdf5File& run, const std::string& fault, const std::vector<std::int32_t>& faults);

/// Faces of elements that are more than one cell, or a tetrahedron: element, number of corners, corners (rows of /model/vertex), and so on.
/// Empty for a run.h5 without /model/face/corners.
std::vector<std::int32_t> polyhedron_loops(const Hdf5File& run);

}  // namespace voussoir::io
