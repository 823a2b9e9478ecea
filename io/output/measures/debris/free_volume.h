// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/grid.h"
#include "io/output/measures/building.h"
#include "io/output/replay/placed_elements.h"

namespace voussoir::io {

/// The volume that a collapse leaves to those inside. A room's plan is cut into cells of about kCell; over each cell there is free the
/// height from the floor to the lowest element of the roof on one vertical line (never above where the roof was at first), less what other
/// elements take of that line.
class FreeVolume {
 public:
  static constexpr double kCell = 0.1;  // m

  /// \param start  poses in the reference configuration. Building and shapes outlive this.
  FreeVolume(const Building& building, const ElementShapes& shapes, const std::vector<Pose>& start);

  /// In the reference configuration, of all rooms together, m3; 0 without a room.
  [[nodiscard]] double initial() const noexcept { return initial_; }
  /// m3
  [[nodiscard]] double at(const std::vector<Pose>& poses) const;

 private:
  /// The cells of a room, x fastest.
  struct Grid {
    Room room;
    std::size_t nx, ny;
    double dx, dy;
    std::vector<double> ceiling;  // of each cell, m
  };
  [[nodiscard]] geometry::UniformGrid in_plan(const std::vector<Pose>& poses) const;
  [[nodiscard]] static std::vector<std::int32_t> over(const Room& room, const geometry::UniformGrid& plan);
  template <class Use>
  void for_each_chord(const Grid& g, const std::vector<Pose>& poses, const std::vector<std::int32_t>& near, bool cover,
                      const Use& use) const;
  void find_ceiling(Grid& g, const std::vector<Pose>& start, const std::vector<std::int32_t>& near) const;

  const Building& building_;
  const ElementShapes& shapes_;
  std::vector<Grid> grids_;
  double initial_ = 0;
};

}  // namespace voussoir::io
