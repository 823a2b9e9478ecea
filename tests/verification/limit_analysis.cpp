// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/verification/limit_analysis.h"

#include <coin/Clp_C_Interface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace voussoir::testing {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;

/// A linear programme by columns: maximise the first of the unknowns, all >= 0, under equations.
class Programme {
 public:
  explicit Programme(std::size_t equations) : right_(equations, 0.0) {}
  double& right(int row) { return right_[static_cast<std::size_t>(row)]; }
  void add(int row, double value) {
    rows_.push_back(row);
    values_.push_back(value);
  }
  void end_column() { starts_.push_back(static_cast<CoinBigIndex>(rows_.size())); }

  /// The unknowns.
  [[nodiscard]] std::vector<double> solve() const {
    const std::unique_ptr<Clp_Simplex, void (*)(Clp_Simplex*)> lp(Clp_newModel(), Clp_deleteModel);
    std::vector<double> objective(starts_.size() - 1, 0.0);
    objective.front() = 1.0;
    Clp_setLogLevel(lp.get(), 0);
    Clp_loadProblem(lp.get(), static_cast<int>(objective.size()), static_cast<int>(right_.size()), starts_.data(), rows_.data(),
                    values_.data(), nullptr, nullptr, objective.data(), right_.data(), right_.data());
    Clp_setOptimizationDirection(lp.get(), -1.0);
    Clp_initialSolve(lp.get());
    if (Clp_status(lp.get()) != 0) throw std::runtime_error("limit analysis: Clp's status " + std::to_string(Clp_status(lp.get())));
    const double* found = Clp_primalColumnSolution(lp.get());
    return {found, found + objective.size()};
  }

 private:
  std::vector<double> right_;
  std::vector<CoinBigIndex> starts_{0};
  std::vector<int> rows_;
  std::vector<double> values_;
};

struct ContactPoint {
  std::int32_t a = 0, b = 0;              // elements; b may be the base
  Vec3 at, normal;                        // m; outward of a
  double cohesion = 0.0, slope = 0.0;     // the limit of shear is cohesion + slope × compression; cohesion in mean weights
  double compression = 0.0, found = 0.0;  // mean of the iterations, and of the last, in mean weights
};

/// What the programmes are of: three equations of each block that can move, in units of the mean weight (forces along the body force and z,
/// moment about the centroid), and one of each contact point, between its compression and the two distances of its shear from the limits.
class RigidBlocks {
 public:
  RigidBlocks(const cases::Model& model, double friction, Vec3 along)
      : model_(model), along_(along), friction_(std::tan(friction * kDegree)), first_row_(model.blocks.size(), -1) {
    number_blocks();
    for (const geometry::Joint& joint : model.assembly.joints) {
      for (const auto* side : {&joint.side_a, &joint.side_b}) {
        for (const geometry::Segment& s : *side) add_point(joint, s);
      }
    }
  }

  double associated() {
    for (auto& [place, p] : points_) p.cohesion = 0.0, p.slope = friction_;
    const double factor = solve();
    for (auto& [place, p] : points_) p.compression = p.found;
    return factor;
  }
  /// Turns the limit of each point about what it is at the compression last found, until it is all but level. Compressions are averaged
  /// over iterations: taken as found they swing to and fro between mechanisms.
  /// \pre associated() has found `factor`
  double coulomb(double factor) {
    double last = 0.0;
    for (int i = 0; i < 40; ++i) {
      for (auto& [place, p] : points_) {
        p.slope = std::max(0.7 * p.slope, 0.01 * friction_);
        p.cohesion = (friction_ - p.slope) * p.compression;
      }
      last = std::exchange(factor, solve());
      for (auto& [place, p] : points_) p.compression = 0.5 * (p.compression + p.found);
    }
    if (std::abs(factor - last) > 1e-3 * factor) throw std::runtime_error("limit analysis: no end of the iterations");
    return factor;
  }

