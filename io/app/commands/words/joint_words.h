// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/case.h"
#include "cases/model.h"

/// What `check` says of joints and their contact points.
namespace voussoir::io {

/// Prints the shortening of levers under SegmentRule::centres: a share of 1/n, THEORY.md (2).
void print_levers(const cases::Case& c, const cases::Model& m);

/// Prints how stiff joints are against a twist about their normals, and by what G I_p differs from solids, THEORY.md (11a).
void print_torsion(const cases::Case& c, const cases::Model& m);

}  // namespace voussoir::io
