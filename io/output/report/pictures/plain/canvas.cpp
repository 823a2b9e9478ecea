// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/pictures/plain/canvas.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace voussoir::io {
namespace {

constexpr int kSamples = 2;        // along each side of a pixel
constexpr double kNearest = 1e-2;  // m; what is nearer to the camera is behind it
constexpr double kSeam = 0.02;     // samples that a polygon reaches beyond its edges: no seams between neighbours

std::uint8_t byte(double part) noexcept { return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(part, 0.0, 1.0))); }

Camera of_samples(Camera c) {
  c.width *= kSamples, c.height *= kSamples, c.focal *= kSamples;
  return c;
}

/// Where a point falls, in samples from the upper left corner.
struct Place {
  double x = 0.0, y = 0.0;
};

/// How dark a polygon is at a distance [pixels] from its edge.
double darkness(double distance, double edges) noexcept {
  const double d = std::clamp(1.25 - 1.25 * distance, 0.0, 1.0);
  return d * d * edges;
}

}  // namespace

/// A convex area of the picture, and 1 over the distance of what fills it, which is linear there.
struct Canvas::Area {
  struct Side {
    double a, b, c;  // a x + b y + c: distance from the side, inwards, in samples
  };
  std::vector<Side> sides;
  double at_x = 0.0, at_y = 0.0, at_0 = 0.0;  // the inverse distance is at_x x + at_y y + at_0 [1/m]
  double low = 0.0, high = 0.0;               // rows
  double width = 0.0;                         // samples, of a square with the same area over its circumference

  /// \param places  its corners in turn \return whether it has an area
  bool enclose(const std::vector<Place>& places) {
    double twice = 0.0, around = 0.0;
    low = high = places.front().y;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Place &p = places[i], &q = places[(i + 1) % places.size()];
      twice += p.x * q.y - q.x * p.y, around += std::hypot(q.x - p.x, q.y - p.y);
      low = std::min(low, p.y), high = std::max(high, p.y);
    }
    if (!(std::abs(twice) > 1e-9)) return false;
    width = 2.0 * std::abs(twice) / around;
    const double inwards = twice > 0.0 ? 1.0 : -1.0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Place &p = places[i], &q = places[(i + 1) % places.size()];
      const double length = inwards * std::hypot(q.x - p.x, q.y - p.y);
      if (length == 0.0) continue;
      const double a = (p.y - q.y) / length, b = (q.x - p.x) / length;
      sides.push_back({a, b, -a * p.x - b * p.y});
    }
    return true;
  }
};

Canvas::Canvas(const Camera& camera)
    : camera_(of_samples(camera)),
      inverse_(static_cast<std::size_t>(camera_.width) * static_cast<std::size_t>(camera_.height)),
      seen_(inverse_.size()) {}

void Canvas::put(std::size_t sample, float inverse, Rgb colour, double strength, bool keeps) {
  if (inverse < inverse_[sample]) return;
  auto& to = seen_[sample];
  const std::array<double, 3> parts{colour.red, colour.green, colour.blue};
  for (std::size_t k = 0; k < 3; ++k)
    to[k] = strength >= 1.0 ? byte(parts[k]) : byte(to[k] / 255.0 + strength * (parts[k] - to[k] / 255.0));
  if (keeps) inverse_[sample] = inverse;
}

void Canvas::fill(Rgb colour) {
  for (std::size_t s = 0; s < seen_.size(); ++s) put(s, 0.0F, colour, 1.0, true);
}

void Canvas::ground(double z, Rgb sky, const std::function<Rgb(double, double)>& colour) {
  const double above = camera_.place.z - z;
  std::size_t s = 0;
  for (int row = 0; row < camera_.height; ++row)
    for (int column = 0; column < camera_.width; ++column, ++s) {
      const Vec3 ray = ((column + 0.5 - 0.5 * camera_.width) / camera_.focal) * camera_.right -
                       ((row + 0.5 - 0.5 * camera_.height) / camera_.focal) * camera_.up - camera_.back;
      const double inverse = -ray.z / above;  // 1 over the distance along the camera's axis
      if (!(inverse > 0.0) || above < 0.0) {
        put(s, 0.0F, sky, 1.0, true);
        continue;
      }
      const Vec3 p = camera_.place + (1.0 / inverse) * ray;
      put(s, static_cast<float>(inverse), colour(p.x, p.y), 1.0, true);
    }
}

void Canvas::polygon(std::span<const Vec3> corners, std::optional<Vec3> normal, Rgb colour, double edges) {
  if (corners.size() < 3) return;
  std::vector<Place> places;
  std::vector<Vec3> seen;
  for (const Vec3& corner : corners) {
    const Vec3 p = camera_.seen(corner);
    if (!(p.z > kNearest)) return;
    seen.push_back(p);
    places.push_back({camera_.column(p), camera_.row(p)});
  }
  Vec3 n = cross(seen[1] - seen[0], seen[2] - seen[0]);
  if (normal) n = camera_.turned(*normal);
  const double d = dot(n, seen.front());
  if (d == 0.0 || (normal && d > 0.0)) return;
  Area area;
  if (!area.enclose(places)) return;
  area.at_x = n.x / (d * camera_.focal), area.at_y = -n.y / (d * camera_.focal);
  area.at_0 = n.z / d - 0.5 * (area.at_x * camera_.width + area.at_y * camera_.height);
  const double pixel = 2.0 * kSamples / area.width;  // of its width
  fill_area(area, colour, edges * std::clamp(1.4 - 0.7 * pixel, 0.0, 1.0));
}

