// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/debris/free_volume.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace voussoir::io {
namespace {

// Position of the vertical line in its cell, along x and y, as a share of the cell: chosen so that faces of bricks at multiples of 0.05 m
// do not contain lines.
constexpr double kPlace = 0.25;
constexpr double kMostCells = 4000;  // of a room along an axis: a damaged file may have any

/// Index range [first, last) of the cells whose lines lie in [from, to] [m].
std::pair<std::size_t, std::size_t> cells_between(double from, double to, double origin, double size, std::size_t count) {
  const auto number = [&](double x) {
    return static_cast<std::size_t>(std::clamp(std::ceil((x - origin) / size - kPlace), 0.0, static_cast<double>(count)));
  };
  return {number(from), number(to)};
}

}  // namespace

/// Elements by position in plan, so that the elements over a room are found without a search through all elements.
geometry::UniformGrid FreeVolume::in_plan(const std::vector<Pose>& poses) const {
  std::vector<geometry::Box3> boxes;
  boxes.reserve(poses.size());
  for (std::size_t e = 0; e < poses.size(); ++e) {
    const Vec3 c = poses[e].centre;
    const double r = shapes_.radius(e);
    boxes.push_back({{c.x - r, c.y - r, 0.0}, {c.x + r, c.y + r, 0.0}});
  }
  geometry::UniformGrid grid;
  grid.build(boxes);
  return grid;
}

std::vector<std::int32_t> FreeVolume::over(const Room& room, const geometry::UniformGrid& plan) {
  std::vector<std::int32_t> found;
  plan.query({{room.low[0], room.low[1], 0.0}, {room.high[0], room.high[1], 0.0}}, found);
  return found;
}

/// Calls `use` with each cell and chord of its vertical line in an element: with `cover`, elements of a floor or roof over the room, else
/// all other elements. \param near  elements to test, ascending
template <class Use>
void FreeVolume::for_each_chord(const Grid& g, const std::vector<Pose>& poses, const std::vector<std::int32_t>& near, bool cover,
                                const Use& use) const {
  for (const std::int32_t number : near) {
    const auto e = static_cast<std::size_t>(number);
    if ((building_.covers[e] >= g.room.storey) != cover) continue;
    const Vec3 c = poses[e].centre;
    const double r = shapes_.radius(e);
    const auto [i0, i1] = cells_between(c.x - r, c.x + r, g.room.low[0], g.dx, g.nx);
    const auto [j0, j1] = cells_between(c.y - r, c.y + r, g.room.low[1], g.dy, g.ny);
    for (std::size_t j = j0; j < j1; ++j) {
      for (std::size_t i = i0; i < i1; ++i) {
        const double x = g.room.low[0] + (static_cast<double>(i) + kPlace) * g.dx,
                     y = g.room.low[1] + (static_cast<double>(j) + kPlace) * g.dy;
        if (const auto chord = shapes_.chord(e, poses[e], x, y)) use(j * g.nx + i, *chord);
      }
    }
  }
}

FreeVolume::FreeVolume(const Building& building, const ElementShapes& shapes, const std::vector<Pose>& start)
    : building_(building), shapes_(shapes) {
  const geometry::UniformGrid plan = in_plan(start);
  for (const Room& room : building.rooms) {
    Grid g{room, 0, 0, 0, 0, {}};
    const auto cells = [](double length) { return static_cast<std::size_t>(std::lround(std::clamp(length / kCell, 1.0, kMostCells))); };
    g.nx = cells(room.high[0] - room.low[0]), g.ny = cells(room.high[1] - room.low[1]);
    g.dx = (room.high[0] - room.low[0]) / static_cast<double>(g.nx), g.dy = (room.high[1] - room.low[1]) / static_cast<double>(g.ny);
    find_ceiling(g, start, over(room, plan));
    grids_.push_back(std::move(g));
  }
  initial_ = at(start);
}

// The underside of the floor or roof, which is above the walls under a vault; without one over the cell, the top of the walls.
void FreeVolume::find_ceiling(Grid& g, const std::vector<Pose>& start, const std::vector<std::int32_t>& near) const {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  g.ceiling.assign(g.nx * g.ny, kNone);
  for_each_chord(g, start, near, true, [&](std::size_t cell, Chord c) { g.ceiling[cell] = std::min(g.ceiling[cell], c.low); });
  for (double& z : g.ceiling) z = g.room.top && z != kNone ? z : std::min(z, g.room.ceiling);
}

double FreeVolume::at(const std::vector<Pose>& poses) const {
  double volume = 0;
  const geometry::UniformGrid plan = in_plan(poses);
  for (const Grid& g : grids_) {
    const std::vector<std::int32_t> near = over(g.room, plan);
    std::vector<double> cover = g.ceiling, filled(g.ceiling.size(), 0.0);
    for_each_chord(g, poses, near, true, [&](std::size_t cell, Chord c) { cover[cell] = std::min(cover[cell], c.low); });
    for_each_chord(g, poses, near, false, [&](std::size_t cell, Chord c) {
      filled[cell] += std::max(0.0, std::min(c.high, cover[cell]) - std::max(c.low, g.room.floor));
    });
    for (std::size_t cell = 0; cell < cover.size(); ++cell)
      volume += std::max(0.0, cover[cell] - g.room.floor - filled[cell]) * g.dx * g.dy;
  }
  return volume;
}

}  // namespace voussoir::io
