// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/walls/wall_legs.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "cases/house/house_thickness.h"
#include "cases/names.h"

namespace voussoir::cases {
namespace {

const double kCornerCosine = std::sqrt(0.75);  // of 30 degrees: the least turn of a corner, and the least angle between its walls

std::string point_name(std::size_t i) { return "point " + std::to_string(i + 1); }

Vec3 left_of(Vec3 u) noexcept { return {-u.y, u.x, 0.0}; }

void check_sizes(const WallSpec& wall, std::size_t index, const HousePlan& bricks, Faults& faults) {
  faults.attempt([&] { wall_thickness(wall.thickness, bricks, wall_key(index, "thickness")); });
  faults.attempt([&] { positive_length(wall.height, wall_key(index, "height")); });
  if (!(wall.base >= 0.0 && wall.base <= 1e4))
    faults.add({wall_key(index, "base"), text(wall.base) + " m; allowed: 0 (the base of the case) to 10000 m above it"});
  if (!(wall.load >= 0.0 && wall.load <= 1e6))
    faults.add({wall_key(index, "load"), text(wall.load) + " kg/m is out of range; allowed: 0 to 1000000"});
}

/// Directions of the sides of a polyline.
std::vector<Vec3> directions(const WallSpec& wall, std::size_t index, Faults& faults) {
  const std::string key = wall_key(index, "points");
  const std::size_t n = wall.points.size(), least = wall.closed ? 3 : 2;
  if (n < least) {
    faults.add(
        {key, "are " + std::to_string(n) + "; a " + (wall.closed ? "closed " : "") + "wall needs " + std::to_string(least) + " or more"});
    return {};
  }
  std::vector<Vec3> all;
  const std::size_t sides = wall.closed ? n : n - 1;
  for (std::size_t i = 0; i < sides; ++i) {
    const auto &a = wall.points[i], &b = wall.points[(i + 1) % n];
    const Vec3 side{b[0] - a[0], b[1] - a[1], 0.0};
    if (!(norm(side) >= least_piece(wall)))
      faults.add({key, "from " + point_name(i) + " to " + point_name((i + 1) % n) + " are " + text(norm(side)) +
                           " m; a side is a fifth of a brick or longer, at least " + text(least_piece(wall)) + " m"});
    else
      all.push_back(normalised(side));
  }
  return all;
}

/// Whether the wall has a corner at a point, between the sides of these directions. \throw InputError where it turns back too sharply
bool is_corner(std::size_t index, std::size_t point, Vec3 before, Vec3 behind) {
  const double cosine = dot(before, behind);
  if (cosine < -kCornerCosine - 1e-9) {
    const double degrees = std::acos(std::max(-1.0, cosine)) * 180.0 / 3.14159265358979323846;
    throw InputError(wall_key(index, "points"), point_name(point) + ": the sides there enclose " +
                                                    text(std::round(10.0 * (180.0 - degrees)) / 10.0) + " degrees; allowed: 30 or more");
  }
  return cosine < kCornerCosine + 1e-9;
}

class Polyline {
 public:
  Polyline(const WallSpec& wall, std::size_t index, std::vector<Vec3> sides) : wall_(wall), index_(index), sides_(std::move(sides)) {
    Faults faults;
    const std::size_t n = wall.points.size();
    corner_.assign(n, false);
    for (std::size_t i = 0; i < n; ++i) {
      if (!wall.closed && (i == 0 || i + 1 == n)) continue;
      faults.attempt([&] { corner_[i] = is_corner(index, i, side_before(i), sides_[i % sides_.size()]); });
      if (corner_[i]) continue;
      bends_ = true;
    }
    if (bends_ && wall.bond != WallBond::through)
      faults.add({wall_key(index, "bond"),
                  "the wall bends by less than 30 degrees; walls that bend are laid of blocks that go through "
                  "them: allowed: \"through\""});
    if (bends_ && wall.line != WallLine::middle)
      faults.add(
          {wall_key(index, "line"), "the points of a wall that bends by less than 30 degrees are of its middle; allowed: \"middle\""});
    faults.raise();
  }

