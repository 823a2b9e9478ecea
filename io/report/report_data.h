// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

/// What the report page shows of a run.
namespace voussoir::io {

/// The data as elements of HTML that the page's program reads by their `id`: "facts" (JSON: title, plots, summary, measures, provenance,
/// times, base, names of parts, quantum) and, packed (packed_text.h), "vertices" (float32, three a vertex, reference configuration),
/// "cells" (int32, as /model/cells), "cell-types" (uint8), "cell-elements" (int32), "centroids" (float32, position0), "parts" (int32,
/// number of each element's part), "covered-elements" (int32) and "covered-normals" (float32, three a face; see covered_faces.h),
/// "opened-elements", "opened-normals" and "opened-times" (float32, s; see opened_faces.h), and "frames" (report_frames.h). \param run  a
/// run.h5, of a finished run or not \throw FileError
std::string report_data(const std::string& run);

/// The whole page: report_data within the page of scripts/report. \throw FileError
std::string report_html(const std::string& run);

}  // namespace voussoir::io
