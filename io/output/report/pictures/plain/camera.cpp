// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/pictures/plain/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace voussoir::io {
namespace {

constexpr double kAngle = 35.0 * std::numbers::pi / 180.0;  // from the lower to the upper edge of the picture
constexpr double kMargin = 0.88;                            // share of the picture that the points fill
constexpr int kRounds = 6;                                  // the middle of the picture moves with what is nearest

struct View {
  const char* name;
  Vec3 to_camera;
};
constexpr std::array<View, 8> kDirections{{{"corner", {1, -1.4, 0.8}},
                                           {"rearcorner", {-1, 1.4, 0.8}},
                                           {"front", {0, -1, 0.12}},
                                           {"rear", {0, 1, 0.12}},
                                           {"left", {-1, 0, 0.12}},
                                           {"side", {1, 0, 0.12}},
                                           {"top", {0, -0.001, 1}},
                                           {"plan", {0, -0.001, 1}}}};

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  void include(double x) noexcept { low = std::min(low, x), high = std::max(high, x); }
  [[nodiscard]] double middle() const noexcept { return 0.5 * (low + high); }
};

}  // namespace

Camera camera_for(const std::string& view, const std::vector<Vec3>& points, int width, int height) {
  const auto* found = std::ranges::find_if(kDirections, [&](const View& v) { return view == v.name; });
  Camera c;
  c.width = width, c.height = height;
  c.back = normalised((found == kDirections.end() ? kDirections.front() : *found).to_camera);
  c.right = normalised(cross({0, 0, 1}, c.back)), c.up = cross(c.back, c.right);
  c.focal = 0.5 * height / std::tan(0.5 * kAngle);
  Vec3 target;
  for (const Vec3& p : points) target += p / static_cast<double>(points.size());
  const double tall = kMargin * 0.5 * height / c.focal, wide = tall * width / height;
  double distance = 0.1;
  for (int round = 0; round < kRounds; ++round) {
    const auto at = [&](const Vec3& p) { return Vec3{dot(p - target, c.right), dot(p - target, c.up), dot(p - target, c.back)}; };
    distance = 0.1;
    for (const Vec3& p : points) {
      const Vec3 q = at(p);
      distance = std::max({distance, q.z + std::abs(q.x) / wide, q.z + std::abs(q.y) / tall});
    }
    Range across, along;
    for (const Vec3& p : points) {
      const Vec3 q = at(p);
      across.include(q.x / (distance - q.z)), along.include(q.y / (distance - q.z));
    }
    if (!points.empty()) target += distance * across.middle() * c.right + distance * along.middle() * c.up;
  }
  c.place = target + distance * c.back;
  return c;
}

}  // namespace voussoir::io
