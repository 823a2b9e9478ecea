// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/analysis/push_shape.h"

#include <algorithm>
#include <cmath>

#include "cases/input_error.h"
#include "cases/model.h"
#include "cases/names.h"
#include "geometry/nth.h"

namespace voussoir::solver {
namespace {

constexpr double kNarrow = 1e-9;  // of the width: a spread of the elements that is round-off

/// Distances of a body's corners along an axis [m].
void extend(const cases::Block& b, Vec3 axis, double& low, double& high) {
  for (const Vec3 v : b.shape.vertices) {
    low = std::min(low, dot(v, axis));
    high = std::max(high, dot(v, axis));
  }
}

}  // namespace

std::vector<Vec3> mass_shape(const World& w, Vec3 push) {
  const auto count = static_cast<std::size_t>(w.elements.count);
  std::vector<Vec3> shape(count);
  for (std::size_t i = 0; i < count; ++i)
    if (!w.elements.fixed[i]) shape[i] = push;
  return shape;
}

std::vector<Vec3> triangular_shape(const World& w, Vec3 push) {
  const Elements& e = w.elements;
  const double foot = nth(e.body, e.base).ref.z;
  std::vector<Vec3> shape = mass_shape(w, push);
  double sum = 0.0, mass = 0.0;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    if (e.fixed[i]) continue;
    const double height = std::max(0.0, e.body[i].ref.z - foot);
    shape[i] = height * push;
    sum += e.mass[i] * height, mass += e.mass[i];
  }
  if (!(sum > 0.0)) throw cases::InputError("analysis.pattern", "\"triangular\" is by height above the base, above which nothing lies");
  for (Vec3& v : shape) v *= mass / sum;
  return shape;
}

void shift_shape(std::vector<Vec3>& shape, const World& w, Vec3 push, double share) {
  const Elements& e = w.elements;
  const Vec3 left{-push.y, push.x, 0.0};
  double sum = 0.0, first = 0.0, low = 1e300, high = -1e300;
  const auto force = [&](std::size_t i) { return e.mass[i] * dot(shape[i], push); };
  for (std::size_t i = 0; i < shape.size(); ++i) {
    if (e.fixed[i]) continue;
    sum += force(i), first += force(i) * dot(e.body[i].ref, left);
    extend(w.model.blocks[i], left, low, high);
  }
  const double middle = first / sum, width = high - low;
  double second = 0.0, farthest = 0.0;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    if (e.fixed[i]) continue;
    const double off = dot(e.body[i].ref, left) - middle;
    second += force(i) * off * off;
    farthest = std::max(farthest, share > 0.0 ? -off : off);
  }
  const double spread = second / sum;
  if (!(spread > kNarrow * width * width))
    throw cases::InputError("analysis.eccentricity", "all elements lie in one line along the push: nothing can be pushed beside it");
  const double slope = share * width / spread;
  if (std::abs(slope) * farthest > 1.0) {
    throw cases::InputError("analysis.eccentricity", cases::text(share) + " would push back what lies farthest out; allowed: up to " +
                                                         cases::text(spread / (width * farthest)) + " in magnitude");
  }
  for (std::size_t i = 0; i < shape.size(); ++i)
    if (!e.fixed[i]) shape[i] *= 1.0 + slope * (dot(e.body[i].ref, left) - middle);
}

}  // namespace voussoir::solver
