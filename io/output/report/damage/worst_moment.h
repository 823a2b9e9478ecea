// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "io/output/measures/capacity/capacity.h"
#include "io/output/measures/measures.h"

namespace voussoir::io {

class FrameReader;

/// The moment at which the report page opens.
struct WorstMoment {
  double time = 0;   // s
  std::string name;  // "largest drift"
  std::string what;  // "2.7 % out of plane, rear wall, storey 3"
};

/// Drift beyond which a wall is falling: no state of a house that stands.
inline constexpr double kWildDrift = 0.25;

/// Of a quasi-static analysis the largest base shear (else the largest load factor at rest); of a building that collapses the collapse;
/// else the largest drift of a wall, out of or in its plane, that is below kWildDrift; without walls the largest displacement of an
/// element. Nothing for a run without frames. \throw FileError
std::optional<WorstMoment> worst_moment(const Measures& m, const Capacity* capacity, const FrameReader& frames);

}  // namespace voussoir::io
