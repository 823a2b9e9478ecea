// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/solids/fit/fit_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/polyhedron.h"

namespace voussoir::geometry {

namespace {

constexpr double kAbove = 5e-7;      // m: so much above a plane is lost to nobody
constexpr double kKept = 0.9;           // of the area of a share: if less is kept, the body is cut
constexpr double kWorthACut = 0.02;     // of the areas of all shares of a face: smaller shares are not worth a cut
constexpr std::size_t kMostCells = 16;  // of one body
constexpr double kOfAPair = 40.0;       // ns, of comparing two shares

double area_of(std::span<const Vec3> polygon) {
  Vec3 doubled;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) doubled += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  return 0.5 * norm(doubled);
}

std::vector<Vec3> under(const std::vector<Vec3>& polygon, const HalfSpace& h) {
  std::vector<Vec3> out;
  const auto height = [&](Vec3 v) { return dot(h.normal, v) - h.offset; };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 p = polygon[i], q = polygon[(i + 1) % polygon.size()];
    const double hp = height(p), hq = height(q);
    if (hp <= 0.0) out.push_back(p);
    if ((hp < 0.0 && hq > 0.0) || (hp > 0.0 && hq < 0.0)) out.push_back(p + (hp / (hp - hq)) * (q - p));
  }
  return out;
}

/// The share of an area that a plane leaves.
double kept(const FaceShare& of, HalfSpace by) {
  by.offset += kAbove;
  const double all = area_of(of.area);
  return all > 0.0 ? area_of(under(of.area, by)) / all : 1.0;
}

/// The plane square to a face between two areas on it, with the first on its inner side: where they are farthest apart, or overlap least.
HalfSpace separator(const FaceShare& a, const FaceShare& b, Vec3 normal) {
  HalfSpace best;
  double widest = -std::numeric_limits<double>::infinity();
  const auto try_edges = [&](const std::vector<Vec3>& polygon) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec3 across = cross(polygon[(i + 1) % polygon.size()] - polygon[i], normal);
      if (!(norm(across) > 0.0)) continue;
      for (const Vec3 n : {normalised(across), -normalised(across)}) {
        double high = -1e300, low = 1e300;
        for (const Vec3& v : a.area) high = std::max(high, dot(n, v));
        for (const Vec3& v : b.area) low = std::min(low, dot(n, v));
        if (low - high > widest) widest = low - high, best = {n, 0.5 * (low + high)};
      }
    }
  };
  try_edges(a.area);
  try_edges(b.area);
  return best;
}

class Cells {
 public:
  Cells(std::span<const HalfSpace> own, FitWork& work, std::int32_t stone) : own_(own), work_(work), stone_(stone) {}

  void divide(std::vector<FaceShare> shares, std::vector<HalfSpace> cuts) {
    std::size_t first = 0, second = 0;
    if (cells.size() + cuts.size() >= kMostCells || !find_conflict(shares, first, second)) return add(shares, std::move(cuts));
    const HalfSpace by = separator(shares[first], shares[second], own_[shares[first].face].normal);
    if (!(norm(by.normal) > 0.5)) return add(shares, std::move(cuts));
    for (const HalfSpace& side : {by, HalfSpace{-by.normal, -by.offset}}) {
      std::vector<FaceShare> left;
      for (std::size_t i = 0; i < shares.size(); ++i) {
        // Of the two that are parted, each goes to its side alone, or there would be no end.
        if ((i == first || i == second) && (i == first) != (side.normal == by.normal)) continue;
        FaceShare part = shares[i];
        part.area = under(part.area, side);
        if (area_of(part.area) > 1e-3 * area_of(shares[i].area)) left.push_back(std::move(part));
      }
      std::vector<HalfSpace> around = cuts;
      around.push_back(side);
      divide(std::move(left), std::move(around));
    }
  }

  std::vector<std::vector<HalfSpace>> cells;

 private:
  /// The pair of shares of one face of which one loses most by the plane of the other.
  bool find_conflict(const std::vector<FaceShare>& shares, std::size_t& first, std::size_t& second) {
    work_.add(kOfAPair * static_cast<double>(shares.size()) * static_cast<double>(shares.size()), stone_);
    double least = kKept;
    for (std::size_t i = 0; i < shares.size(); ++i) {
      double all = 0.0;
      for (const FaceShare& s : shares) all += s.face == shares[i].face ? area_of(s.area) : 0.0;
      if (area_of(shares[i].area) < kWorthACut * all) continue;
      for (std::size_t k = 0; k < shares.size(); ++k) {
        if (i == k || shares[k].face != shares[i].face) continue;
        const double left = kept(shares[i], shares[k].plane);
        if (left < least) least = left, first = i, second = k;
      }
    }
    return least < kKept;
  }

  void add(const std::vector<FaceShare>& shares, std::vector<HalfSpace> planes) {
    for (std::size_t f = 0; f < own_.size(); ++f) {
      const bool has_share = std::any_of(shares.begin(), shares.end(), [&](const FaceShare& s) { return s.face == f; });
      if (!has_share) planes.push_back(own_[f]);
    }
    for (const FaceShare& s : shares) {
      const auto same = [&](const HalfSpace& h) { return h.normal == s.plane.normal && h.offset == s.plane.offset; };
      if (std::none_of(planes.begin(), planes.end(), same)) planes.push_back(s.plane);
    }
    cells.push_back(std::move(planes));
  }

  std::span<const HalfSpace> own_;
  FitWork& work_;
  std::int32_t stone_;
};

}  // namespace

std::vector<std::vector<HalfSpace>> fitted_cells(std::span<const HalfSpace> own, std::span<const FaceShare> shares, FitWork& work,
                                                 std::int32_t stone) {
  Cells cells(own, work, stone);
  cells.divide({shares.begin(), shares.end()}, {});
  return std::move(cells.cells);
}

}  // namespace voussoir::geometry
