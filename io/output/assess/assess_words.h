// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/output/assess/assessment.h"
#include "io/output/assess/floor_spectra.h"
#include "io/output/measures/capacity/capacity.h"

/// Output of `voussoir assess`, as text or as one JSON object.
namespace voussoir::io {

/// \param points  empty: no table of accelerations
std::string assessment_text(const Assessment& a, const std::vector<FloorAcceleration>& points, const cases::GroundMotion& base);
/// \param capacity  of a quasi-static analysis, if it is one
std::string assessment_json(const Assessment& a, const std::vector<FloorAcceleration>& points, const cases::GroundMotion& base,
                            const std::optional<Capacity>& capacity = {});

}  // namespace voussoir::io
