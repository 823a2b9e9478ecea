// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "io/output/measures/measures.h"
#include "io/output/report/report_plots.h"

/// Plots of the report page of storeys, ties, decks and loads. Each adds to `plots`; nothing where a run has none of them.
/// \throw FileError
namespace voussoir::io {

/// The ties with the largest forces.
void add_ties(const Hdf5File& file, std::vector<page::Plot>& plots);

/// Storey drifts, slip of beams, decks and meshes. \param walls  names
void add_members(const Hdf5File& file, const Measures& m, const std::vector<std::string>& walls, std::vector<page::Plot>& plots);

/// Of each load whose force changes, the force over the displacement of its place; of the others, that displacement over time.
void add_loads(const Hdf5File& file, std::vector<page::Plot>& plots);

}  // namespace voussoir::io
