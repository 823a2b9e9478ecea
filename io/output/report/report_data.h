// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "solver/analysis/modes.h"

/// What the report page shows of a run.
namespace voussoir::io {

/// The data as elements of HTML that the page's program reads by their `id`: "facts" (JSON, report_facts.h) and, packed (packed_text.h),
/// "curves" (JSON of the plots, report_facts.h), "vertices" (float32, three a vertex, reference configuration), "cells" (int32, as
/// /model/cells), "cell-types" (uint8), "cell-elements" (int32), "loops" (int32,
/// polyhedron_loops of report_model.h, if there are any), "centroids" (float32, position0), "parts" and "materials" (int32, an entry
/// an element, into the names in facts), "covered-elements" (int32) and "covered-normals" (float32, three a face; covered_faces.h),
/// "opened-elements", "opened-normals" and "opened-times" (float32, s; opened_faces.h, from when on faces show), "crack-elements" (int32,
/// two a joint), "crack-edges" (uint8), "crack-ends" (float32) and "crack-levels" (uint8, each frame as steps from the one before, modulo
/// 256; all of joint_cracks.h), "bodies" (JSON) and "body-ids" (uint8, as steps, too; report_bodies.h), "modes" (JSON) and "mode-shapes"
/// (int16; report_modes.h) where there are modes, "turn-shifts" (uint8, an entry an element) and "frames" (both of report_frames.h). \param
/// run  a run.h5, of a finished run or not \param prefix  of all ids \throw FileError
std::string report_data(const std::string& run, const std::string& prefix = "", const std::vector<solver::Mode>& modes = {});

/// The page of a model alone: report_data of a run without frames, and beside it "model" (JSON), "fixed" (uint8, an entry an element),
/// "joint-laws" (uint8, an edge) and "joint-ends" (float32, two points an edge): report_model.h. \param fault, faults  see there
std::string model_html(const std::string& run, const std::string& fault, const std::vector<std::int32_t>& faults);

/// The whole page: report_data of one run, or of two side by side (the ids of the second begin with "second-"), within the page of
/// scripts/report. \param modes  of the first run's structure as it was built, to be looked at \throw FileError
std::string report_html(const std::vector<std::string>& runs, const std::vector<solver::Mode>& modes = {});

}  // namespace voussoir::io
