// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "cases/tables/analysis.h"

/// The path of a quasi-static analysis from one state of rest to the next (kernels/THEORY.md, section 13): how far the moving end, or the
/// clock of the supports, goes on, and when the structure rests.
namespace voussoir::solver {

/// Figures of a state of rest.
struct RestPoint {
  double factor = 0.0;       // load factor
  double done = 0.0;         // the way of the moving end so far, all ways counted
  std::int64_t broken = 0;   // segment sides
  std::int64_t slipped = 0;  // likewise, that still hold
  std::int64_t bonds = 0;    // segment sides with a bond at the start
  double left = 1e300;       // of the way, until the end or a reversal
};

class Path {
 public:
  Path() = default;
  explicit Path(const cases::Analysis& a);
  /// \param first  way of the moving end from rest under dead loads to the next point
  /// \param inertia  load factor that the fictitious masses add while the moving end speeds up by 1 m (supports: by 1 s of their clock) an
  /// iteration, per iteration
  void set(double first, double inertia) noexcept { state_.first = first, state_.inertia = inertia; }

  /// Way of the moving end in the next iteration, 0 while the structure relaxes.
  [[nodiscard]] double pull() const noexcept;
  /// After an iteration. \param factor  load factor in it
  void iterated(double factor) noexcept;
  [[nodiscard]] bool rests(double unbalanced) const noexcept;
  /// Whether there is no state of rest within reach.
  [[nodiscard]] bool is_lost() const noexcept;
  /// Gives up the point ahead: the structure falls.
  void lose() noexcept;
  /// Takes a state of rest as a point of the path, and goes on to the next. \param period  iterations in a period of the slowest motion
  /// \param open  share of the motion to the next point that nothing predicts
  void accept(const RestPoint& p, double period, double open);
  /// Way from the last point to the one ahead.
  [[nodiscard]] double increment() const noexcept { return state_.increment; }

  /// Way of the supports' clock so far [s].
  [[nodiscard]] double clock() const noexcept { return state_.clock; }
  [[nodiscard]] std::int64_t points() const noexcept { return static_cast<std::int64_t>(state_.points); }
  [[nodiscard]] std::int64_t iterations() const noexcept { return static_cast<std::int64_t>(state_.iterations); }

 private:
  friend struct FieldTable;
  struct State {                         // doubles only, see LoadProgram::State
    double first = 0.0, inertia = 0.0;   // see set()
    double increment = 0.0;              // way to the point ahead
    double ramp = 1.0, ramp_left = 0.0;  // iterations in which it goes there; left of them
    double iterations = 0.0;             // for the point ahead so far
    double points = 0.0;                 // accepted
    double clock = 0.0;
    double factor = 0.0, most_factor = 0.0, broken = 0.0, slipped = 0.0;  // at the last point; largest so far
    double highest = 0.0;                                                 // load factor, without its sign, on the way to the point ahead
    double slower = 1.0;                                                  // factor on the length of the next ramp
  };

  double tolerance_ = 0.0, step_ = 0.0;
  State state_;
};

}  // namespace voussoir::solver
