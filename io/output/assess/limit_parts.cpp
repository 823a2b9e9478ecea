// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/assess/limit_parts.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "cases/model.h"
#include "geometry/message.h"
#include "geometry/nth.h"
#include "io/output/measures/building/building.h"

namespace voussoir::io {
namespace {

constexpr double kMoves = 0.05;     // of the fastest speed, which is 1
constexpr std::size_t kBricks = 4;  // elements of a part in the mean, from which on parts say more than elements
constexpr std::size_t kMostParts = 12;

struct Part {
  std::string name;
  double mass = 0.0, moving = 0.0;  // kg
  Vec3 momentum;                    // of what moves
};

std::vector<Part> parts_of(const solver::LimitState& s, const cases::Model& model, const solver::LimitContacts& c) {
  std::map<std::string, Part> of_name;
  for (std::size_t e = 0; e < model.blocks.size(); ++e) {
    const std::int32_t body = c.body_of[e];
    if (body < 0) continue;
    const auto& mass = model.assembly.elements[e].mass;
    const double m = mass.volume * nth(model.materials, model.blocks[e].material).value.density;
    Part& part = of_name[part_of(model.blocks[e].tag)];
    part.mass += m;
    const kernels::Twist& t = nth(s.motion, body);
    const Vec3 v = t.v + cross(t.w, mass.centroid - nth(c.bodies, body).centre);
    if (norm(v) < kMoves) continue;
    part.moving += m, part.momentum = part.momentum + m * v;
  }
  std::vector<Part> parts;
  for (auto& [name, part] : of_name) part.name = name, parts.push_back(std::move(part));
  return parts;
}

}  // namespace

std::string moving_parts(const solver::LimitState& s, const cases::Model& model, const solver::LimitContacts& c) {
  std::vector<Part> parts = parts_of(s, model, c);
  if (parts.size() * kBricks > c.bodies.size()) return "";
  std::erase_if(parts, [](const Part& p) { return p.moving == 0.0; });
  std::ranges::stable_sort(parts, std::greater<>(), [](const Part& p) { return norm(p.momentum); });
  std::size_t wide = 24;
  for (const Part& p : parts) wide = std::max(wide, p.name.size());
  const int indent = static_cast<int>(wide);
  std::string out = geometry::printed("%-*s   share of its mass   mean velocity (x, y, z) of that share; the fastest point has speed 1\n",
                                      indent, "moving part");
  for (std::size_t k = 0; k < std::min(kMostParts, parts.size()); ++k) {
    const Part& p = parts[k];
    const Vec3 v = p.momentum / p.moving;
    const auto flat = [](double x) { return std::abs(x) < 5e-3 ? 0.0 : x; };
    out += geometry::printed("%-*s   %15.0f %%   (%5.2f, %5.2f, %5.2f)\n", indent, p.name.c_str(), 100.0 * p.moving / p.mass, flat(v.x),
                             flat(v.y), flat(v.z));
  }
  if (parts.size() > kMostParts) out += geometry::printed("%-*s   and %zu more\n", indent, "", parts.size() - kMostParts);
  return out;
}

}  // namespace voussoir::io
