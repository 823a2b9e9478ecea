// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "io/output/measures/capacity/capacity.h"
#include "io/output/measures/measures_file.h"

/// How the results of a quasi-static analysis are called, wherever they stand: in run.h5, in `voussoir summary`, on the report page.
namespace voussoir::io {

/// As `analysis.kind` says it.
const char* name_of(cases::AnalysisKind kind);

/// Those that the kind of the analysis has. NaN: there is no such thing.
std::vector<Figure> figures_of(const Capacity& c);

/// Figures and mechanism as one JSON object, null for NaN; with the curve if wanted.
std::string capacity_json(const Capacity& c, bool with_curve);

/// Lines for people, each ended.
std::string capacity_text(const Capacity& c);

/// Writes the group /capacity: figures as attributes, `mechanism` and `mechanism_at_end`. \throw FileError
void write_capacity(Hdf5File& file, const Capacity& c);

}  // namespace voussoir::io
