// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/grid.h"
#include "io/output/measures/building/building.h"
#include "io/output/replay/placed_elements.h"

namespace voussoir::io {

/// Volume that a collapse leaves free in rooms. A room's plan is divided into cells of about kCell; the free height over a cell is that
/// from the floor to the lowest roof element on one vertical line (at most to the initial position of the roof), less the part of the line
/// inside other elements.
class FreeVolume {
 public:
  static constexpr double kCell = 0.1;  // m

  /// \param start  poses in the reference configuration. Building and shapes must outlive the object.
  FreeVolume(const Building& building, const ElementShapes& shapes, const std::vector<Pose>& start);

  /// Free volume in the reference configuration, of all rooms together [m3]; 0 without a room.
  [[nodiscard]] double initial() const noexcept { return initial_; }
  /// Free volume of all rooms together at given poses [m3].
  [[nodiscard]] double at(const std::vector<Pose>& poses) const;

 private:
  /// Cells of a room, x fastest.
  struct Grid {
    Room room;
    std::size_t nx, ny;
    double dx, dy;
    std::vector<double> ceiling;  // m, by cell
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