void Canvas::fill_area(const Area& area, const Rgb& colour, double edges) {
  const int first = std::max(0, static_cast<int>(std::floor(std::clamp(area.low, 0.0, 1e6)))),
            last = std::min(camera_.height - 1, static_cast<int>(std::ceil(std::clamp(area.high, -1.0, 1e6))));
  for (int row = first; row <= last; ++row) {
    const double y = row + 0.5;
    double left = 0.0, right = camera_.width;  // where the row is within all sides
    for (const Area::Side& side : area.sides) {
      const double rest = side.b * y + side.c + kSeam;
      if (side.a > 0.0)
        left = std::max(left, -rest / side.a);
      else if (side.a < 0.0)
        right = std::min(right, -rest / side.a);
      else if (rest < 0.0)
        right = -1.0;
    }
    for (int column = static_cast<int>(std::ceil(std::min(left, 1.0 + camera_.width) - 0.5));
         column + 0.5 <= right && column < camera_.width; ++column) {
      const double x = column + 0.5;
      const auto inverse = static_cast<float>(area.at_x * x + area.at_y * y + area.at_0);
      Rgb shown = colour;
      if (edges > 0.0) {
        double nearest = 1e9;
        for (const Area::Side& side : area.sides) nearest = std::min(nearest, side.a * x + side.b * y + side.c);
        shown = (1.0 - darkness(std::max(nearest, 0.0) / kSamples, edges)) * colour;
      }
      put(static_cast<std::size_t>(row) * static_cast<std::size_t>(camera_.width) + static_cast<std::size_t>(column), inverse, shown, 1.0,
          true);
    }
  }
}

void Canvas::line(Vec3 from, Vec3 to, double width, Rgb colour, double strength, double nearer) {
  Vec3 p = camera_.seen(from), q = camera_.seen(to);
  if (p.z < q.z) std::swap(p, q);
  if (!(p.z > kNearest)) return;
  if (q.z < kNearest) q = p + ((p.z - kNearest) / (p.z - q.z)) * (q - p);
  for (Vec3* end : {&p, &q}) *end = std::max(1.0 - nearer / norm(*end), 0.1) * *end;
  const Place a{camera_.column(p), camera_.row(p)}, b{camera_.column(q), camera_.row(q)};
  const double length = std::hypot(b.x - a.x, b.y - a.y), half = 0.5 * kSamples * width;
  if (!(length > 1e-6)) return;
  const double ux = (b.x - a.x) / length, uy = (b.y - a.y) / length, beyond = 0.3 * half;
  const auto cut = [](double x, int most) { return static_cast<int>(std::clamp(x, 0.0, static_cast<double>(most))); };
  const double reach = half + 1.0;
  const int top = cut(std::floor(std::min(a.y, b.y) - reach), camera_.height),
            bottom = cut(std::ceil(std::max(a.y, b.y) + reach), camera_.height);
  for (int row = top; row < bottom; ++row) {
    double low = std::min(a.x, b.x) - reach, high = std::max(a.x, b.x) + reach;
    if (std::abs(uy) > 1e-3) {  // the row crosses the line at one place
      const double x = a.x + (row + 0.5 - a.y) * ux / uy, wide = (reach + std::abs(ux) * (beyond + 1.0)) / std::abs(uy);
      low = std::max(low, x - wide), high = std::min(high, x + wide);
    }
    for (int column = cut(std::floor(low), camera_.width); column < cut(std::ceil(high), camera_.width); ++column) {
      const double dx = column + 0.5 - a.x, dy = row + 0.5 - a.y, along = dx * ux + dy * uy, off = std::abs(dy * ux - dx * uy);
      if (along < -beyond || along > length + beyond) continue;
      const double cover = std::clamp(half + 0.5 - off, 0.0, 1.0), share = std::clamp(along / length, 0.0, 1.0);
      if (cover == 0.0) continue;
      const auto inverse = static_cast<float>((1.0 - share) / p.z + share / q.z);
      put(static_cast<std::size_t>(row) * static_cast<std::size_t>(camera_.width) + static_cast<std::size_t>(column), inverse, colour,
          strength * cover, false);
    }
  }
}

Image Canvas::image() const {
  Image out{camera_.width / kSamples, camera_.height / kSamples, {}};
  out.rgb.reserve(3 * static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height));
  for (int row = 0; row < out.height; ++row)
    for (int column = 0; column < out.width; ++column)
      for (std::size_t k = 0; k < 3; ++k) {
        int sum = kSamples * kSamples / 2;
        for (int i = 0; i < kSamples; ++i)
          for (int j = 0; j < kSamples; ++j)
            sum += seen_[static_cast<std::size_t>(row * kSamples + i) * static_cast<std::size_t>(camera_.width) +
                         static_cast<std::size_t>(column * kSamples + j)][k];
        out.rgb.push_back(static_cast<std::uint8_t>(sum / (kSamples * kSamples)));
      }
  return out;
}

}  // namespace voussoir::io
