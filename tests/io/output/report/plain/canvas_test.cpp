// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/pictures/plain/canvas.h"

#include <doctest/doctest.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "io/output/report/pictures/stills.h"

namespace voussoir::io {
namespace {

constexpr Rgb kBlack{}, kWhite{1, 1, 1}, kRed{1, 0, 0};
constexpr int kSize = 200;

/// From 10 m in front of the origin along y, x to the right: a square of 1 m there is 20 pixels wide.
Camera in_front() {
  Camera c;
  c.place = {0, -10, 0}, c.right = {1, 0, 0}, c.up = {0, 0, 1}, c.back = {0, -1, 0};
  c.focal = kSize, c.width = c.height = kSize;
  return c;
}

/// A square that faces the camera, y metres behind the origin.
std::vector<Vec3> square(double x, double y, double z, double half) {
  return {{x - half, y, z - half}, {x + half, y, z - half}, {x + half, y, z + half}, {x - half, y, z + half}};
}
constexpr Vec3 kTowards{0, -1, 0}, kAway{0, 1, 0};

std::uint8_t part(const Image& image, int x, int y, std::size_t channel) {
  return image.rgb[3 * static_cast<std::size_t>(y * image.width + x) + channel];
}
/// Sum of a channel, in pixels of full brightness.
double sum(const Image& image, std::size_t channel) {
  double all = 0.0;
  for (std::size_t i = channel; i < image.rgb.size(); i += 3) all += image.rgb[i] / 255.0;
  return all;
}

std::uint32_t number(const std::string& bytes, std::size_t at) {
  std::uint32_t n = 0;
  for (std::size_t k = 0; k < 4; ++k) n = 256U * n + static_cast<unsigned char>(bytes[at + k]);
  return n;
}

/// The pixels of a PNG file of one IDAT whose rows are differences from those above.
Image read_png(const std::string& png) {
  REQUIRE(png.starts_with("\x89PNG\r\n\x1a\n"));
  Image image;
  std::string kinds;
  for (std::size_t at = 8; at < png.size();) {
    const std::uint32_t size = number(png, at);
    const std::string kind = png.substr(at + 4, 4);
    kinds += kind;
    const auto* body = reinterpret_cast<const Bytef*>(png.data() + at + 4);
    CHECK(::crc32(0, body, size + 4) == number(png, at + 8 + size));
    if (kind == "IHDR") image.width = static_cast<int>(number(png, at + 8)), image.height = static_cast<int>(number(png, at + 12));
    if (kind == "IDAT") {
      const std::size_t row = 3 * static_cast<std::size_t>(image.width) + 1;
      std::vector<std::uint8_t> raw(row * static_cast<std::size_t>(image.height) + 1);
      uLongf length = raw.size();
      REQUIRE(::uncompress(raw.data(), &length, body + 4, size) == Z_OK);
      REQUIRE(length == raw.size() - 1);
      for (std::size_t i = 0; i < length; ++i) {
        if (i % row == 0)
          CHECK(raw[i] == 2);
        else
          image.rgb.push_back(static_cast<std::uint8_t>(raw[i] + (i < row ? 0 : image.rgb[image.rgb.size() - row + 1])));
      }
    }
    at += 12 + size;
  }
  CHECK(kinds == "IHDRIDATIEND");
  return image;
}

}  // namespace

TEST_CASE("A PNG file gives the pixels back, and its sums are right") {
  std::mt19937 random(7);
  for (const auto& [width, height] : {std::pair{1, 1}, {3, 2}, {17, 31}}) {
    Image image{width, height, {}};
    for (int i = 0; i < 3 * width * height; ++i) image.rgb.push_back(static_cast<std::uint8_t>(random() % 256));
    const Image back = read_png(png_of(image));
    CHECK(back.width == width);
    CHECK(back.height == height);
    CHECK(back.rgb == image.rgb);
  }
}

TEST_CASE("Each view has all points in its picture, and fills most of it along one of its sides") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> at(-5.0, 20.0);
  for (const std::string& view : kViews)
    for (int k = 0; k < 5; ++k) {
      std::vector<Vec3> points;
      for (int i = 0; i < 30; ++i) points.push_back({at(random), at(random), at(random)});
      const Camera c = camera_for(view, points, 320, 200);
      double widest = 0.0;
      for (const Vec3& p : points) {
        const Vec3 s = c.seen(p);
        CHECK(s.z > 0.0);
        const double x = std::abs(c.column(s) / 160.0 - 1.0), y = std::abs(c.row(s) / 100.0 - 1.0);
        CHECK(x < 0.95);
        CHECK(y < 0.95);
        widest = std::max({widest, x, y});
      }
      CHECK(widest > 0.8);
    }
}

