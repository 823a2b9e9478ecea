// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/limit/coulomb.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace voussoir::solver {
namespace {

constexpr int kTurnsToLevel = 14, kMostSearches = 20, kMostPairs = 40;
constexpr std::size_t kPatience = 4;  // pairs of programmes after which what is missed must have got less
constexpr double kSlow = 0.9;         // by this factor
constexpr double kTurn = 0.7;         // of the slope of the limit, from one turn to the next
constexpr double kLevel = 0.01;       // of the slope of friction: what is left of it
constexpr double kStill = 1e-7;       // of the fastest point's speed: points that do not part, or do not slip
constexpr double kExact = 1e-7;       // mean weights times the fastest speed: forces that miss no more let a motion go on

geometry::Point2 on_axes(const BalancePoint& p, Vec3 v) { return {dot(v, p.first), dot(v, p.second)}; }

ProgrammeForces mean(const ProgrammeForces& a, const ProgrammeForces& b, double of_b) {
  ProgrammeForces out = a;
  for (std::size_t i = 0; i < out.shear.size(); ++i) {
    out.compression[i] += of_b * (b.compression[i] - a.compression[i]);
    out.shear[i] += of_b * (b.shear[i] - a.shear[i]);
  }
  for (std::size_t k = 0; k < out.ties.size(); ++k) out.ties[k] += of_b * (b.ties[k] - a.ties[k]);
  return out;
}

}  // namespace

void CoulombSearch::took(LimitState& out, double factor) const {
  ++out.programmes;
  if (tick_) tick_(factor * balance_.live_scale());
}

LimitState CoulombSearch::find(const ProgrammeForces& associated, double multiplier) {
  LimitState out;
  out.multiplier = multiplier;
  found_ = associated;
  compression_ = associated.compression;
  slope_.clear();
  for (const BalancePoint& p : balance_.points()) slope_.push_back(p.friction);
  int searches = 0;
  for (int turn = 1; searches < kMostSearches && iterate(out); ++turn)
    if (turn >= kTurnsToLevel && ++searches > 0 && search(out)) break;
  return out;
}

/// Compressions are averaged: taken as found they swing to and fro between mechanisms.
bool CoulombSearch::iterate(LimitState& out) {
  std::vector<double> cohesion(slope_.size());
  for (std::size_t i = 0; i < slope_.size(); ++i) {
    const double friction = balance_.points()[i].friction;
    slope_[i] = std::max(kTurn * slope_[i], kLevel * friction);
    cohesion[i] = (friction - slope_[i]) * compression_[i];
  }
  ProgrammeSolution s = programmes_.solve_yield(cohesion, slope_);
  if (s.outcome != LpOutcome::solved) return false;
  took(out, s.factor);
  const double last = out.multiplier;
  out.multiplier = s.factor * balance_.live_scale();
  out.last_change = std::abs(out.multiplier - last) / std::max(out.multiplier, 1e-12);
  for (std::size_t i = 0; i < compression_.size(); ++i) compression_[i] = 0.5 * (compression_[i] + s.forces.compression[i]);
  out.motion = std::move(s.motion);
  found_ = std::move(s.forces);
  return true;
}

/// With limits of shear that do not depend on compression, slip opens nothing: they give a motion. For that motion forces are looked for
/// that come nearest to letting it go on, which give new limits; what they miss gets less from one to the next.
bool CoulombSearch::search(LimitState& out) {
  ProgrammeForces forces = found_;
  std::vector<double> missed;
  for (int k = 0; k < kMostPairs; ++k) {
    std::vector<double> limit(forces.shear.size());
    for (std::size_t i = 0; i < limit.size(); ++i) {
      const BalancePoint& p = balance_.points()[i];
      limit[i] = std::max(p.friction * forces.compression[i], cone_.gauge(on_axes(p, forces.shear[i])));
    }
    const ProgrammeSolution moving = programmes_.solve_yield(limit, std::vector<double>(limit.size(), 0.0));
    if (moving.outcome != LpOutcome::solved) return false;
    took(out, moving.factor);
    const auto resisting = programmes_.solve_cheapest([&](std::size_t i, std::size_t corner) { return cost(moving.motion, i, corner); },
                                                      [&](std::size_t tie) { return tie_cost(moving.motion, tie); });
    if (resisting.outcome != LpOutcome::solved) return false;
    took(out, resisting.factor);
    if (prove(moving, resisting, out)) return true;
    forces = resisting.forces;
    missed.push_back(out.proof.lost_power);
    if (missed.size() > kPatience && missed.back() > kSlow * missed[missed.size() - 1 - kPatience]) return false;
  }
  return false;
}

