// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/equilibrium/path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace voussoir::solver {

namespace {

constexpr double kMostIterations = 100'000;                  // for a point
constexpr double kShortestRamp = 50, kLongestRamp = 20'000;  // iterations
constexpr double kRampPeriods = 0.25;                        // of the slowest motion in a ramp
constexpr double kInertia = 0.5;                             // of a step of the load factor: what inertia may bear in a ramp
constexpr double kFirstInertia = 2.5e-3;                     // of the weight, likewise, before there is a load factor
constexpr double kQuietGrowth = 1.5, kGrowth = 1.1;          // of the increment, if nothing was damaged, and else
constexpr double kQuietStep = 2.5, kElasticStep = 5.0;       // times Analysis::path_step, if nothing was damaged, or has been so far
constexpr double kForeseen = 0.05;                           // open share of the motion to a point, at most, where the next may be far
constexpr double kMostOfWay = 0.1, kElasticOfWay = 0.3;      // of the way so far; if nothing has been damaged
constexpr double kFew = 5e-4;                                // of all bonds: so many that slip or break count as none
constexpr double kMuch = 2e-3;                               // of all bonds: so many that break at once and the increment is halved
constexpr double kOfLoad = 2.5, kStrictest = 0.1;            // of the tolerance at a load factor of 1 in each; at least
constexpr double kLong = 20'000;                             // iterations from which on it is less strict again
constexpr double kLeast = 0.1;                               // of the first increment
// Factor on the length of ramps: after one in which the load factor exceeded both of its points, and after others; at most.
constexpr double kSlower = 2.0, kFaster = 0.7, kSlowest = 64.0;

}  // namespace

Path::Path(const cases::Analysis& a) : tolerance_(a.tolerance), step_(a.path_step) {}

double Path::pull() const noexcept {
  if (state_.ramp_left <= 0.0) return 0.0;
  return state_.increment / state_.ramp * (1.0 - std::cos(2.0 * std::numbers::pi * (state_.ramp_left - 0.5) / state_.ramp));
}

void Path::iterated(double factor) noexcept {
  state_.clock += pull();
  state_.highest = std::max(state_.highest, std::abs(factor));
  state_.ramp_left = std::max(0.0, state_.ramp_left - 1.0);
  state_.iterations += 1.0;
}

/// Where all loads are small against the weights, so are the forces that decide.
bool Path::rests(double unbalanced) const noexcept {
  const double share = state_.points > 1.0 && state_.most_factor > 0.0 ? std::clamp(kOfLoad * state_.most_factor, kStrictest, 1.0) : 1.0;
  const double strict = std::min(1.0, share * std::max(1.0, state_.iterations / kLong));
  return state_.ramp_left == 0.0 && state_.iterations >= 2.0 && unbalanced <= strict * tolerance_;
}

void Path::lose() noexcept { state_.iterations = kMostIterations + 1.0; }

bool Path::is_lost() const noexcept { return state_.iterations > kMostIterations; }

void Path::accept(const RestPoint& p, double period, double open) {
  const auto broken = static_cast<double>(p.broken), slipped = static_cast<double>(p.slipped), bonds = static_cast<double>(p.bonds);
  const double breaks = broken - state_.broken, slips = std::max(0.0, slipped - state_.slipped),
               change = std::abs(p.factor - state_.factor);
  const double overshoot = state_.highest - std::max(std::abs(p.factor), std::abs(state_.factor));
  state_.most_factor = std::max(state_.most_factor, std::abs(p.factor));
  state_.slower = std::clamp(state_.slower * (overshoot > step_ * state_.most_factor ? kSlower : kFaster), 1.0, kSlowest);
  double next = state_.increment;
  if (state_.points == 0.0) {
    next = state_.first;
  } else {
    const bool quiet = breaks + slips <= kFew * bonds;
    const bool elastic = quiet && broken == 0.0 && open <= kForeseen;
    const double most = step_ * (elastic ? kElasticStep : quiet ? kQuietStep : 1.0) * state_.most_factor;
    double growth = quiet ? kQuietGrowth : kGrowth;
    if (change > 0.0) growth = std::min(growth, std::max(0.5, most / change));
    if (breaks > kMuch * bonds) growth = std::min(growth, 0.5);
    // Where supports move: where it falls is known no better than this.
    const double of_way = !(state_.most_factor > 0.0) ? step_ : elastic ? kElasticOfWay : kMostOfWay;
    next = std::clamp(growth * next, kLeast * state_.first, std::max(state_.first, of_way * p.done));
  }
  state_.increment = std::min(next, p.left);
  // So that what speeds up the masses is small against a step of the load factor.
  const double bearable = state_.points > 0.0 && state_.most_factor > 0.0 ? kInertia * step_ * state_.most_factor : kFirstInertia;
  const double slow = std::sqrt(2.0 * std::numbers::pi * open * state_.increment * state_.inertia / bearable);
  const double ramp = std::clamp(std::max(kRampPeriods * open * period, slow), kShortestRamp, kLongestRamp);
  state_.ramp = std::round(std::min(state_.slower * ramp, kLongestRamp));
  state_.ramp_left = state_.ramp;
  state_.iterations = 0.0, state_.highest = 0.0;
  state_.factor = p.factor, state_.broken = broken, state_.slipped = slipped;
  state_.points += 1.0;
}

}  // namespace voussoir::solver
