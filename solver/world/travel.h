// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kernels/rows.h"
#include "kernels/travel_bound.h"
#include "solver/world/array.h"

namespace voussoir::solver {

struct Elements;

/// How far elements have moved since contact was searched for them, and when it has to be searched again (THEORY.md, "Who is near").
///
/// Of each element it holds the pose of its last search and a travel bound: an upper bound on the path of any of its points since then,
/// the sum over the steps of Δt (|v| + |ω| r). Only an element whose bound has grown enough has its displacement computed.
///
/// Elements belong to batches (kernels::kBatch). A batch is active once something reads the velocities of one of its elements, a damaged
/// joint or a contact: from then on its elements have velocity rows, written by the drift, and travel bounds of their own. The elements of
/// a batch that is not active share one bound and have no velocity rows: fewer numbers to read and write in a step.
class Travel {
 public:
  Travel() = default;
  /// \param skin  m, see skin()
  Travel(const Elements& e, double skin);

  /// The skin [m]: a search lists the pairs that may touch before either element has moved by half of this.
  [[nodiscard]] double skin() const noexcept { return skin_; }
  /// m, that an element may move before it is searched again.
  [[nodiscard]] double limit() const noexcept { return 0.5 * skin_ - margin_; }
  /// Searches that are due may have to wait: an element is searched again so much earlier [m]. Before the first step.
  void set_margin(double margin) noexcept { margin_ = margin; }

  // Displacement since the search.
  /// m, of the point of an element that has moved most, or a little more. \pre is_searched()
  [[nodiscard]] double displacement(Elements& e, std::int32_t element) const noexcept;
  /// The same if it is over the limit, else 0; 0 before the first search.
  [[nodiscard]] double displacement_over_limit(Elements& e, std::int32_t element) const noexcept;
  struct Pose {
    Vec3 u;  // m, displacement of the centroid
    Mat3 r;  // orientation
  };
  /// Of an element at its last search. \pre is_searched()
  [[nodiscard]] Pose searched_pose(std::int32_t element) const noexcept;
  /// From here on the element counts as searched where it stands.
  void remember(const Elements& e, std::int32_t element) noexcept;
  /// The same for all elements, in place of whatever was remembered.
  void remember_all(const Elements& e);

  // Travel bounds.
  /// For kernels::advance_travel, once a step.
  [[nodiscard]] kernels::TravelView view(const Elements& e, double dt) noexcept;
  /// m, by element; those of active batches are kept up to date.
  [[nodiscard]] const double* bounds() const noexcept { return bound_.data(); }
  [[nodiscard]] double bound(std::int32_t element) const noexcept { return bound_[static_cast<std::size_t>(element)]; }
  /// An element has been moved by that distance [m] without a velocity: its bound grows by it.
  void add(std::int32_t element, double distance) noexcept { bound_[static_cast<std::size_t>(element)] += distance; }

  // Active batches.
  [[nodiscard]] bool is_active(std::int32_t element) const noexcept {
    return active_[static_cast<std::size_t>(element / kernels::kBatch)] != 0;
  }
  /// By batch, 0 or 1.
  [[nodiscard]] const std::vector<std::uint8_t>& active() const noexcept { return active_; }
  /// The batch of an element is active from the next drift on. Its elements have their displacements computed there.
  void activate_at_next_drift(std::int32_t element) noexcept;
  /// The batch is active at once: its velocity rows are written. For use between two steps.
  void activate(Elements& e, std::int32_t element) noexcept;

  // When to search.
  /// True once all elements have been searched.
  [[nodiscard]] bool is_searched() const noexcept { return !due_at_once_; }
  void set_searched() noexcept { due_at_once_ = false; }
  /// A search is due after so many steps at the latest.
  void ask_for_search(std::int32_t steps) noexcept;
  /// The search that was asked for is being done.
  void answer_search() noexcept { countdown_ = 0; }
  /// Whether a search is due in this step. Call once a step: it counts down to a search that was asked for.
  /// \param displacement  m, the largest that kernels::advance_travel found over the limit
  [[nodiscard]] bool search_due(double displacement) noexcept;

  // State and restoring.
  struct State {
    std::array<Array<double>*, 7> poses;  // ux, uy, uz, qw, qx, qy, qz; empty before the first search
    bool* due_at_once;
    std::int32_t* countdown;
  };
  /// What a checkpoint must hold of it (field_table.h).
  [[nodiscard]] State state() noexcept;
  /// Before a state is read: makes room for so many poses and sets all travel bounds to zero.
  void restart(std::size_t poses);

  /// Bytes that it holds.
  [[nodiscard]] std::size_t bytes() const noexcept;

 private:
  [[nodiscard]] kernels::SearchedPoses searched_poses(const Elements& e) const noexcept;

  double skin_ = 0.0, margin_ = 0.0;                // m
  bool due_at_once_ = true;                         // state
  std::int32_t countdown_ = 0;                      // steps to a search that was asked for, 0: none (state)
  Array<double> ux_, uy_, uz_, qw_, qx_, qy_, qz_;  // m, -; poses at the last search, by element (state)
  Array<double> bound_, safe_;                      // m, by element, see kernels::TravelBounds
  Array<double> batch_bound_, batch_safe_;          // m, by batch
  Array<double> largest_radius_;                    // m, by batch
  std::vector<std::uint8_t> active_;                // by batch
};

}  // namespace voussoir::solver
