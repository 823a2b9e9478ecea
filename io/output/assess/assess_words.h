// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "io/output/assess/assessment.h"
#include "io/output/assess/floor_spectra.h"

/// Output of `voussoir assess`, as text or as one JSON object.
namespace voussoir::io {

std::string assessment_text(const Assessment& a, const std::vector<FloorAcceleration>& points, const cases::GroundMotion& base);
std::string assessment_json(const Assessment& a, const std::vector<FloorAcceleration>& points, const cases::GroundMotion& base);

}  // namespace voussoir::io