  void add(WallsPlan& plan, std::vector<Corner>& corners) const {
    const std::size_t n = wall_.points.size(), sides = sides_.size();
    std::size_t first = 0;  // side that begins a leg
    while (wall_.closed && first < n && !corner_[first]) ++first;
    const bool ring = wall_.closed && first == n;
    if (ring) first = 0;
    const std::size_t first_leg = plan.legs.size();
    for (std::size_t k = 0; k < sides; ++k) {
      const std::size_t i = (first + k) % sides;
      if (k == 0 || corner_[i]) {
        if (k > 0) corners.push_back({plan.legs.size() - 1, plan.legs.size(), i});
        plan.legs.push_back(empty_leg());
        plan.legs.back().ring = ring;
      }
      add_side(i, plan.legs.back());
    }
    if (wall_.closed && !ring) corners.push_back({plan.legs.size() - 1, first_leg, first});
    name_legs(plan, first_leg);
  }

 private:
  [[nodiscard]] Vec3 side_before(std::size_t point) const { return sides_[(point + sides_.size() - 1) % sides_.size()]; }

  [[nodiscard]] Leg empty_leg() const {
    Leg leg;
    leg.wall = index_;
    leg.half = 0.5 * wall_.thickness;
    leg.line = wall_.line == WallLine::left ? leg.half : wall_.line == WallLine::right ? -leg.half : 0.0;
    leg.height = {ticks(wall_.base), ticks(wall_.base + wall_.height)};
    leg.eaves = leg.height.high;
    return leg;
  }

  void add_side(std::size_t i, Leg& leg) const {
    const auto &a = wall_.points[i], &b = wall_.points[(i + 1) % wall_.points.size()];
    Facet f;
    f.along = sides_[i], f.across = left_of(f.along);
    f.from = Vec3{a[0], a[1], 0.0} - leg.line * f.across;
    f.start = leg.facets.empty() ? 0.0 : leg.length();
    f.length = norm({b[0] - a[0], b[1] - a[1], 0.0});
    for (std::size_t k = 0; k < i; ++k) {
      const auto &from = wall_.points[k], &to = wall_.points[k + 1];
      f.place += norm({to[0] - from[0], to[1] - from[1], 0.0});
    }
    leg.facets.push_back(f);
  }

  void name_legs(WallsPlan& plan, std::size_t first) const {
    const bool several = plan.legs.size() - first > 1;
    for (std::size_t k = first; k < plan.legs.size(); ++k) {
      Leg& leg = plan.legs[k];
      const Vec3 along = leg.facets[0].along;
      const bool along_axis = leg.facets.size() == 1 && std::min(std::abs(along.x), std::abs(along.y)) < 1e-9;
      leg.tag = wall_.name + (several ? " " + std::to_string(k - first + 1) : "") + (along_axis ? " wall" : " walling");
    }
  }

  const WallSpec& wall_;
  std::size_t index_;
  std::vector<Vec3> sides_;
  std::vector<bool> corner_;  // by point
  bool bends_ = false;
};

}  // namespace

Vec3 Leg::at(double s, double d) const noexcept {
  if (ring) s = s < 0.0 ? s + length() : s >= length() ? s - length() : s;
  std::size_t i = facets.size() - 1;
  while (i > 0 && s < facets[i].start - 1e-9) --i;
  const Facet& f = facets[i];
  const bool bend = std::abs(s - f.start) <= 1e-9 && (i > 0 || ring);
  if (!bend) return f.from + (s - f.start) * f.along + d * f.across;
  const Vec3 before = facets[i > 0 ? i - 1 : facets.size() - 1].across;
  return f.from + d / (1.0 + dot(before, f.across)) * (before + f.across);
}

double Leg::place(double s) const noexcept {
  std::size_t i = facets.size() - 1;
  while (i > 0 && s < facets[i].start) --i;
  return facets[i].place + (s - facets[i].start);
}

const Station* Leg::end(LegEnd which) const noexcept {
  for (const Station& s : stations) {
    if (s.end == which) return &s;
  }
  return nullptr;
}

void add_legs(const WallSpec& wall, std::size_t index, WallsPlan& plan, std::vector<Corner>& corners) {
  Faults faults;
  check_sizes(wall, index, plan.bricks[index], faults);
  const std::vector<Vec3> sides = directions(wall, index, faults);
  faults.raise();
  Polyline(wall, index, sides).add(plan, corners);
}

}  // namespace voussoir::cases
