// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "io/output/measures/capacity/capacity.h"
#include "io/output/measures/measures_file.h"

/// Names of the results of a quasi-static analysis, common to run.h5, `voussoir summary` and the report page.
namespace voussoir::io {

/// The value of `analysis.kind`.
const char* name_of(cases::AnalysisKind kind);

/// The figures that apply to the kind of the analysis. NaN: not defined.
std::vector<Figure> figures_of(const Capacity& c);

/// What the analysis could not prove, a sentence each.
std::vector<std::string> not_proven(const Capacity& c);

/// Figures and mechanism as one JSON object, null for NaN; with the curve if `with_curve`.
std::string capacity_json(const Capacity& c, bool with_curve);

/// Lines of text for the user, each with a line end.
std::string capacity_text(const Capacity& c);

/// Writes the group /capacity: figures as attributes, `mechanism` and `mechanism_at_end`. \throw FileError
void write_capacity(Hdf5File& file, const Capacity& c);

}  // namespace voussoir::io
