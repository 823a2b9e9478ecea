// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/limit/programme/programmes.h"

#include <utility>

namespace voussoir::solver {
namespace {

void add_column(LinearProgramme& lp, const std::vector<double>& rows) {
  for (std::size_t r = 0; r < rows.size(); ++r)
    if (rows[r] != 0.0) lp.add(r, rows[r]);
  lp.end_column();
}

Vec3 shear_of(const BalancePoint& p, geometry::Point2 corner) { return corner.s * p.first + corner.t * p.second; }

}  // namespace

ModelForces forces_on_model(const Balance& balance, const ProgrammeForces& f) {
  std::vector<Vec3> all(f.shear.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = f.shear[i] - f.compression[i] * balance.points()[i].normal;
  return balance.forces(all, f.ties);
}

std::vector<Programmes::Edge> Programmes::all_edges() const {
  std::vector<Edge> all;
  for (std::size_t i = 0; i < balance_.points().size(); ++i) {
    const std::size_t corners = balance_.points()[i].friction > 0.0 ? cone_.corners().size() : 1;  // without friction all edges are one
    for (std::size_t k = 0; k < corners; ++k) all.push_back({i, k});
  }
  return all;
}

void Programmes::add_edge(LinearProgramme& lp, Edge e) const {
  const BalancePoint& p = balance_.points()[e.point];
  const Vec3 force = p.friction * shear_of(p, cone_.corners()[e.corner]) - p.normal;
  balance_.at_point(p, force, [&](std::size_t row, double value) { lp.add(row, value); });
}

ProgrammeForces Programmes::forces_of(const std::vector<Edge>& edges, const std::vector<double>& compressions) const {
  ProgrammeForces out{std::vector<double>(balance_.points().size()), std::vector<Vec3>(balance_.points().size()), {}};
  for (std::size_t c = 0; c < edges.size(); ++c) {
    const BalancePoint& p = balance_.points()[edges[c].point];
    out.compression[edges[c].point] += compressions[c];
    out.shear[edges[c].point] += compressions[c] * p.friction * shear_of(p, cone_.corners()[edges[c].corner]);
  }
  return out;
}

ProgrammeSolution Programmes::solve(const ConeProgramme& p) const {
  LinearProgramme lp(balance_.rows() + (p.ties.yielding ? TieColumns::limits(balance_) : 0), p.goal, p.bound);
  for (std::size_t r = 0; r < p.right.size(); ++r) lp.right(r) = p.right[r];
  add_column(lp, p.pushing);
  std::vector<Edge> edges;
  for (const Edge e : all_edges()) {
    if (p.allowed && !p.allowed(e.point, e.corner)) continue;
    add_edge(lp, e);
    lp.end_column();
    edges.push_back(e);
  }
  const TieColumns ties(balance_, lp, balance_.rows(), p.ties);
  const LpSolution found = lp.solve(options_);
  ProgrammeSolution out;
  out.outcome = found.outcome;
  if (found.outcome == LpOutcome::none) return out;
  out.factor = found.unknowns.front();
  out.forces = forces_of(edges, {found.unknowns.begin() + 1, found.unknowns.end()});
  out.forces.ties = ties.forces(found.unknowns);
  out.motion = balance_.motion(found.prices);
  return out;
}

ProgrammeSolution Programmes::solve_yield(const std::vector<double>& cohesion, const std::vector<double>& slope) const {
  const std::vector<BalancePoint>& points = balance_.points();
  const std::size_t rows = balance_.rows(), corners = cone_.corners().size();
  LinearProgramme lp(rows + points.size() + TieColumns::limits(balance_));
  for (std::size_t r = 0; r < rows; ++r) lp.right(r) = -balance_.dead()[r];
  add_column(lp, balance_.live());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto take = [&](std::size_t row, double value) { lp.add(row, value); };
    balance_.at_point(points[i], -points[i].normal, take);
    lp.add(rows + i, -slope[i]);
    lp.end_column();
    for (std::size_t k = 0; k < corners; ++k) {
      balance_.at_point(points[i], shear_of(points[i], cone_.corners()[k]), take);
      lp.add(rows + i, 1.0);
      lp.end_column();
    }
    lp.add(rows + i, 1.0);  // what is left up to the limit
    lp.end_column();
    lp.right(rows + i) = cohesion[i];
  }
  const TieColumns ties(balance_, lp, rows + points.size(), {});
  const LpSolution found = lp.solve(options_);
  ProgrammeSolution out;
  out.outcome = found.outcome;
  if (found.outcome == LpOutcome::none) return out;
  out.factor = found.unknowns.front();
  out.forces = {std::vector<double>(points.size()), std::vector<Vec3>(points.size()), ties.forces(found.unknowns)};
  std::size_t column = 1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    out.forces.compression[i] = found.unknowns[column++];
    for (std::size_t k = 0; k < corners; ++k) out.forces.shear[i] += found.unknowns[column++] * shear_of(points[i], cone_.corners()[k]);
    ++column;
  }
  out.motion = balance_.motion(found.prices);
  return out;
}

ProgrammeSolution Programmes::solve_cheapest(const std::function<double(std::size_t point, std::size_t corner)>& cost,
                                              const TieCosts& tie_costs) const {
  const std::size_t rows = balance_.rows();
  LinearProgramme lp(rows + 1 + TieColumns::limits(balance_), LpGoal::least);
  for (std::size_t r = 0; r < rows; ++r) lp.right(r) = -balance_.dead()[r];
  lp.add(rows, -1.0);  // the cost
  lp.end_column();
  add_column(lp, balance_.live());
  const std::vector<Edge> edges = all_edges();
  for (const Edge e : edges) {
    add_edge(lp, e);
    if (const double c = cost(e.point, e.corner); c > 0.0) lp.add(rows, c);
    lp.end_column();
  }
  const TieColumns ties(balance_, lp, rows + 1, {.yielding = true, .costs = tie_costs, .cost_row = rows});
  const LpSolution found = lp.solve(options_);
  ProgrammeSolution out;
  out.outcome = found.outcome;
  if (found.outcome == LpOutcome::none) return out;
  out.missed = found.unknowns[0], out.factor = found.unknowns[1];
  out.forces = forces_of(edges, {found.unknowns.begin() + 2, found.unknowns.end()});
  out.forces.ties = ties.forces(found.unknowns);
  return out;
}

}  // namespace voussoir::solver
