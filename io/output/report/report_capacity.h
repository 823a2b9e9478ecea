// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/case.h"
#include "io/input/files/hdf5_file.h"
#include "io/output/report/report_plots.h"

namespace voussoir::io {

/// What a quasi-static analysis has found, for the report page: a JSON object with `capacity` (the figures of io/MEASURES.md) and `limit`
/// (a second opinion: limit.json beside the run, or null); its curves are added to `plots`. Nothing of a time history. \param c  the run's
/// case, if it can be read: without it there is no second opinion \throw FileError if limit.json is not what `voussoir limit --format json`
/// writes of this case and direction
std::optional<std::string> report_capacity(const Hdf5File& file, const cases::Case* c, std::vector<page::Plot>& plots);

}  // namespace voussoir::io
