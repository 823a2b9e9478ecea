// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "solver/analysis/modes.h"

/// Data of a run for the report page.
namespace voussoir::io {

/// The data as HTML elements that the page's program reads by their `id`: "facts" (JSON, report_facts.h) and, packed (packed_text.h),
/// "curves" (JSON of the plots, report_facts.h), "vertices" (float32, three a vertex, reference configuration), "cells" (int32, as
/// /model/cells), "cell-types" (uint8), "cell-elements" (int32), "loops" (int32, polyhedron_loops of report_model.h, if there are any),
/// "centroids" (float32, position0), "parts" and "materials" (int32, an entry an element, into the names in facts), "covered-elements"
/// (int32) and "covered-normals" (float32, three a face; covered_faces.h), "opened-elements", "opened-normals" and "opened-times" (float32,
/// s; opened_faces.h, times from which faces are shown), "crack-elements" (int32, two a joint), "crack-edges" (uint8), "crack-ends"
/// (float32) and "crack-levels" (uint8, each frame as steps from the one before, modulo 256; all of joint_cracks.h), "bodies" (JSON) and
/// "body-ids" (uint8, as steps, too; report_bodies.h), "modes" (JSON) and "mode-shapes" (int16; report_modes.h) if there are modes,
/// "turn-shifts" (uint8, an entry an element) and "frames" (both of report_frames.h).
/// \param run  a run.h5, finished or not \param prefix  of all ids \throw FileError
std::string report_data(const std::string& run, const std::string& prefix = "", const std::vector<solver::Mode>& modes = {});

/// The page of a model only: report_data of a run without frames, and additionally "model" (JSON), "fixed" (uint8, an entry per element),
/// "joint-laws" (uint8, by edge) and "joint-ends" (float32, two points per edge) of report_model.h. \param fault,  faults as in
/// report_model
std::string model_html(const std::string& run, const std::string& fault, const std::vector<std::int32_t>& faults);

/// The page of a run that goes on, which loads itself anew. \param every  s, when: "live" (JSON, a number) beside report_data
std::string live_html(const std::string& run, double every);

/// The complete page: report_data of one run, or of two side by side (the ids of the second begin with "second-"), within the page of
/// scripts/report. \param modes  of the first run's undamaged structure, to be shown \throw FileError
std::string report_html(const std::vector<std::string>& runs, const std::vector<solver::Mode>& modes = {});

}  // namespace voussoir::io