TEST_CASE("A polygon covers what perspective gives it, turned to the camera alone") {
  for (const double y : {0.0, 10.0, -5.0}) {
    Canvas canvas(in_front());
    canvas.fill(kBlack);
    canvas.polygon(square(0.3, y, -0.2, 1.0), kTowards, kWhite, 0.0);
    const double side = 2.0 * kSize / (10.0 + y);
    CHECK(sum(canvas.image(), 0) == doctest::Approx(side * side).epsilon(0.03));
  }
  Canvas canvas(in_front());
  canvas.fill(kBlack);
  canvas.polygon(square(0, 0, 0, 1), kAway, kWhite, 0.0);           // its other side
  canvas.polygon(square(0, -20, 0, 1), kTowards, kWhite, 0.0);      // behind the camera
  canvas.polygon(square(1000, 0, 0, 1), kTowards, kWhite, 0.0);     // beside the picture
  canvas.polygon(square(0, -10, 0, 1), std::nullopt, kWhite, 0.0);  // around the camera
  CHECK(sum(canvas.image(), 0) == 0.0);
}

TEST_CASE("A polygon with edges that are level but for round-off covers what it should, and nothing beside it") {
  for (const double lean : {0.0, 1e-17, 1e-16, 1e-15, 1e-13, 1e-11, 1e-9})
    for (const double sign : {-1.0, 1.0}) {
      Canvas canvas(in_front());
      canvas.fill(kBlack);
      const std::vector<Vec3> corners{{-1, 0, -1}, {1, 0, -1 + sign * lean}, {1, 0, 1}, {-1, 0, 1 + sign * lean}};
      canvas.polygon(corners, std::nullopt, kWhite, 0.2);
      canvas.polygon(std::vector<Vec3>{{-300, 5, 40}, {300, 5, 40 + sign * lean}, {300, 5, 41}}, std::nullopt, kWhite,
                     0.0);  // above the picture
      CHECK(sum(canvas.image(), 0) == doctest::Approx(1600.0).epsilon(0.03));
    }
}

TEST_CASE("The nearest polygon is seen, in whatever order they are drawn") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> at(-3.0, 3.0), colour(0.0, 1.0);
  struct Drawn {
    std::vector<Vec3> corners;
    Rgb colour;
  };
  for (int k = 0; k < 5; ++k) {
    std::vector<Drawn> all;
    for (int i = 0; i < 25; ++i) {
      const Vec3 a{at(random), at(random), at(random)}, b{at(random), at(random), at(random)}, c{at(random), at(random), at(random)};
      all.push_back({{a, b, c}, {colour(random), colour(random), colour(random)}});
    }
    const auto drawn = [&] {
      Canvas canvas(in_front());
      canvas.fill(kBlack);
      for (const Drawn& d : all) canvas.polygon(d.corners, std::nullopt, d.colour, 0.2);
      return canvas.image().rgb;
    };
    const auto first = drawn();
    std::ranges::shuffle(all, random);
    CHECK(drawn() == first);
  }
}

TEST_CASE("Lines are as wide as they should be, hide nothing that is nearer, and are seen on what they lie on") {
  const auto with_line = [](double y, double nearer, double strength) {
    Canvas canvas(in_front());
    canvas.fill(kBlack);
    canvas.polygon(square(0, 0, 0, 2), kTowards, {0, 0, 1}, 0.0);
    canvas.line({-1, y, 0.13}, {1, y, 0.31}, 4.0, kRed, strength, nearer);
    return canvas.image();
  };
  const double length = std::hypot(40.0, 3.6) + 2.0 * 0.6;  // pixels, with its ends
  CHECK(sum(with_line(0.0, 0.03, 1.0), 0) == doctest::Approx(4.0 * length).epsilon(0.05));
  CHECK(sum(with_line(0.0, 0.03, 0.5), 0) == doctest::Approx(2.0 * length).epsilon(0.05));
  CHECK(sum(with_line(0.2, 0.03, 1.0), 0) == 0.0);
  Canvas across(in_front());  // from far in front to far behind the camera
  across.fill(kBlack);
  across.line({0, 1000, -1}, {0, -1000, -1}, 2.0, kRed, 1.0, 0.0);
  CHECK(part(across.image(), kSize / 2, kSize - 1, 0) > 200);
  CHECK(part(across.image(), kSize / 2, kSize / 2 - 3, 0) == 0);
}

TEST_CASE("The ground is below its horizon, and what stands on it is before it") {
  Canvas canvas(in_front());
  canvas.ground(-2.0, kWhite, [](double x, double) { return x < 0.0 ? kRed : kBlack; });
  canvas.polygon(square(0, 0, -2, 0.5), kTowards, {0, 1, 0}, 0.0);
  const Image image = canvas.image();
  CHECK(part(image, 10, kSize / 2 - 2, 1) == 255);  // sky
  CHECK(part(image, 10, kSize - 10, 0) == 255);
  CHECK(part(image, 10, kSize - 10, 1) == 0);
  CHECK(part(image, kSize - 10, kSize - 10, 0) == 0);
  CHECK(part(image, kSize / 2, kSize / 2 + 38, 1) == 255);  // its upper half
  CHECK(part(image, kSize / 2, kSize / 2 + 43, 1) == 0);    // its lower half is in the ground
}

}  // namespace voussoir::io
