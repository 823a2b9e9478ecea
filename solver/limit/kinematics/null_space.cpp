// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/limit/kinematics/null_space.h"

#include <Eigen/SparseCholesky>
#include <cmath>
#include <vector>

namespace voussoir::solver {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

constexpr int kTimes = 16;

struct Squared {
  Matrix product;  // Aᵀ A
  double bound = 0.0;
};

Matrix matrix_of(const SparseEntries& a) {
  std::vector<Eigen::Triplet<double>> entries;
  for (const SparseEntries::Entry& e : a.entries)
    entries.emplace_back(static_cast<Eigen::Index>(e.row), static_cast<Eigen::Index>(e.column), e.value);
  Matrix m(static_cast<Eigen::Index>(a.rows), static_cast<Eigen::Index>(a.columns));
  m.setFromTriplets(entries.begin(), entries.end());
  return m;
}

Squared squared(const SparseEntries& entries, double share) {
  const Matrix a = matrix_of(entries);
  Squared s;
  s.product = a.transpose() * a;
  s.bound = share * share * (a.cols() > 0 ? s.product.diagonal().mean() : 0.0);
  return s;
}

Matrix with_diagonal(const Matrix& m, double more) {
  Matrix unit(m.rows(), m.cols());
  unit.setIdentity();
  return m + more * unit;
}

}  // namespace

/// b (AᵀA + b)⁻¹ leaves a vector as it is where the singular value σ is zero, and b/(b + σ²) of it elsewhere; after kTimes a half is left
/// at the bound, and next to nothing beyond.
std::vector<double> null_part(const SparseEntries& a, const std::vector<double>& v, double share) {
  const Squared s = squared(a, share);
  if (s.bound == 0.0) return v;
  Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Eigen::Index>(v.size()));
  const double b = s.bound / (std::pow(2.0, 1.0 / kTimes) - 1.0);
  const Eigen::SimplicialLDLT<Matrix> cholesky(with_diagonal(s.product, b));
  for (int i = 0; i < kTimes; ++i) x = b * cholesky.solve(x);
  return {x.begin(), x.end()};
}

/// By Sylvester's law of inertia: as many eigenvalues of AᵀA lie below the bound as pivots of AᵀA less the bound are negative.
std::size_t nullity(const SparseEntries& a, double share) {
  const Squared s = squared(a, share);
  if (s.bound == 0.0) return a.columns;
  const Eigen::SimplicialLDLT<Matrix> pivots(with_diagonal(s.product, -s.bound));
  return static_cast<std::size_t>((pivots.vectorD().array() < 0.0).count());
}

}  // namespace voussoir::solver