/// The power that a unit of compression on an edge of a cone takes less than friction along this motion's slip, or gives where points part.
double CoulombSearch::cost(const std::vector<kernels::Twist>& motion, std::size_t point, std::size_t corner) const {
  const BalancePoint& p = balance_.points()[point];
  const Vec3 v = balance_.against(p, motion);
  const geometry::Point2 slip = on_axes(p, v), edge = cone_.corners()[corner];
  const double missed = dot(v, p.normal) + p.friction * (cone_.support(slip) - (edge.s * slip.s + edge.t * slip.t));
  return missed > kStill ? missed : 0.0;
}

/// The power that a unit of a tie's force takes where the tie gets slack, and that a unit less than its yield force misses where it gives
/// way.
TieCost CoulombSearch::tie_cost(const std::vector<kernels::Twist>& motion, std::size_t tie) const {
  const double giving = balance_.giving(balance_.ties()[tie], motion);
  return {giving < -kStill ? -giving : 0.0, giving > kStill ? giving : 0.0};
}

/// Of the forces that let this motion go on those of the multiplier found with it, or of the one nearest to that. Where none do, exactly,
/// those that miss least.
bool CoulombSearch::prove(const ProgrammeSolution& moving, const ProgrammeSolution& resisting, LimitState& out) {
  const auto allowed = [&](std::size_t i, std::size_t corner) { return cost(moving.motion, i, corner) == 0.0; };
  ProgrammeForces forces = resisting.forces;
  double low = resisting.factor, high = low, factor = low;
  if (resisting.missed < kExact) {
    const auto tie_costs = [&](std::size_t tie) { return tie_cost(moving.motion, tie); };
    ConeProgramme p{balance_.live(), balance_.dead(), LpGoal::least, kLpBound, allowed, {.yielding = true, .costs = tie_costs, .cost_row = {}}};
    for (double& r : p.right) r = -r;
    const ProgrammeSolution least = programmes_.solve(p);
    p.goal = LpGoal::most;
    const ProgrammeSolution most = programmes_.solve(p);
    if (least.outcome == LpOutcome::solved && most.outcome == LpOutcome::solved) {
      low = least.factor, high = std::max(low, most.factor), factor = std::clamp(moving.factor, low, high);
      forces = mean(least.forces, most.forces, high > low ? (factor - low) / (high - low) : 0.0);
    }
  }
  const double scale = balance_.live_scale();
  const ModelForces on_model = forces_on_model(balance_, forces);
  LimitProof proof;
  proof.lower = scale * low, proof.upper = scale * high;
  proof.forces = model_.check_forces(on_model, 1.0, scale * factor);
  proof.motion = model_.check_motion(moving.motion);
  proof.lost_power = model_.lost_power(on_model, moving.motion);
  proof.holds = proof.forces.worst() <= LimitProof::kForces && proof.motion.overlap <= LimitProof::kMotion &&
                proof.motion.stretch <= LimitProof::kMotion && proof.motion.live_power > 0.0 &&
                proof.lost_power <= LimitProof::kLost * std::max(scale * factor, LimitProof::kLeast * scale);
  out.multiplier = scale * factor;
  out.motion = moving.motion;
  out.ties = on_model.of_ties;
  out.proof = proof;
  return proof.holds;
}

}  // namespace voussoir::solver
