// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>

#include "cases/case.h"
#include "cases/model.h"
#include "cases/motion.h"

/// A small running-bond wall of adobe bricks on a base that shakes: everything the step has, in a second of computing.
namespace voussoir::testing {

inline cases::BlockSpec brick(int course, int k, double x0, double x1) {
  cases::BlockSpec b;
  b.name = "c" + std::to_string(course) + "_" + std::to_string(k);
  b.material = "adobe";
  b.box = {{Vec3{x0, 0.0, 0.1 * course}, Vec3{x1, 0.1, 0.1 * (course + 1)}}};
  return b;
}

/// `length` whole bricks of 0.2 × 0.1 × 0.1 m a course; odd courses begin and end with halves.
inline cases::Case small_wall(int length, int courses, double strength = 1.0) {
  cases::Case c;
  c.title = "small wall";
  c.materials["adobe"] = {1800.0, 9.8e7, 0.25};
  cases::JointLaw law;
  law.tension = strength * 4.6e3, law.cohesion = strength * 2.9e3, law.friction = 32.0, law.compression = 4.9e5;
  c.joint_laws["mortar"] = law;
  c.joints.default_law = "mortar";
  c.gravity.settle = false;
  c.damping.alpha = 1.5;
  c.base = cases::Base{};
  c.segment_size = 0.025;
  for (int i = 0; i < courses; ++i) {
    double x = 0.0;
    for (int k = 0; x < 0.2 * length - 1e-9; ++k) {
      const double end = std::min(0.2 * length, x + (i % 2 == 1 && k == 0 ? 0.1 : 0.2));
      c.blocks.push_back(brick(i, k, x, end));
      x = end;
    }
  }
  return c;
}

/// The same with its odd courses a hair off, so that grids do not coincide and bed joints have two sides; with a course of timber, whose
/// nails yield, and a plank as long as the wall on top.
inline cases::Case mixed_wall(int length, int courses) {
  cases::Case c = small_wall(length, courses);
  c.materials["timber"] = {600.0, 9.8e8, 0.3};
  cases::JointLaw nails = c.joint_laws["mortar"];
  nails.tension = 5e4, nails.cohesion = 1e4;
  c.joint_laws["nails"] = nails;
  c.joints.between.push_back({{"adobe", "timber"}, "nails"});
  for (cases::BlockSpec& b : c.blocks) {
    auto& [low, high] = *b.box;
    const bool odd = std::lround(low.z / 0.1) % 2 == 1;
    for (double* x : {&low.x, &high.x}) {
      if (odd && *x > 0.05 && *x < 0.2 * length - 0.05) *x -= 0.01;
    }
    if (b.name.starts_with("c3_")) b.material = "timber";
  }
  cases::BlockSpec plank = brick(courses, 0, 0.0, 0.2 * length);
  plank.material = "timber";
  c.blocks.push_back(plank);
  return c;
}

/// Shaking across the wall that brings it down.
inline cases::GroundMotion strong_shaking() {
  cases::GroundMotion m;
  for (int axis = 0; axis < 3; ++axis) {
    auto& a = m.axis[static_cast<std::size_t>(axis)];
    a.dt = 0.01;
    for (int i = 0; i < 200; ++i) {
      const double saw = ((i * (7 + axis)) % 40) / 20.0 - 1.0;
      a.acceleration.push_back((axis == 1 ? 15.0 : 5.0) * saw);
    }
  }
  return m;
}

}  // namespace voussoir::testing
