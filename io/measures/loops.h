// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

/// Cycles of a cyclic test, one by one (io/MEASURES.md, Capacity).
namespace voussoir::io {

struct CapacityCurve;

/// One cycle: from where the displacement of the forces passes zero upwards to where it does so again.
struct Loop {
  double begin = 0.0, end = 0.0;                 // s
  double most = 0.0, least = 0.0;                // m, of the displacement
  double most_factor = 0.0, least_factor = 0.0;  // load factor
  double first_factor = 0.0, last_factor = 0.0;  // load factor at its two ends: the loop is closed where they are equal
  double area = 0.0;                             // J, work of the forces that grow
  double dissipated = 0.0;                       // J, all losses of the ledger
  double stored = 0.0;                           // J, what the stores have gained
  double other_work = 0.0;                       // J, of the other loads: what the ledger was given beside the area
  double viscous_damping = 0.0;                  // equivalent: the area over 4π times the elastic energy of the loop's secant
};

/// Cycles that are whole. \param weight  N, of all forces at a load factor of 1
std::vector<Loop> loops_of(const CapacityCurve& curve, double weight);

}  // namespace voussoir::io