 private:
  [[nodiscard]] double weight(std::size_t i) const {
    const cases::Block& b = model_.blocks[i];
    return model_.materials[static_cast<std::size_t>(b.material)].value.density * model_.assembly.elements[i].mass.volume;
  }
  void number_blocks() {
    double total = 0.0;
    for (std::size_t i = 0; i < model_.blocks.size(); ++i) {
      if (model_.blocks[i].fixed) continue;
      first_row_[i] = rows_;
      rows_ += 3;
      total += weight(i);
    }
    unit_ = 3.0 * total / rows_;
  }
  void add_point(const geometry::Joint& joint, const geometry::Segment& s) {
    const geometry::Frame& f = joint.frame;
    const Vec3 at = f.centre + s.s * f.axis_s + s.t * f.axis_t;
    const auto round = [](double x) { return std::lround(1e6 * x); };
    const auto place = std::tuple(joint.element_a, joint.element_b, round(dot(at, along_)), round(at.z));
    points_.try_emplace(place, ContactPoint{joint.element_a, joint.element_b, at, f.normal});
  }

  double solve() {
    Programme lp(static_cast<std::size_t>(rows_) + points_.size());
    for (std::size_t i = 0; i < first_row_.size(); ++i) {
      if (first_row_[i] < 0) continue;
      lp.add(first_row_[i], weight(i) / unit_);
      lp.right(first_row_[i] + 1) = weight(i) / unit_;
    }
    lp.end_column();
    int row = rows_;
    for (const auto& [place, p] : points_) add_columns(lp, p, row++);
    const std::vector<double> found = lp.solve();
    std::size_t column = 1;
    for (auto& [place, p] : points_) p.found = found[column], column += 3;
    return found.front();
  }
  /// Compression N, and s, r >= 0 with shear = s − (c + mN) = (c + mN) − r.
  void add_columns(Programme& lp, const ContactPoint& p, int row) const {
    const Vec3 shear{-p.normal.z * along_.x, -p.normal.z * along_.y, dot(p.normal, along_)};
    act(lp, p, -p.normal - p.slope * shear);
    lp.add(row, -2.0 * p.slope);
    lp.end_column();
    act(lp, p, shear);
    lp.add(row, 1.0);
    lp.end_column();
    lp.add(row, 1.0);
    lp.end_column();
    lp.right(row) = 2.0 * p.cohesion;
    for_each_row(p, -p.cohesion * shear, [&](int r, double value) { lp.right(r) -= value; });
  }
  void act(Programme& lp, const ContactPoint& p, Vec3 force_on_a) const {
    for_each_row(p, force_on_a, [&](int r, double value) { lp.add(r, value); });
  }
  /// What a force at a contact point adds to the equations of its two blocks.
  template <class Take>
  void for_each_row(const ContactPoint& p, Vec3 force_on_a, const Take& take) const {
    for (const auto& [element, sign] : {std::pair{p.a, 1.0}, std::pair{p.b, -1.0}}) {
      if (element == geometry::kBase || first_row_[static_cast<std::size_t>(element)] < 0) continue;
      const int row = first_row_[static_cast<std::size_t>(element)];
      const Vec3 arm = p.at - model_.assembly.elements[static_cast<std::size_t>(element)].mass.centroid;
      const double force = sign * dot(force_on_a, along_), lift = sign * force_on_a.z;
      take(row, force);
      take(row + 1, lift);
      take(row + 2, dot(arm, along_) * lift - arm.z * force);
    }
  }

  const cases::Model& model_;
  Vec3 along_;
  double friction_, unit_ = 1.0;  // tan φ; mean weight, kg
  int rows_ = 0;                  // of the balance of blocks
  std::vector<int> first_row_;    // −1: does not move
  std::map<std::tuple<std::int32_t, std::int32_t, long, long>, ContactPoint> points_;
};

}  // namespace

CollapseFactors collapse_factors(const cases::Model& model, double friction, Vec3 along) {
  RigidBlocks blocks(model, friction, along);
  const double associated = blocks.associated();
  return {associated, blocks.coulomb(associated)};
}

}  // namespace voussoir::testing
