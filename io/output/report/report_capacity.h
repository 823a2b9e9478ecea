// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/forward.h"
#include "io/input/files/hdf5_file.h"
#include "io/output/report/report_plots.h"

namespace voussoir::io {

/// Results of a quasi-static analysis for the report page: a JSON object with `capacity` (the figures of io/MEASURES.md) and `limit` (limit
/// analysis for comparison: limit.json beside the run, or null); appends its curves to `plots`. Nothing for a time history. \param c  the
/// run's case, if readable: without it `limit` is null \throw FileError if limit.json is not the output of `voussoir limit --format json`
/// for this case and direction
std::optional<std::string> report_capacity(const Hdf5File& file, const cases::Case* c, std::vector<page::Plot>& plots);

}  // namespace voussoir::io
