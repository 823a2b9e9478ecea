// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/nth.h"
#include "kernels/rows.h"
#include "kernels/travel_bound.h"
#include "solver/world/array.h"

namespace voussoir::solver {

struct Elements;

/// Travel of elements since contacts were searched for them, and the times of the next searches (THEORY.md, "Who is near").
///
/// For each element it holds the pose at the last search and a travel bound: an upper bound on the path of any of its points since then,
/// the sum over the steps of Δt (|v| + |ω| r). Displacements are computed only for elements whose bound has grown enough.
///
/// Elements belong to batches (kernels::kBatch). A batch becomes active when something, a damaged joint or a contact, reads the velocities
/// of one of its elements: from then on its elements have velocity rows, written by the drift, and separate travel bounds. Elements of an
/// inactive batch share one bound and have no velocity rows, which saves memory traffic in a step.
class Travel {
 public:
  Travel() = default;
  /// \param skin  m, see skin() \param ahead  s, see reach()
  Travel(const Elements& e, double skin, double ahead = 0.0);

  /// The skin [m]: the least reach of two elements together.
  [[nodiscard]] double skin() const noexcept { return skin_; }
  /// Reach of an element [m]: its last search has listed the pairs that may touch before it has moved by this. Half of the skin, or as far
  /// as it would have come in the time `ahead` at the speed that it had then, whichever is more, but no more than kFarthest.
  [[nodiscard]] double reach(std::int32_t element) const noexcept { return nth(reach_, element); }
  /// Whether elements have reaches of their own.
  [[nodiscard]] bool looks_ahead() const noexcept { return ahead_ > 0.0; }
  static constexpr double kFarthest = 0.04;  // m
  /// Sets a margin [m] by which elements are searched earlier, since due searches may have to wait. To be called before the first step.
  void set_margin(double margin) noexcept { margin_ = margin; }

  // Upper bound, exceeded by little, on the displacement of any point of an element [m]. \pre is_searched()
  [[nodiscard]] double displacement(Elements& e, std::int32_t element) const noexcept;
  /// The displacement if an element has to be searched again for it, else 0; 0 before the first search.
  [[nodiscard]] double displacement_over_limit(Elements& e, std::int32_t element) const noexcept;
  struct Pose {
    Vec3 u;  // m, displacement of the centroid
    Mat3 r;  // orientation
  };
  /// Pose of an element at its last search. \pre is_searched()
  [[nodiscard]] Pose searched_pose(std::int32_t element) const noexcept;
  /// Marks an element as searched in its current pose.
  void remember(const Elements& e, std::int32_t element) noexcept;
  /// Marks all elements as searched in their current poses, replacing all earlier poses.
  void remember_all(const Elements& e);

  // Arguments of kernels::advance_travel, called once per step.
  [[nodiscard]] kernels::TravelView view(const Elements& e, double dt) noexcept;
  /// Travel bounds by element [m]; kept up to date for active batches only.
  [[nodiscard]] const double* bounds() const noexcept { return bound_.data(); }
  [[nodiscard]] double bound(std::int32_t element) const noexcept { return nth(bound_, element); }
  /// Adds a displacement without velocity [m] to an element's bound.
  void add(std::int32_t element, double distance) noexcept { nth(bound_, element) += distance; }

  // Active batches.
  [[nodiscard]] bool is_active(std::int32_t element) const noexcept { return nth(active_, element / kernels::kBatch) != 0; }
  /// By batch: 0 or 1.
  [[nodiscard]] const std::vector<std::uint8_t>& active() const noexcept { return active_; }
  /// Makes the batch of an element active from the next drift on, where the displacements of its elements are computed.
  void activate_at_next_drift(std::int32_t element) noexcept;
  /// Makes the batch of an element active at once: writes its velocity rows. For use between two steps.
  void activate(Elements& e, std::int32_t element) noexcept;

  // Whether all elements have been searched.
  [[nodiscard]] bool is_searched() const noexcept { return !due_at_once_; }
  void set_searched() noexcept { due_at_once_ = false; }
  /// Requests a search after at most `steps` steps.
  void ask_for_search(std::int32_t steps) noexcept;
  /// Clears the request, as the search is being done.
  void answer_search() noexcept { countdown_ = 0; }
  /// Whether a search is due in this step. To be called once per step, as it counts down to a requested search.
  /// \param displacement  m, the largest for which an element has to be searched again; 0: none
  [[nodiscard]] bool search_due(double displacement) noexcept;

  // State and restoring.
  struct State {
    std::array<Array<double>*, 7> poses;  // ux, uy, uz, qw, qx, qy, qz; empty before the first search
    Array<double>* reach;                 // constant where nothing looks ahead
    bool* due_at_once;
    std::int32_t* countdown;
  };
  /// Contents of a checkpoint (field_table.h).
  [[nodiscard]] State state() noexcept;
  /// Prepares for reading a state: allocates `poses` poses and sets all travel bounds to zero.
  void restart(std::size_t poses);

  /// Memory in bytes.
  [[nodiscard]] std::size_t bytes() const noexcept;

 private:
  [[nodiscard]] kernels::SearchedPoses searched_poses(const Elements& e) const noexcept;

  double skin_ = 0.0, margin_ = 0.0;                // m
  double ahead_ = 0.0;                              // s
  bool due_at_once_ = true;                         // state
  std::int32_t countdown_ = 0;                      // steps to a requested search, 0: none (state)
  Array<double> ux_, uy_, uz_, qw_, qx_, qy_, qz_;  // m, -; poses at the last search, by element (state)
  Array<double> reach_;                             // m, by element (state where elements have their own)
  Array<double> bound_, safe_;                      // m, by element, see kernels::TravelBounds
  Array<double> batch_bound_, batch_safe_;          // m, by batch
  Array<double> largest_radius_;                    // m, by batch
  std::vector<std::uint8_t> active_;                // by batch
};

}  // namespace voussoir::solver
