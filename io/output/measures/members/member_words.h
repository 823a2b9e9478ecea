// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "io/output/measures/measures.h"

/// Tables of storeys and of ties for people.
namespace voussoir::io {

/// Storey drift by storey and wall, out-of-plane drift beside it, and slip of the timber on each wall; empty without walls.
std::string storeys_text(const Measures& m);

/// Rods, then decks and meshes: largest force, elongation and utilisation; empty without.
std::string ties_text(const Measures& m);

/// Loads: where each acts, its largest force and the displacement of its place then, the largest displacement, and both at the end; empty
/// without.
std::string loads_text(const std::vector<LoadMeasures>& loads);

}  // namespace voussoir::io
