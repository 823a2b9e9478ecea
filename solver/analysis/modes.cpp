// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/analysis/modes.h"

#include <Spectra/SymEigsShiftSolver.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "geometry/nth.h"
#include "solver/setup/side_stiffness.h"
#include "solver/world/errors.h"

namespace voussoir::solver {

namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Matrix12 = Eigen::Matrix<double, 12, 12>;
using Motion = Eigen::Matrix<double, 6, 1>;  // of one element: displacement, rotation

constexpr double kHeld = 1e15;  // 1/s2, squared angular frequency given to rotations that are held: far above those of the modes looked for

Vec3 vec3(const Eigen::Vector3d& v) { return {v(0), v(1), v(2)}; }

/// The structure in coordinates q with x = S q and Sᵀ M S = I, S = M^(−1/2) by element: a standard symmetric problem.
class Structure {
 public:
  Structure(const World& w, DryJoints dry) : world_(w), dry_(dry), row_(static_cast<std::size_t>(w.elements.rows), -1) {
    for (std::int32_t e = 0; e < w.elements.count; ++e) {
      if (nth(w.elements.fixed, e)) continue;
      nth(row_, e) = static_cast<std::int32_t>(6 * scale_.size());
      scale_.push_back(scale_of(static_cast<std::size_t>(e)));
    }
  }

  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(6 * scale_.size()); }

  /// Lower triangle of Sᵀ K S.
  [[nodiscard]] Sparse stiffness() const {
    std::vector<Eigen::Triplet<double>> entries;
    for (std::int64_t id = 0; id < world_.sides.count(); ++id) {
      const auto i = static_cast<std::size_t>(id);
      if (world_.sides.joint[i] < 0 || (world_.sides.held[i] == 0 && dry_ == DryJoints::open)) continue;
      const kernels::Side side = world_.sides.side(id);
      const Stiffness12 of_side = side_stiffness(side, world_.points.view(world_.sides.set[i]));
      add(Eigen::Map<const Matrix12>(of_side.data()), {side.master, side.slave}, entries);
    }
    for (std::size_t i = 0; i < world_.ties.tie.size(); ++i) {
      const Ties::Tie& t = world_.ties.tie[i];
      const bool bears = t.law.compression || t.pretension > 0.0 || world_.ties.state[i].force > 0.0;
      if (bears && world_.ties.state[i].broken == 0) add(t, entries);
    }
    hold_levelled(entries);
    Sparse k(size(), size());
    k.setFromTriplets(entries.begin(), entries.end());
    return k;
  }

  /// M^(1/2) times a unit motion of the whole along an axis; its square is the mass that moves.
  [[nodiscard]] Eigen::VectorXd motion_along(int axis) const {
    Eigen::VectorXd b = Eigen::VectorXd::Zero(size());
    for (std::size_t n = 0; n < scale_.size(); ++n) {
      const double scale = scale_[n](axis, axis);
      if (scale > 0.0) b(static_cast<Eigen::Index>(6 * n) + axis) = 1.0 / scale;
    }
    return b;
  }

  [[nodiscard]] Mode mode(double omega_squared, const Eigen::VectorXd& q) const {
    Mode m;
    m.frequency = std::sqrt(std::max(0.0, omega_squared)) / (2.0 * std::numbers::pi);
    m.displacement.resize(static_cast<std::size_t>(world_.elements.count));
    m.rotation = m.displacement;
    Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
    double total = 0.0, largest = 0.0;
    for (std::size_t e = 0; e < m.displacement.size(); ++e) {
      if (row_[e] < 0) continue;
      const Motion x = nth(scale_, row_[e] / 6) * q.segment<6>(row_[e]);
      m.displacement[e] = vec3(x.head<3>()), m.rotation[e] = vec3(x.tail<3>());
      momentum += world_.elements.mass[e] * x.head<3>();
      total += world_.elements.mass[e];
      largest = std::max({largest, x.head<3>().cwiseAbs().maxCoeff(), world_.elements.radius[e] * x.tail<3>().cwiseAbs().maxCoeff()});
    }
    m.mass_share = vec3(momentum.cwiseAbs2() / (total * q.squaredNorm()));
    for (auto* field : {&m.displacement, &m.rotation}) {
      for (Vec3& v : *field) v *= 1.0 / largest;
    }
    return m;
  }

 private:
  /// Stiffness for the rotations of blocks that are kept level (analysis.level). Their inverse inertia is 0, so without it they would be
  /// modes of 0 Hz.
  void hold_levelled(std::vector<Eigen::Triplet<double>>& entries) const {
    for (std::size_t n = 0; n < scale_.size(); ++n) {
      if (!scale_[n].bottomRightCorner<3, 3>().isZero(0.0)) continue;
      const auto row = static_cast<std::int32_t>(6 * n + 3);
      for (int i = 0; i < 3; ++i) entries.emplace_back(row + i, row + i, kHeld);
    }
  }

