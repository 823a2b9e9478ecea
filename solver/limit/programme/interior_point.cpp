// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/limit/programme/interior_point.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include "geometry/nth.h"

namespace voussoir::solver {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Columns = Eigen::SparseMatrix<double>;
using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

constexpr int kMostIterations = 150;
constexpr double kTolerance = 1e-8;                  // of residuals, relative
constexpr double kOffered = 1e-6;                    // gap of what is offered where rounding allows no better
constexpr double kGoodEnough = 1e-7;                 // gap below which the search ends once it gets no better
constexpr int kMostWorse = 10;                       // iterations without a better point until then
constexpr double kStepBack = 0.995;                  // of the way to the boundary at most
constexpr double kPivot = 1e-13;                     // of a diagonal entry: what keeps pivots of redundant equations off zero
constexpr double kShifts[] = {1e-13, 1e-15, 1e-17};  // of the mean diagonal entry, likewise
constexpr int kMostGradients = 30;                   // of a solution of the normal equations
constexpr int kRefinements = 3;                      // of a step
constexpr double kMissed = 0.1;      // of the equations' residual, or of its tolerance if that is larger: what a step may leave
constexpr double kRefined = 1e-12;   // relative residual of the normal equations that is good enough for a step
constexpr double kPredicted = 1e-3;  // likewise for the prediction, which steers the step alone

double price_of(const Columns& a, Index column, const VectorXd& y) {
  double sum = 0.0;
  for (Columns::InnerIterator at(a, column); at; ++at) sum += at.value() * y(at.row());
  return sum;
}

/// Aᵀ y. Eigen's product shares it among threads, which spin while they wait for each other: four times the processor time.
VectorXd prices_of(const Columns& a, const VectorXd& y) {
  VectorXd out(a.cols());
  for (Index c = 0; c < a.cols(); ++c) out(c) = price_of(a, c, y);
  return out;
}

/// A D Aᵀ y, in one pass over the columns.
VectorXd normal_product(const Columns& a, const VectorXd& d, const VectorXd& y) {
  VectorXd out = VectorXd::Zero(a.rows());
  for (Index c = 0; c < a.cols(); ++c) {
    const double price = d(c) * price_of(a, c, y);
    for (Columns::InnerIterator at(a, c); at; ++at) out(at.row()) += at.value() * price;
  }
  return out;
}

/// A D Aᵀ with D diagonal and positive, for its inverse: the first column of A is kept apart, by Sherman and Morrison's formula.
class NormalEquations {
 public:
  explicit NormalEquations(const Columns& a) : a_(a), rows_(a) {
    pattern();
    cholesky_.analyzePattern(lower_);
  }

  /// \param shift  of the mean diagonal entry, added to each
  bool factorise(const VectorXd& d, double shift) {
    d_ = d;
    fill(shift);
    cholesky_.factorize(lower_);
    if (cholesky_.info() != Eigen::Success) return false;
    first_ = a_.col(0);
    of_first_ = cholesky_.solve(first_);
    border_ = 1.0 / d_(0) + first_.dot(of_first_);
    return std::isfinite(border_) && border_ > 0.0;
  }

  /// By conjugate gradients, with the factors as preconditioner: what the shift and rounding spoil in them costs iterations, not digits.
  /// \param refined  relative residual that is good enough
  [[nodiscard]] VectorXd solve(const VectorXd& right, double refined) const {
    VectorXd y = VectorXd::Zero(right.size()), left = right, along = once(right), towards = along;
    double slope = left.dot(towards);
    if (!(slope > 0.0)) return towards;
    for (int i = 0; i < kMostGradients && slope > 0.0; ++i) {
      const VectorXd product = normal_product(a_, d_, along);
      const double step = slope / along.dot(product);
      if (!std::isfinite(step)) break;
      y += step * along, left -= step * product;
      if (left.norm() <= refined * right.norm()) break;
      towards = once(left);
      const double next = left.dot(towards);
      along = towards + (next / slope) * along, slope = next;
    }
    return y;
  }

