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

}  // namespace voussoir::io
