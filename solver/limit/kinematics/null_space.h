// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/SparseCore>
#include <cstddef>

/// The vectors that a sparse matrix takes to zero, or nearly so. A singular value below a share of the mean norm of columns (root
/// of the mean square) counts as zero.
namespace voussoir::solver {

/// The part of v that the matrix takes to zero: a half of what lies at the bound, less than 1e-11 of what lies at ten times the bound.
/// \param share  the bound on singular values, of the mean norm of columns
Eigen::VectorXd null_part(const Eigen::SparseMatrix<double>& a, Eigen::VectorXd v, double share);

/// The number of independent vectors that the matrix takes to zero.
std::size_t nullity(const Eigen::SparseMatrix<double>& a, double share);

}  // namespace voussoir::solver