 private:
  [[nodiscard]] VectorXd once(const VectorXd& right) const {
    const VectorXd y = cholesky_.solve(right);
    return y - of_first_ * (first_.dot(y) / border_);
  }
  /// For each row, the rows below it that share a column other than the first.
  template <class Take>
  void for_each_product(Index row, const Take& take) const {
    for (Rows::InnerIterator at(rows_, row); at; ++at) {
      if (at.col() == 0) continue;
      for (Columns::InnerIterator other(a_, at.col()); other; ++other)
        if (other.row() >= row) take(other.row(), at.col(), at.value() * other.value());
    }
  }
  void pattern() {
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<Index> last(static_cast<std::size_t>(a_.rows()), -1);
    for (Index row = 0; row < a_.rows(); ++row) {
      nth(last, row) = row;
      entries.emplace_back(row, row, 0.0);
      for_each_product(row, [&](Index other, Index, double) {
        if (std::exchange(nth(last, other), row) != row) entries.emplace_back(other, row, 0.0);
      });
    }
    lower_.resize(a_.rows(), a_.rows());
    lower_.setFromTriplets(entries.begin(), entries.end());
  }
  void fill(double shift) {
    VectorXd sum = VectorXd::Zero(a_.rows());
    for (Index row = 0; row < a_.rows(); ++row) {
      for_each_product(row, [&](Index other, Index column, double product) { sum(other) += d_(column) * product; });
      for (Columns::InnerIterator at(lower_, row); at; ++at) at.valueRef() = std::exchange(sum(at.row()), 0.0);
      lower_.coeffRef(row, row) *= 1.0 + kPivot;
    }
    const double least = shift * lower_.diagonal().mean();
    for (Index row = 0; row < a_.rows(); ++row) lower_.coeffRef(row, row) += least;
  }

  const Columns& a_;
  Rows rows_;
  Columns lower_;
  Eigen::SimplicialLDLT<Columns> cholesky_;
  VectorXd d_, first_, of_first_;
  double border_ = 0.0;
};

/// The longest step that leaves all of v + step · change positive, 1 at most.
double longest(const VectorXd& v, const VectorXd& change) {
  double step = 1.0;
  for (Index i = 0; i < v.size(); ++i)
    if (change(i) < 0.0) step = std::min(step, -v(i) / change(i));
  return step;
}

struct Programme {
  Columns matrix;
  VectorXd right, costs;
};

VectorXd vector_of(const std::vector<double>& v) { return Eigen::Map<const VectorXd>(v.data(), static_cast<Index>(v.size())); }

Programme programme_of(const InteriorProgramme& p) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(p.entries.size());
  for (std::size_t c = 0; c + 1 < p.starts.size(); ++c)
    for (std::size_t k = p.starts[c]; k < p.starts[c + 1]; ++k)
      entries.emplace_back(static_cast<Index>(p.rows[k]), static_cast<Index>(c), p.entries[k]);
  Programme out{Columns(static_cast<Index>(p.right.size()), static_cast<Index>(p.costs.size())), vector_of(p.right), vector_of(p.costs)};
  out.matrix.setFromTriplets(entries.begin(), entries.end());
  return out;
}

class Method {
 public:
  Method(const Programme& p, double gap) : p_(p), gap_(gap), normal_(p.matrix) {}

  std::optional<InteriorPoint> run(const LpWatch& watch) {
    if (!start()) return {};
    for (int i = 0; i < kMostIterations; ++i) {
      find_residuals();
      if (watch) watch(i, gap());
      keep_best(i);
      if (gap_of_best_ <= gap_ || gets_no_better(i) || !step()) break;
    }
    return std::move(best_);
  }

