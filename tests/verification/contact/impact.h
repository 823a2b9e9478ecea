// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "geometry/separation.h"
#include "tests/verification/fixture.h"

/// Bodies that are thrown at each other, under the eyes of geometry's exact test.
namespace voussoir::testing {

inline constexpr double kSegment = 0.025;  // m, of all bodies here
inline constexpr double kHalfSegment = 0.5 * kSegment;

inline constexpr double kFree = 0.45 * kSegment;  // m, that elements may overlap by without a force (THEORY.md (21a))

/// Shapes that are thrown; along x, y, z about the origin.
enum class Shape { brick, wedge, voussoir };
inline constexpr std::array kShapes{Shape::brick, Shape::wedge, Shape::voussoir};
inline const char* name_of(Shape s) { return s == Shape::brick ? "brick" : s == Shape::wedge ? "wedge" : "voussoir"; }

/// In y and z, to be drawn out along x by 0.1 m to both sides.
inline std::vector<std::array<double, 2>> profile_of(Shape s) {
  if (s == Shape::brick) return {{-0.1, -0.05}, {0.1, -0.05}, {0.1, 0.05}, {-0.1, 0.05}};
  if (s == Shape::wedge) return {{-0.1, -0.05}, {0.1, -0.05}, {-0.1, 0.05}};
  return {{-0.07, -0.05}, {0.07, -0.05}, {0.1, 0.05}, {-0.1, 0.05}};
}

/// A block of the shape, turned about the origin, then moved.
inline cases::BlockSpec block_of(Shape s, const std::string& name, cases::Rotation turn, Vec3 by, Vec3 velocity) {
  cases::BlockSpec b;
  b.name = name, b.material = "adobe";
  b.polygon = profile_of(s);
  for (auto& corner : b.polygon) corner[0] += by.y, corner[1] += by.z;
  b.extrude = {by.x - 0.1, by.x + 0.1};
  turn.about = by;
  b.rotate = turn;
  b.free = true;
  b.velocity = velocity;
  return b;
}

inline cases::Case empty_case(const std::string& name) {
  cases::Case c = load(name).value;
  c.blocks.clear();
  c.output.history.clear();
  c.segment_size = kSegment;
  return c;
}

/// A run with either kernel set, and its bodies as geometry sees them.
class ExactRun {
 public:
  ExactRun(cases::Case c, bool reference) : case_(std::move(c)), model_(cases::build_model(case_)) {
    solver::Options options;
    options.threads = 1;
    options.reference_kernels = reference;
    sim_ = std::make_unique<solver::Simulation>(case_, model_, motion_, options);
    if (sim_->phase() == solver::Phase::shaking) sim_->start_shaking();
    for (std::size_t i = 0; i < model_.blocks.size(); ++i) {
      bodies_.push_back(geometry::convex_body(geometry::moved(model_.blocks[i].shape, -model_.assembly.elements[i].mass.centroid)));
    }
  }

  [[nodiscard]] solver::Simulation& sim() { return *sim_; }
  [[nodiscard]] const solver::Elements& elements() const { return sim_->world().elements; }
  [[nodiscard]] std::size_t count() const { return bodies_.size(); }
  [[nodiscard]] Vec3 position(std::size_t i) const {
    return elements().body[i].ref + Vec3{elements().ux[i], elements().uy[i], elements().uz[i]};
  }
  [[nodiscard]] geometry::ConvexBody body(std::size_t i) const {
    const solver::Elements& e = elements();
    return geometry::placed(bodies_[i], rotation({e.qw[i], e.qx[i], e.qy[i], e.qz[i]}), position(i));
  }
  /// Of any two bodies, m; what is not deeper than `enough` need not be exact.
  [[nodiscard]] double deepest(double enough) const {
    std::vector<geometry::ConvexBody> placed;
    for (std::size_t i = 0; i < count(); ++i) placed.push_back(body(i));
    double most = enough;
    for (std::size_t i = 0; i < count(); ++i) {
      if (case_.base) most = std::max(most, geometry::depth_under(placed[i], case_.base->z));
      for (std::size_t k = i + 1; k < count(); ++k) most = std::max(most, geometry::penetration_of(placed[i], placed[k], most).depth);
    }
    return most;
  }

 private:
  cases::Case case_;
  cases::Model model_;
  cases::GroundMotion motion_;
  std::unique_ptr<solver::Simulation> sim_;
  std::vector<geometry::ConvexBody> bodies_;
};

/// N/m: the spring between two whole bodies of adobe (THEORY.md (21a)); the base is rigid (volume 0).
inline double overlap_stiffness(double volume, double other) {
  const auto of = [](double v) { return 2.0 * Adobe::plane * std::cbrt(v); };
  return other > 0.0 ? of(volume) * of(other) / (of(volume) + of(other)) : of(volume);
}

}  // namespace voussoir::testing
