// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/setup/setup_ties.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "cases/model.h"
#include "geometry/nth.h"
#include "solver/setup/setup.h"
#include "solver/setup/side_stiffness.h"

// Ties must not shorten the step: their stiffness is bounded by THEORY.md (32). Holds of several ties may share an element: all count.
namespace voussoir::solver {

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr double kOfStep = 0.9;  // of 4/Δt², for joints and ties together
// Of 4/Δt²: what a tie gets at the least. The bound on the joints is too high by up to a factor of two or so, and where it leaves nothing
// (timber, whose elements decide the step) a tie must not vanish.
constexpr double kAtLeast = 0.05;

Ties::Hold hold_of(const World& w, std::int32_t tie, const cases::TieHold& h, double sign) {
  if (h.element == geometry::kBase) return {tie, w.elements.base, sign * h.share, h.point - nth(w.elements.body, w.elements.base).ref};
  return {tie, h.element, sign * h.share, h.point - nth(w.model.assembly.elements, h.element).mass.centroid};
}

void take_bars(World& w) {
  Ties& ties = w.ties;
  for (const cases::TieBar& bar : w.model.ties) {
    const auto number = static_cast<std::int32_t>(ties.tie.size());
    Ties::Tie t;
    t.law = {bar.stiffness, bar.yield, bar.hardening, bar.breaking, bar.compression};
    t.wanted = bar.stiffness;
    t.pretension = bar.pretension;
    t.first_hold = static_cast<std::int32_t>(ties.hold.size());
    Vec3 apart;
    for (std::size_t end = 0; end < 2; ++end) {
      const double sign = end == 0 ? -1.0 : 1.0;
      for (const cases::TieHold& h : bar.ends[end]) {
        ties.hold.push_back(hold_of(w, number, h, sign));
        apart += sign * h.share * h.point;
      }
    }
    t.last_hold = static_cast<std::int32_t>(ties.hold.size());
    t.length = norm(apart), t.axis = normalised(apart);
    ties.tie.push_back(t);
  }
  ties.state.resize(ties.tie.size());
  ties.jack.resize(ties.tie.size(), 0.0);
  ties.jack_work.resize(ties.tie.size(), 0.0);
  ties.pull.resize(ties.tie.size());
}

void list_elements(const World& w, Ties& ties) {
  std::map<std::int32_t, std::vector<std::int32_t>> holds;
  for (std::size_t k = 0; k < ties.hold.size(); ++k) {
    if (ties.hold[k].element != w.elements.base) holds[ties.hold[k].element].push_back(static_cast<std::int32_t>(k));
  }
  ties.first_of_element.push_back(0);
  for (const auto& [element, own] : holds) {
    ties.element.push_back(element);
    ties.hold_of_element.insert(ties.hold_of_element.end(), own.begin(), own.end());
    ties.first_of_element.push_back(static_cast<std::int32_t>(ties.hold_of_element.size()));
  }
}

/// M^(−1/2) of an element.
Matrix6 scale_of(const Elements& e, std::size_t i) {
  Eigen::Matrix3d inverse;
  inverse << e.ixx[i], e.ixy[i], e.ixz[i], e.ixy[i], e.iyy[i], e.iyz[i], e.ixz[i], e.iyz[i], e.izz[i];
  Matrix6 scale = Matrix6::Zero();
  scale.topLeftCorner<3, 3>().diagonal().setConstant(std::sqrt(e.inv_mass[i]));
  scale.bottomRightCorner<3, 3>() = inverse.llt().matrixL();
  return scale;
}

/// λ of the elements that ties hold [1/s2], by entry of Ties::element.
std::vector<double> joint_rates(const World& w) {
  const Ties& ties = w.ties;
  std::vector<Matrix6> k(ties.element.size(), Matrix6::Zero());
  const auto add = [&](std::int32_t element, const Matrix6& part) {
    const auto at = std::ranges::lower_bound(ties.element, element);
    if (at != ties.element.end() && *at == element) nth(k, at - ties.element.begin()) += part;
  };
  for (std::int64_t id = 0; id < w.sides.count(); ++id) {
    const auto i = static_cast<std::size_t>(id);
    if (w.sides.joint[i] < 0) continue;
    const kernels::Side side = w.sides.side(id);
    if (!std::ranges::binary_search(ties.element, side.master) && !std::ranges::binary_search(ties.element, side.slave)) continue;
    const Stiffness12 sum = side_stiffness(side, w.points.view(w.sides.set[i]));
    const Eigen::Map<const Eigen::Matrix<double, 12, 12>> both(sum.data());
    add(side.master, both.topLeftCorner<6, 6>());
    add(side.slave, both.bottomRightCorner<6, 6>());
  }
  std::vector<double> rates;
  for (std::size_t n = 0; n < k.size(); ++n) {
    const auto i = static_cast<std::size_t>(ties.element[n]);
    if (w.elements.inv_mass[i] == 0.0) {
      rates.push_back(0.0);
      continue;
    }
    const Matrix6 scale = scale_of(w.elements, i);
    rates.push_back(
        Eigen::SelfAdjointEigenSolver<Matrix6>(scale.transpose() * k[n] * scale, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff());
  }
  return rates;
}

/// 1/kg: by how much a unit force at the arm accelerates its point, at most in any direction.
double inverse_mass(const Elements& e, std::size_t i, Vec3 arm) {
  if (e.inv_mass[i] == 0.0) return 0.0;
  Eigen::Matrix3d inverse;
  inverse << e.ixx[i], e.ixy[i], e.ixz[i], e.ixy[i], e.iyy[i], e.iyz[i], e.ixz[i], e.iyz[i], e.izz[i];
  Eigen::Matrix3d lever;  // x ↦ arm × x
  lever << 0.0, -arm.z, arm.y, arm.z, 0.0, -arm.x, -arm.y, arm.x, 0.0;
  const Eigen::Matrix3d both = e.inv_mass[i] * Eigen::Matrix3d::Identity() + lever.transpose() * inverse * lever;
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(both, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

/// S of (32), by tie.
std::vector<double> moving_shares(const World& w) {
  std::vector<double> sum(w.ties.tie.size(), 0.0);
  for (const Ties::Hold& h : w.ties.hold) {
    const bool moves = h.element != w.elements.base && nth(w.elements.inv_mass, h.element) > 0.0;
    if (moves) nth(sum, h.tie) += std::abs(h.share);
  }
  return sum;
}

/// Takes the stiffness down and keeps the forces and plastic elongations at which the tie yields and breaks.
void soften(kernels::TieLaw& law, double factor) {
  const double k = law.stiffness, trial = k * law.breaking;
  const double most = trial <= law.yield ? trial : law.yield + law.hardening * (trial - law.yield) / (k + law.hardening);
  law.stiffness = factor * k;
  if (std::isfinite(law.breaking)) law.breaking += most / law.stiffness - most / k;
}

void bound_stiffness(World& w) {
  Ties& ties = w.ties;
  const std::vector<double> rates = joint_rates(w), moving = moving_shares(w);
  const double step = 4.0 / (w.dt * w.dt);
  std::vector<double> factor(ties.tie.size(), 1.0);
  for (std::size_t n = 0; n < ties.element.size(); ++n) {
    const auto holds = [&](auto&& use) {
      for (std::int32_t k = ties.first_of_element[n]; k < ties.first_of_element[n + 1]; ++k)
        use(nth(ties.hold, nth(ties.hold_of_element, k)));
    };
    double asked = 0.0;
    holds([&](const Ties::Hold& h) {
      const auto tie = static_cast<std::size_t>(h.tie);
      const double g = inverse_mass(w.elements, static_cast<std::size_t>(h.element), h.arm);
      asked += moving[tie] * std::abs(h.share) * ties.tie[tie].law.stiffness * g;
    });
    const double left = std::max(kOfStep * step - 2.0 * rates[n], kAtLeast * step);
    if (asked <= left) continue;
    holds([&](const Ties::Hold& h) {
      double& f = nth(factor, h.tie);
      f = std::min(f, left / asked);
    });
  }
  for (std::size_t i = 0; i < ties.tie.size(); ++i) {
    if (factor[i] < 1.0) soften(ties.tie[i].law, factor[i]);
  }
}

}  // namespace

void set_up_stiff_ties(World& w) {
  if (w.model.ties.empty()) return;
  take_bars(w);
  list_elements(w, w.ties);
}

void set_up_ties(World& w) {
  set_up_stiff_ties(w);
  if (!w.ties.tie.empty()) bound_stiffness(w);
}

}  // namespace voussoir::solver
