// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

/// The vectors that a sparse matrix takes to zero, or nearly so. A singular value below a share of the mean norm of columns (root
/// of the mean square) counts as zero.
namespace voussoir::solver {

/// A matrix by its entries; those at one place add up.
struct SparseEntries {
  struct Entry {
    std::size_t row = 0, column = 0;
    double value = 0.0;
  };
  std::size_t rows = 0, columns = 0;
  std::vector<Entry> entries;
};

/// The part of v that the matrix takes to zero: a half of what lies at the bound, less than 1e-11 of what lies at ten times the bound.
/// \param share  the bound on singular values, of the mean norm of columns
std::vector<double> null_part(const SparseEntries& a, const std::vector<double>& v, double share);

/// The number of independent vectors that the matrix takes to zero.
std::size_t nullity(const SparseEntries& a, double share);

}  // namespace voussoir::solver