 private:
  /// Mehrotra's: least squares, shifted until all is positive.
  bool start() {
    const Index n = p_.matrix.cols();
    if (!normal_.factorise(VectorXd::Ones(n), kShifts[0])) return false;
    x_ = prices_of(p_.matrix, normal_.solve(p_.right, kRefined));
    y_ = normal_.solve(p_.matrix * p_.costs, kRefined);
    z_ = p_.costs - prices_of(p_.matrix, y_);
    x_.array() += std::max(0.0, -1.5 * x_.minCoeff());
    z_.array() += std::max(0.0, -1.5 * z_.minCoeff());
    const double product = x_.dot(z_), sum_x = x_.sum(), sum_z = z_.sum();
    x_.array() += sum_z > 0.0 ? std::max(0.5 * product / sum_z, 1e-3) : 1.0;
    z_.array() += sum_x > 0.0 ? std::max(0.5 * product / sum_x, 1e-3) : 1.0;
    return x_.allFinite() && z_.allFinite();
  }
  void find_residuals() {
    primal_ = p_.right - p_.matrix * x_;
    dual_ = p_.costs - prices_of(p_.matrix, y_) - z_;
    mean_ = x_.dot(z_) / static_cast<double>(x_.size());
  }
  [[nodiscard]] double gap() const {
    const double cost = p_.costs.dot(x_);
    return std::abs(cost - p_.right.dot(y_)) / (1.0 + std::abs(cost));
  }
  /// Norm of the equations' residual that is allowed.
  [[nodiscard]] double allowed() const { return kTolerance * (1.0 + p_.right.norm()); }
  /// Of the points that satisfy the equations of both programmes, the one of least gap.
  void keep_best(int iteration) {
    const bool holds = primal_.norm() <= allowed() && dual_.norm() <= kTolerance * (1.0 + p_.costs.norm());
    if (!holds || !(gap() <= kOffered && gap() < gap_of_best_)) return;
    best_ = InteriorPoint{{x_.begin(), x_.end()}, {y_.begin(), y_.end()}, iteration};
    gap_of_best_ = gap();
  }
  /// Rounding spoils the equations from some iteration on: steps no longer remove their residual.
  [[nodiscard]] bool gets_no_better(int iteration) const {
    return gap_of_best_ <= kGoodEnough && iteration - best_->iterations >= kMostWorse;
  }
  struct Change {
    VectorXd x, y, z;
    double missed = std::numeric_limits<double>::infinity();  // of the equations, once x is changed by all of it
  };
  /// Newton's step towards x z = products.
  /// \param refined  relative residual of the normal equations
  [[nodiscard]] Change newton(const VectorXd& products, double refined) const {
    Change c;
    const VectorXd d = x_.cwiseQuotient(z_), centring = products.cwiseQuotient(z_);
    c.y = normal_.solve(primal_ + p_.matrix * (d.cwiseProduct(dual_) - centring), refined);
    c.z = dual_ - prices_of(p_.matrix, c.y);
    c.x = centring - d.cwiseProduct(c.z);
    return c;
  }
  /// What rounding leaves of the equations is taken off the change of the unknowns itself: near the end d ranges over so many orders that
  /// the prices cannot hold the digits of all unknowns.
  void take_off_missed(const VectorXd& d, Change& c) const {
    VectorXd left = primal_ - p_.matrix * c.x;
    for (int i = 0; i < kRefinements && left.norm() > 0.0; ++i) {
      const VectorXd better = c.x + d.cwiseProduct(prices_of(p_.matrix, normal_.solve(left, kRefined)));
      const VectorXd now = primal_ - p_.matrix * better;
      if (!(now.norm() < 0.5 * left.norm())) break;
      c.x = better, left = now;
    }
    if (left.allFinite()) c.missed = left.norm();
  }
  /// Predictor, then corrector.
  [[nodiscard]] Change corrected() const {
    const VectorXd now = x_.cwiseProduct(z_);
    const Change predicted = newton(-now, kPredicted);
    const double reach_x = longest(x_, predicted.x), reach_z = longest(z_, predicted.z);
    const double would_be = (x_ + reach_x * predicted.x).dot(z_ + reach_z * predicted.z) / static_cast<double>(x_.size());
    const double centre = std::pow(would_be / mean_, 3);
    const VectorXd target = (-now - predicted.x.cwiseProduct(predicted.z)).array() + centre * mean_;
    Change change = newton(target, kRefined);
    take_off_missed(x_.cwiseQuotient(z_), change);
    return change;
  }
  /// A large shift hides equations whose unknowns are all small, a small one lets round-off into the pivots of redundant equations. The
  /// first is taken that misses little, from that of the step before on, else the one that misses least.
  [[nodiscard]] Change best_change() {
    Change best;
    for (std::size_t k = 0; k < std::size(kShifts); ++k) {
      const std::size_t which = (shift_ + k) % std::size(kShifts);
      if (!normal_.factorise(x_.cwiseQuotient(z_), kShifts[which])) continue;
      Change c = corrected();
      if (c.missed < best.missed) best = std::move(c);
      if (best.missed > kMissed * std::max(allowed(), primal_.norm())) continue;
      shift_ = which;
      break;
    }
    return best;
  }
  bool step() {
    const Change c = best_change();
    if (!std::isfinite(c.missed)) return false;
    const double step_x = std::min(1.0, kStepBack * longest(x_, c.x)), step_z = std::min(1.0, kStepBack * longest(z_, c.z));
    x_ += step_x * c.x;
    y_ += step_z * c.y, z_ += step_z * c.z;
    return x_.allFinite() && y_.allFinite() && z_.allFinite() && std::max(step_x, step_z) > 1e-10;
  }

  const Programme& p_;
  double gap_;  // that is enough
  NormalEquations normal_;
  VectorXd x_, y_, z_, primal_, dual_;
  double mean_ = 0.0;
  std::size_t shift_ = 0;  // in kShifts
  std::optional<InteriorPoint> best_;
  double gap_of_best_ = std::numeric_limits<double>::infinity();
};

}  // namespace

std::optional<InteriorPoint> interior_point(const InteriorProgramme& programme, const LpWatch& watch, double gap) {
  const Programme p = programme_of(programme);
  return Method(p, gap).run(watch);
}

}  // namespace voussoir::solver
