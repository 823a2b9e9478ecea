// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "kernels/rows.h"
#include "solver/limit/balance.h"
#include "solver/limit/friction_cone.h"
#include "solver/limit/programme/linear_programme.h"
#include "solver/limit/programme/tie_columns.h"

/// The linear programmes of limit analysis.
namespace voussoir::solver {

/// Forces in mean weights, at Balance::points.
struct ProgrammeForces {
  std::vector<double> compression;
  std::vector<Vec3> shear;   // on body a
  std::vector<double> ties;  // of Balance::ties
};

/// These forces on the model.
ModelForces forces_on_model(const Balance& balance, const ProgrammeForces& f);

struct ProgrammeSolution {
  LpOutcome outcome = LpOutcome::none;
  double factor = 0.0;  // of the pushing forces
  double missed = 0.0;  // solve_cheapest: the cost
  ProgrammeForces forces;
  std::vector<kernels::Twist> motion;  // by body (Balance::motion)
};

/// Forces at contact points within cones of friction: each force is a sum of forces on the edges of its cone, so that the programme has
/// only the equilibrium equations.
struct ConeProgramme {
  std::vector<double> pushing, right;  // by equation: factor × pushing + forces of contacts = right
  LpGoal goal = LpGoal::most;
  double bound = kLpBound;
  /// Whether the edge of a point's cone above a corner of its polygon may be used; empty: all.
  std::function<bool(std::size_t point, std::size_t corner)> allowed{};
  TieUse ties{};
};

class Programmes {
 public:
  Programmes(const Balance& balance, const FrictionCone& cone, LpOptions options)
      : balance_(balance), cone_(cone), options_(std::move(options)) {}

  [[nodiscard]] ProgrammeSolution solve(const ConeProgramme& p) const;
  /// The largest multiple of the live forces with a shear at each point of at most cohesion + slope × compression (and in the polygon).
  [[nodiscard]] ProgrammeSolution solve_yield(const std::vector<double>& cohesion, const std::vector<double>& slope) const;
  /// Admissible forces of least cost, under any multiple of the live forces.
  /// \param cost  of a unit of compression on an edge of a cone, >= 0
  [[nodiscard]] ProgrammeSolution solve_cheapest(const std::function<double(std::size_t point, std::size_t corner)>& cost,
                                                 const TieCosts& tie_costs) const;

 private:
  /// An edge of a point's cone, above a corner of its polygon.
  struct Edge {
    std::size_t point = 0, corner = 0;
  };
  [[nodiscard]] std::vector<Edge> all_edges() const;
  /// Adds the coefficients of a unit of compression on an edge.
  void add_edge(LinearProgramme& lp, Edge e) const;
  [[nodiscard]] ProgrammeForces forces_of(const std::vector<Edge>& edges, const std::vector<double>& compressions) const;

  const Balance& balance_;
  const FrictionCone& cone_;
  LpOptions options_;
};

}  // namespace voussoir::solver