  /// M^(−1/2) of an element: diagonal for its mass, the Cholesky factor of the inverse inertia for its rotation.
  [[nodiscard]] Eigen::Matrix<double, 6, 6> scale_of(std::size_t e) const {
    const Elements& s = world_.elements;
    Eigen::Matrix3d inverse;
    inverse << s.ixx[e], s.ixy[e], s.ixz[e], s.ixy[e], s.iyy[e], s.iyz[e], s.ixz[e], s.iyz[e], s.izz[e];
    Eigen::Matrix<double, 6, 6> scale = Eigen::Matrix<double, 6, 6>::Zero();
    scale.topLeftCorner<3, 3>().diagonal().setConstant(std::sqrt(s.inv_mass[e]));
    scale.bottomRightCorner<3, 3>() = inverse.llt().matrixL();
    return scale;
  }

  void add(const Matrix12& k, std::array<std::int32_t, 2> element, std::vector<Eigen::Triplet<double>>& entries) const {
    for (int a = 0; a < 2; ++a) {
      for (int b = 0; b < 2; ++b) {
        const std::int32_t row = nth(row_, nth(element, a));
        const std::int32_t column = nth(row_, nth(element, b));
        if (row < 0 || column < 0 || row < column) continue;
        const Eigen::Matrix<double, 6, 6> part = nth(scale_, row / 6).transpose() * k.block<6, 6>(6 * a, 6 * b) * nth(scale_, column / 6);
        for (int i = 0; i < 6; ++i) {
          for (int j = 0; j < 6; ++j) {
            if (row + i >= column + j) entries.emplace_back(row + i, column + j, part(i, j));
          }
        }
      }
    }
  }

  /// A tie as it was at the start, along its axis.
  void add(const Ties::Tie& t, std::vector<Eigen::Triplet<double>>& entries) const {
    std::vector<std::pair<std::int32_t, Motion>> holds;  // row, and elongation by a unit of each motion
    for (std::int32_t k = t.first_hold; k < t.last_hold; ++k) {
      const Ties::Hold& h = nth(world_.ties.hold, k);
      const std::int32_t row = nth(row_, h.element);
      if (row < 0) continue;
      const Vec3 turning = cross(h.arm, t.axis);
      const Motion motion = h.share * Motion{t.axis.x, t.axis.y, t.axis.z, turning.x, turning.y, turning.z};
      holds.emplace_back(row, nth(scale_, row / 6).transpose() * motion);
    }
    for (const auto& [row, a] : holds) {
      for (const auto& [column, b] : holds) {
        for (int i = 0; i < 6; ++i) {
          for (int j = 0; j < 6; ++j) {
            if (row + i >= column + j) entries.emplace_back(row + i, column + j, t.law.stiffness * a(i) * b(j));
          }
        }
      }
    }
  }

  const World& world_;
  DryJoints dry_;
  std::vector<std::int32_t> row_;                   // by element; −1: fixed, or the base
  std::vector<Eigen::Matrix<double, 6, 6>> scale_;  // by element that moves
};

/// (A − σ I)⁻¹ for Spectra.
class ShiftInverse {
 public:
  using Scalar = double;
  explicit ShiftInverse(Sparse a) : a_(std::move(a)) {}
  [[nodiscard]] Eigen::Index rows() const { return a_.rows(); }
  [[nodiscard]] Eigen::Index cols() const { return a_.cols(); }
  void set_shift(double sigma) {
    Sparse shifted = a_;
    for (Eigen::Index i = 0; i < rows(); ++i) shifted.coeffRef(i, i) -= sigma;
    factor_.compute(shifted);
    if (factor_.info() != Eigen::Success) throw NumericalError("modes: the stiffness matrix cannot be factorised");
  }
  void perform_op(const double* in, double* out) const {
    Eigen::Map<Eigen::VectorXd>(out, rows()) = factor_.solve(Eigen::Map<const Eigen::VectorXd>(in, rows()));
  }

 private:
  Sparse a_;
  Eigen::SimplicialLDLT<Sparse, Eigen::Lower> factor_;
};

// Below zero, so that bodies which nothing holds do not make the matrix singular; small against the square of a building's frequency.
const double kShift = -std::pow(2.0 * std::numbers::pi * 0.1, 2);

/// Lanczos iteration with full orthogonalisation.
class Krylov {
 public:
  Krylov(const ShiftInverse& inverse, Eigen::VectorXd start) : inverse_(inverse) { basis_.push_back(start.normalized()); }

