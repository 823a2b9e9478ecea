// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "cases/analysis.h"

/// The path of a quasi-static analysis from one state of rest to the next (kernels/THEORY.md, section 13): how far the moving end, or the
/// clock of the supports, goes on, and when the structure rests.
namespace voussoir::solver {

/// What has come out where the structure rests.
struct RestPoint {
  double factor = 0.0;       // load factor
  double done = 0.0;         // the way of the moving end so far, all ways counted
  std::int64_t damaged = 0;  // segment sides that have slipped or broken
  std::int64_t bonds = 0;    // segment sides with a bond at the start
  double left = 1e300;       // of the way, until the end or a reversal
};

class Path {
 public:
  Path() = default;
  explicit Path(const cases::Analysis& a);
  /// Begins at rest under dead loads. \param first  way of the moving end from there to the next point
  void begin(double first) noexcept { state_ = {.first = first}; }

  /// Way of the moving end in the next iteration, 0 while the structure relaxes.
  [[nodiscard]] double pull() const noexcept { return state_.ramp_left > 0.0 ? state_.increment / state_.ramp : 0.0; }
  /// After an iteration. \param damaged  as in RestPoint
  void iterated() noexcept;
  [[nodiscard]] bool rests(double unbalanced) const noexcept;
  /// Whether there is no state of rest within reach.
  [[nodiscard]] bool is_lost() const noexcept;
  /// Takes a state of rest as a point of the path, and goes on to the next. \param period  iterations in a period of the slowest motion
  void accept(const RestPoint& p, double period);

  /// Way of the supports' clock so far [s].
  [[nodiscard]] double clock() const noexcept { return state_.clock; }
  [[nodiscard]] std::int64_t points() const noexcept { return static_cast<std::int64_t>(state_.points); }
  [[nodiscard]] std::int64_t iterations() const noexcept { return static_cast<std::int64_t>(state_.iterations); }

 private:
  friend struct FieldTable;
  struct State {                         // doubles only, see LoadProgram::State
    double first = 0.0;                  // see begin()
    double increment = 0.0;              // way to the point ahead
    double ramp = 1.0, ramp_left = 0.0;  // iterations in which it goes there; left of them
    double iterations = 0.0;             // for the point ahead so far
    double points = 0.0;                 // accepted
    double clock = 0.0;
    double factor = 0.0, most_factor = 0.0, damaged = 0.0;  // at the last point; largest so far
  };

  double tolerance_ = 0.0, step_ = 0.0;
  State state_;
};

}  // namespace voussoir::solver
