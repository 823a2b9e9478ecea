// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/pictures/plain/plain_scene.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <string_view>

#include "cases/case.h"
#include "geometry/nth.h"
#include "io/input/files/errors.h"
#include "io/output/replay/opened_faces.h"
#include "io/output/results/case_of_run.h"

namespace voussoir::io {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr std::uint8_t kApart = 10;  // level of a crack whose bricks are apart: their faces show, and no line joins them
constexpr double kLifted = 0.03;     // m that crack lines are nearer than the faces on which they lie, in a model of metres

// Colours of the page (scripts/report/src/colours.js, house.js).
constexpr Rgb rgb(std::uint32_t hex) { return {(hex >> 16U) / 255.0, ((hex >> 8U) & 255U) / 255.0, (hex & 255U) / 255.0}; }
constexpr Rgb kRed = rgb(0xd31515), kSky{0.965, 0.96, 0.945}, kGround{0.895, 0.875, 0.84}, kShadow{0.8, 0.775, 0.735}, kGrid{0.4, 0.4, 0.4};
struct Material {
  std::array<std::string_view, 3> words;
  Rgb colour;
};
constexpr std::array<Material, 6> kMaterials{{{{"wood", "timber", "beam"}, rgb(0x8a5f38)},
                                              {{"adobe", "earth", "mud"}, rgb(0xcbb389)},
                                              {{"brick", "clay", "clay"}, rgb(0xb98d70)},
                                              {{"concrete", "ring", "ring"}, rgb(0xa9adb0)},
                                              {{"stone", "stone", "stone"}, rgb(0xb4b1a8)},
                                              {{"soft", "soft", "soft"}, rgb(0xd6cda8)}}};
constexpr std::array<Rgb, 4> kOthers{rgb(0xbfb8a5), rgb(0x9fb0ba), rgb(0xa8b59a), rgb(0xb9a8b5)};

/// How crack lines are drawn, from a level on (joint_cracks.h).
struct CrackLine {
  std::uint8_t level;
  double pixels, strength;
};
constexpr std::array<CrackLine, 4> kCrackLines{{{1, 2.0, 0.7}, {3, 3.0, 0.85}, {6, 4.5, 1.0}, {8, 6.0, 1.0}}};

Rgb colour_of(std::string name, std::size_t row) {
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const auto* known = std::ranges::find_if(kMaterials, [&](const Material& m) {
    return std::ranges::any_of(m.words, [&](auto w) { return name.find(w) != std::string::npos; });
  });
  return known == kMaterials.end() ? kOthers[row % kOthers.size()] : known->colour;
}

/// Two lamps, as in the page (scripts/report/src/brick.js).
double light_on(Vec3 normal) {
  const double light =
      0.42 + 0.55 * std::max(0.0, dot(normal, {-0.218, -0.436, 0.873})) + 0.22 * std::max(0.0, dot(normal, {0.812, 0.487, 0.325}));
  return std::pow(light, 1.0 / 2.2);
}

double smooth(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

Vec3 vector_at(const std::vector<double>& values, std::size_t i) { return {values[3 * i], values[3 * i + 1], values[3 * i + 2]}; }

std::vector<Rgb> colours_of(const Hdf5File& run, std::size_t elements, const std::vector<std::int32_t>& faults) {
  const auto material = run.read<std::int32_t>("/model/element/material");
  const std::vector<std::string> names = run.read_strings("/model/material/name");
  if (material.size() != elements) throw FileError(run.path(), "/model/element does not fit together");
  std::vector<Rgb> out;
  for (const std::int32_t m : material) {
    if (m < 0 || static_cast<std::size_t>(m) >= names.size()) throw FileError(run.path(), "/model/element/material names no material");
    out.push_back(colour_of(nth(names, m), static_cast<std::size_t>(m)));
  }
  for (const std::int32_t e : faults) nth(out, e) = kRed;
  return out;
}

std::uint64_t nearest_frame(const std::vector<double>& times, double time) {
  const auto found = std::ranges::min_element(times, {}, [&](double t) { return std::abs(t - time); });
  return static_cast<std::uint64_t>(found - times.begin());
}

}  // namespace

PlainScene::PlainScene(const Hdf5File& run, const std::vector<std::int32_t>& faults)
    : run_(run), frames_(run), colour_(colours_of(run, frames_.elements(), faults)) {
  if (frames_.frames() > 0) cracks_ = joint_cracks(run, frames_);
  const cases::Case c = case_of_run(run);
  if (c.base) base_ = c.base->z;
  read_faces();
}

void PlainScene::read_faces() {
  if (!run_.exists("/model/face/corners"))
    throw FileError(run_.path(), "is of an early version: it has no corners of faces, so that its pictures need Chromium");
  const auto vertex = run_.read<double>("/model/vertex"), normal = run_.read<double>("/model/face/normal");
  const auto element = run_.read<std::int32_t>("/model/face/element"), first = run_.read<std::int32_t>("/model/face/first_corner"),
             corner = run_.read<std::int32_t>("/model/face/corners");
  const auto refuse = [&] { throw FileError(run_.path(), "/model/face does not fit together"); };
  if (first.size() != element.size() || normal.size() != 3 * element.size()) refuse();
  low_ = {kNever, kNever, kNever}, high_ = -low_;
  for (std::size_t f = 0; f < element.size(); ++f) {
    const std::size_t from = static_cast<std::size_t>(first[f]),
                      end = f + 1 < first.size() ? static_cast<std::size_t>(first[f + 1]) : corner.size();
    if (first[f] < 0 || end < from || end > corner.size() || element[f] < 0 || static_cast<std::size_t>(element[f]) >= frames_.elements())
      refuse();
    Face face{element[f], vector_at(normal, f), {}, kNever};
    for (std::size_t k = from; k < end; ++k) {
      if (corner[k] < 0 || static_cast<std::size_t>(corner[k]) >= vertex.size() / 3) refuse();
      const Vec3 v = vector_at(vertex, static_cast<std::size_t>(corner[k]));
      low_ = {std::min(low_.x, v.x), std::min(low_.y, v.y), std::min(low_.z, v.z)};
      high_ = {std::max(high_.x, v.x), std::max(high_.y, v.y), std::max(high_.z, v.z)};
      face.corners.push_back(v - vector_at(frames_.start(), static_cast<std::size_t>(element[f])));
    }
    faces_.push_back(std::move(face));
  }
  if (faces_.empty()) refuse();
  if (frames_.frames() == 0) return;
  const OpenedFaces opened = opened_faces(run_, cracks_.shown);
  std::multimap<std::int32_t, std::size_t> rows;  // of opened, by element
  for (std::size_t i = 0; i < opened.element.size(); ++i) rows.emplace(opened.element[i], i);
  for (Face& face : faces_) {
    const auto [at, end] = rows.equal_range(face.element);
    for (auto row = at; row != end; ++row) {
      const std::size_t i = row->second;
      const Vec3 n{opened.normal[3 * i], opened.normal[3 * i + 1], opened.normal[3 * i + 2]};
      if (dot(n, face.normal) > 0.9999) face.opened = std::min(face.opened, static_cast<double>(opened.time[i]));
    }
  }
}

std::vector<Vec3> PlainScene::placed(const Face& face, const std::vector<Pose>& poses) const {
  std::vector<Vec3> out;
  for (const Vec3& corner : face.corners) out.push_back(nth(poses, face.element).point(corner));
  return out;
}

/// What a picture has to hold: the model as it was, and its elements where they are now, but for those that went far.
std::vector<Vec3> PlainScene::in_view(const std::vector<Pose>& poses) const {
  std::vector<Vec3> points;
  for (unsigned i = 0; i < 8; ++i)
    points.push_back({(i & 1U) != 0 ? high_.x : low_.x, (i & 2U) != 0 ? high_.y : low_.y, (i & 4U) != 0 ? high_.z : low_.z});
  const Vec3 middle = 0.5 * (low_ + high_);
  const double size = norm(high_ - low_);
  for (const Pose& p : poses) {
    const double far = std::hypot(p.centre.x - middle.x, p.centre.y - middle.y);
    if (far < 1.3 * size && far > 0.4 * size) points.push_back(p.centre);
  }
  return points;
}

/// The ground, which fades into the sky, with a grid of metres (of tens or tenths, by the size of the model) and the shadows of all
/// elements.
void PlainScene::draw_ground(Canvas& canvas, const std::vector<Pose>& poses) const {
  if (!base_) return canvas.fill(kSky);
  const double z = *base_, size = norm(high_ - low_);
  const Vec3 middle = 0.5 * (low_ + high_);
  double step = 1.0;  // m, between lines of the grid: not too many of them, nor none
  while (size > 60.0 * step) step *= 10.0;
  while (size < 0.3 * step) step *= 0.1;
  const double half = std::clamp(std::ceil(2.0 * size / step), 12.0, 120.0) * step, above = std::min(0.002, 1e-3 * size);
  canvas.ground(z, kSky, [&](double x, double y) {
    const double far = std::hypot(x - middle.x, y - middle.y) / (4.0 * half);
    return mixed(kGround, kSky, smooth(0.25, 1.0, far));
  });
  for (const Face& face : faces_) {
    const Vec3 n = nth(poses, face.element).rotation * face.normal;
    if (!(dot(n, {-0.25, -0.5, 1.0}) > 0.0)) continue;  // those in the light cast all of the shadow
    std::vector<Vec3> corners = placed(face, poses);
    for (Vec3& p : corners) p = {p.x + 0.25 * (p.z - z), p.y + 0.5 * (p.z - z), z + above};
    canvas.polygon(corners, std::nullopt, kShadow, 0.0);
  }
  const double x = step * std::round(middle.x / step), y = step * std::round(middle.y / step), height = z + 2.0 * above;
  const int lines = static_cast<int>(std::lround(half / step));
  for (int k = -lines; k <= lines; ++k) {
    const double i = step * k;
    canvas.line({x - half, y + i, height}, {x + half, y + i, height}, 1.0, kGrid, 0.28, 0.0);
    canvas.line({x + i, y - half, height}, {x + i, y + half, height}, 1.0, kGrid, 0.28, 0.0);
  }
}

/// Open joints as lines along their edges, halfway between their two bricks.
void PlainScene::draw_cracks(Canvas& canvas, const std::vector<Pose>& poses, std::size_t frame) const {
  const std::size_t joints = cracks_.edges.size();
  const double lifted = std::min(kLifted, 0.01 * norm(high_ - low_));
  const auto point = [&](std::size_t end, std::int32_t element) {
    const Vec3 p{cracks_.ends[3 * end], cracks_.ends[3 * end + 1], cracks_.ends[3 * end + 2]};
    return element < 0 ? p : nth(poses, element).point(p - vector_at(frames_.start(), static_cast<std::size_t>(element)));
  };
  std::size_t end = 0;
  for (std::size_t j = 0; j < joints; ++j) {
    const std::uint8_t level = cracks_.level[frame * joints + j];
    const std::int32_t a = cracks_.elements[2 * j], b = cracks_.elements[2 * j + 1];
    const CrackLine* look = nullptr;
    for (const CrackLine& l : kCrackLines) {
      if (level >= l.level && level < kApart) look = &l;
    }
    for (std::size_t k = 0; k < cracks_.edges[j]; ++k, end += 2) {
      if (look == nullptr) continue;
      canvas.line(0.5 * (point(end, a) + point(end, b)), 0.5 * (point(end + 1, a) + point(end + 1, b)), look->pixels, kRed, look->strength,
                  lifted);
    }
  }
}

Image PlainScene::picture(const std::string& view, double time, int width, int height) const {
  const bool runs = frames_.frames() > 0;
  const std::uint64_t frame = runs ? nearest_frame(frames_.times(), time) : 0;
  const double now = runs ? frames_.times()[frame] : 0.0;
  const std::vector<Pose> poses = runs ? poses_of(frames_, frame) : first_poses(frames_);
  Canvas canvas(camera_for(view, in_view(poses), width, height));
  draw_ground(canvas, poses);
  for (const Face& face : faces_) {
    const Vec3 normal = nth(poses, face.element).rotation * face.normal;
    canvas.polygon(placed(face, poses), normal, light_on(normal) * (face.opened <= now ? kRed : nth(colour_, face.element)), 0.3);
  }
  if (runs) draw_cracks(canvas, poses, frame);
  return canvas.image();
}

}  // namespace voussoir::io