  /// \return false at the end: the space is exhausted
  bool extend() {
    Eigen::VectorXd next(inverse_.rows());
    inverse_.perform_op(basis_.back().data(), next.data());
    diagonal_.push_back(next.dot(basis_.back()));
    for (int twice = 0; twice < 2; ++twice) {
      for (const Eigen::VectorXd& v : basis_) next -= next.dot(v) * v;
    }
    beside_.push_back(next.norm());
    if (!(beside_.back() > 1e-14 * std::abs(diagonal_.front()))) return false;
    basis_.push_back(next / beside_.back());
    return true;
  }

  struct Ritz {
    Eigen::VectorXd values, shares, errors;  // of the inverse; share of the start in each vector; bound of the relative error
    Eigen::MatrixXd vectors;                 // in the basis
  };
  [[nodiscard]] Ritz ritz() const {
    const auto n = static_cast<Eigen::Index>(diagonal_.size());
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
    const Eigen::Map<const Eigen::VectorXd> diagonal(diagonal_.data(), n);
    solver.computeFromTridiagonal(diagonal, Eigen::Map<const Eigen::VectorXd>(beside_.data(), n - 1));
    Ritz r{solver.eigenvalues(), solver.eigenvectors().row(0).cwiseAbs2().transpose(), {}, solver.eigenvectors()};
    r.errors = (beside_.back() * r.vectors.row(n - 1).transpose()).cwiseAbs().cwiseQuotient(r.values.cwiseAbs());
    return r;
  }
  [[nodiscard]] Eigen::VectorXd vector(const Eigen::VectorXd& in_basis) const {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(basis_.front().size());
    for (Eigen::Index i = 0; i < in_basis.size(); ++i) sum += in_basis(i) * nth(basis_, i);
    return sum;
  }

 private:
  const ShiftInverse& inverse_;
  std::vector<Eigen::VectorXd> basis_;
  std::vector<double> diagonal_, beside_;
};

}  // namespace

std::vector<Mode> modes_along(const World& w, int axis, int count, DryJoints dry) {
  constexpr int kLeast = 20, kMost = 400, kEvery = 20;  // steps; steps between two looks at what has converged
  constexpr double kExact = 1e-8;
  constexpr double kMechanism = 1e-3;  // Hz
  const Structure structure(w, dry);
  if (structure.size() < 2) return {};
  ShiftInverse inverse(structure.stiffness());
  inverse.set_shift(kShift);
  Krylov krylov(inverse, structure.motion_along(axis));
  std::vector<Mode> found;
  for (int step = 1; step <= kMost; ++step) {
    const bool more = krylov.extend();
    if (more && (step < kLeast || step % kEvery != 0) && step < kMost) continue;
    const Krylov::Ritz r = krylov.ritz();
    std::vector<Eigen::Index> order;
    for (Eigen::Index i = 0; i < r.values.size(); ++i) {
      const double omega_squared = kShift + 1.0 / r.values(i);
      if (r.values(i) > 0.0 && omega_squared > std::pow(2.0 * std::numbers::pi * kMechanism, 2)) order.push_back(i);
    }
    std::ranges::stable_sort(order, [&](Eigen::Index a, Eigen::Index b) { return r.shares(a) > r.shares(b); });
    order.resize(std::min(order.size(), static_cast<std::size_t>(count)));
    const bool converged = std::ranges::all_of(order, [&](Eigen::Index i) { return r.errors(i) < kExact; });
    if (!converged && more && step < kMost) continue;
    for (const Eigen::Index i : order) {
      if (r.errors(i) < kExact) found.push_back(structure.mode(kShift + 1.0 / r.values(i), krylov.vector(r.vectors.col(i))));
    }
    break;
  }
  return found;
}

std::vector<Mode> natural_modes(const World& w, int count, DryJoints dry) {
  const Structure structure(w, dry);
  const auto wanted = std::min<Eigen::Index>(count, structure.size() - 1);
  if (wanted < 1) return {};
  ShiftInverse inverse(structure.stiffness());
  Spectra::SymEigsShiftSolver<ShiftInverse> solver(inverse, wanted, std::min(2 * wanted + 20, structure.size()), kShift);
  solver.init();
  const auto found = solver.compute(Spectra::SortRule::LargestMagn, 1000, 1e-12, Spectra::SortRule::SmallestAlge);
  if (solver.info() != Spectra::CompInfo::Successful)
    throw NumericalError("modes: " + std::to_string(found) + " of " + std::to_string(wanted) + " eigenvalues converged");
  const Eigen::VectorXd values = solver.eigenvalues();
  const Eigen::MatrixXd vectors = solver.eigenvectors();
  std::vector<Mode> modes;
  for (Eigen::Index i = 0; i < values.size(); ++i) modes.push_back(structure.mode(values(i), vectors.col(i)));
  return modes;
}

}  // namespace voussoir::solver
