// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/debris/bodies.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "geometry/disjoint_sets.h"
#include "geometry/nth.h"
#include "io/input/files/errors.h"
#include "io/output/replay/joint_openings.h"

namespace voussoir::io {
namespace {

constexpr std::size_t kMostBodies = 99;       // in a frame; each has at least a hundredth of the mass
constexpr double kTurns = 2e-3;               // rad: bodies with less relative rotation have no hinge
constexpr double kSlides = 2e-3;              // m: bodies with less relative motion along their joints do not slide
constexpr double kShort = 0.3;                // m
constexpr double kNear = 0.5, kBeside = 0.1;  // m: a hinge lies among the joints of its bodies, or at most half a brick beside

/// Axis times sine of the angle: approximates the rotation vector for small angles.
Vec3 turn_of(const Mat3& r) { return 0.5 * Vec3{r.r2.y - r.r1.z, r.r0.z - r.r2.x, r.r1.x - r.r0.y}; }

}  // namespace

BodyFinder::BodyFinder(const Hdf5File& run, const Building& building, std::vector<Pose> start)
    : building_(building), start_(std::move(start)), last_id_(start_.size()) {
  const std::vector<double> since = joint_opening_times(run);
  const auto a = run.read<std::int32_t>("/model/joint/element_a"), b = run.read<std::int32_t>("/model/joint/element_b");
  const auto centre = run.read<double>("/model/joint/centre"), normal = run.read<double>("/model/joint/normal");
  if (a.size() != since.size() || b.size() != since.size() || centre.size() != 3 * since.size() || normal.size() != centre.size())
    throw FileError(run.path(), "/model/joint does not fit together");
  const auto elements = static_cast<std::int64_t>(start_.size());
  for (std::size_t j = 0; j < since.size(); ++j) {
    if (a[j] < 0 || a[j] >= elements || b[j] >= elements)
      throw FileError(run.path(), "/model/joint: row " + std::to_string(j) + " refers to no element");
    const Vec3 c{centre[3 * j], centre[3 * j + 1], centre[3 * j + 2]};
    joints_.push_back({since[j],
                       a[j],
                       b[j],
                       c,
                       c - nth(start_, a[j]).centre,
                       b[j] < 0 ? c : c - nth(start_, b[j]).centre,
                       {normal[3 * j], normal[3 * j + 1], normal[3 * j + 2]}});
  }
  all_mass_ = std::accumulate(building.mass.begin(), building.mass.end(), 0.0);
}

std::vector<std::int32_t> BodyFinder::components(double time, const std::vector<Pose>& poses) const {
  geometry::DisjointSets sets(start_.size() + 1);  // the last element is the base
  const auto base = static_cast<std::int32_t>(start_.size());
  if (!part_.empty() && time >= part_from_) {
    std::vector<std::int32_t> given = part_;
    for (std::int32_t& p : given) p = p < 0 ? base : p;
    given.push_back(base);
    return given;
  }
  for (const Joint& j : joints_) {
    const Vec3 at_b = j.b < 0 ? j.from_b : nth(poses, j.b).point(j.from_b);
    const bool apart = j.time <= time && norm(at_b - nth(poses, j.a).point(j.from_a)) >= kMovesAsOne;
    if (!apart) sets.join(static_cast<std::size_t>(j.a), static_cast<std::size_t>(j.b < 0 ? base : j.b));
  }
  std::vector<std::int32_t> component(start_.size() + 1);
  for (std::size_t i = 0; i < component.size(); ++i) component[i] = static_cast<std::int32_t>(sets.of(i));
  return component;
}

void BodyFinder::number(std::vector<Body>& bodies, const std::vector<std::int32_t>& component, BodiesInFrame& out) {
  // The body with most of the mass of an earlier body keeps its number; the heaviest body chooses first.
  std::map<std::int32_t, std::size_t> of_root;
  std::ranges::stable_sort(bodies, std::greater(), &Body::mass);
  if (bodies.size() > kMostBodies) bodies.resize(kMostBodies);
  for (std::size_t i = 0; i < bodies.size(); ++i) of_root[bodies[i].wall] = i;  // `wall` holds the root until it is set below
  std::vector<std::map<std::uint8_t, double>> shared(bodies.size());
  std::vector<std::int32_t> body(start_.size(), -1);
  for (std::size_t e = 0; e < start_.size(); ++e) {
    const auto at = of_root.find(component[e]);
    if (at == of_root.end() || building_.mass[e] <= 0) continue;
    body[e] = static_cast<std::int32_t>(at->second);
    if (last_id_[e] != 0) shared[at->second][last_id_[e]] += building_.mass[e];
  }
  std::array<bool, 256> taken{};
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    double most = 0;
    for (const auto& [id, mass] : shared[i])
      if (!taken[id] && mass > most) most = mass, bodies[i].id = id;
    if (bodies[i].id != 0) taken[bodies[i].id] = true;
  }
  for (Body& b : bodies) {
    if (b.id != 0) continue;
    b.id = static_cast<std::uint8_t>(std::find(taken.begin() + 1, taken.end(), false) - taken.begin());
    taken[b.id] = true;
  }
  out.id.assign(start_.size(), 0);
  for (std::size_t e = 0; e < start_.size(); ++e)
    if (body[e] >= 0) out.id[e] = nth(bodies, body[e]).id;
  last_id_ = out.id;
}

BodiesInFrame BodyFinder::find(double time, const std::vector<Pose>& poses) {
  const std::vector<std::int32_t> component = components(time, poses);
  std::vector<double> mass(start_.size() + 1);
  for (std::size_t e = 0; e < start_.size(); ++e) nth(mass, component[e]) += building_.mass[e];
  std::map<std::int32_t, Body> by_root;
  std::map<std::int32_t, std::map<std::int32_t, double>> of_wall;
  std::map<std::int32_t, double> of_gables;  // kg
  for (std::size_t e = 0; e < start_.size(); ++e) {
    const std::int32_t root = component[e];
    if (building_.mass[e] <= 0 || nth(mass, root) < kLeastBody * all_mass_) continue;
    Body& b = by_root[root];
    const double m = building_.mass[e];
    b.mass += m;
    b.centre = b.centre + m * start_[e].centre;
    b.displacement = b.displacement + m * (poses[e].centre - start_[e].centre);
    b.rotation = b.rotation + m * turn_of(poses[e].rotation);
    b.box.include(building_.box[e]);
    of_wall[root][building_.wall[e]] += m;
    of_gables[root] += building_.gable[e] != 0 ? m : 0.0;
  }
  std::vector<Body> bodies;
  for (auto& [root, b] : by_root) {
    b.centre = (1 / b.mass) * b.centre, b.displacement = (1 / b.mass) * b.displacement, b.rotation = (1 / b.mass) * b.rotation;
    b.on_ground = root == component.back();
    b.wall = root;
    bodies.push_back(b);
  }
  BodiesInFrame out;
  number(bodies, component, out);
  for (Body& b : bodies) {
    const auto& walls = of_wall[b.wall];
    b.gable = of_gables[b.wall] > 0.5 * b.mass;
    b.wall = std::ranges::max_element(walls, {}, [](const auto& w) { return w.second; })->first;
    if (b.wall < 0 || !nth(building_.walls, b.wall).axes.turned()) continue;
    b.box = Box::empty();
    for (std::size_t e = 0; e < start_.size(); ++e)
      if (out.id[e] == b.id) b.box.include(building_.box_in(nth(building_.walls, b.wall), e));
  }
  std::ranges::sort(bodies, {}, &Body::id);
  out.bodies = std::move(bodies);
  out.hinges = hinges(time, poses, out);
  return out;
}

std::array<std::int32_t, 2> BodyFinder::carriers(const Vec3& end, const std::vector<const Joint*>& joints, const BodiesInFrame& found,
                                                 std::uint8_t first) const {
  std::array<std::int32_t, 2> nearest{-1, -1};
  std::array<double, 2> distance{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (const Joint* j : joints)
    for (const std::int32_t e : {j->a, j->b}) {
      const std::size_t side = nth(found.id, e) == first ? 0 : 1;
      const double d = norm(nth(start_, e).centre - end);
      if (d < distance[side]) distance[side] = d, nearest[side] = e;
    }
  return nearest;
}

/// The line between two distant joints, if the bodies have moved along their joints more than away from each other.
std::optional<Hinge> BodyFinder::slide(const std::vector<const Joint*>& joints, const std::vector<Pose>& poses, const BodiesInFrame& found,
                                       std::uint8_t first) const {
  double along = 0.0, apart = 0.0;
  Vec3 middle;
  for (const Joint* j : joints) {
    const Vec3 moved = nth(poses, j->b).point(j->from_b) - nth(poses, j->a).point(j->from_a);
    const double away = dot(moved, j->normal);
    apart += std::abs(away), along += norm(moved - away * j->normal);
    middle = middle + j->centre;
  }
  const auto count = static_cast<double>(joints.size());
  middle = (1.0 / count) * middle;
  if (along < kSlides * count || along < apart) return {};
  const auto farthest = [&](const Vec3& p) {
    return (*std::ranges::max_element(joints, {}, [&](const Joint* j) { return norm(j->centre - p); }))->centre;
  };
  const Vec3 from = farthest(middle), to = farthest(from);
  if (norm(to - from) < kShort) return {};
  return Hinge{from, to, carriers(from, joints, found, first), carriers(to, joints, found, first), true};
}

std::vector<Hinge> BodyFinder::hinges(double time, const std::vector<Pose>& poses, const BodiesInFrame& found) const {
  const auto body = [&](std::uint8_t id) -> const Body* {
    const auto at = std::ranges::find(found.bodies, id, &Body::id);
    return at == found.bodies.end() ? nullptr : &*at;
  };
  std::map<std::pair<std::uint8_t, std::uint8_t>, std::vector<const Joint*>> between;
  for (const Joint& j : joints_) {
    if (j.b < 0 || j.time > time) continue;
    const std::uint8_t a = nth(found.id, j.a), b = nth(found.id, j.b);
    if (a != 0 && b != 0 && a != b) between[std::minmax(a, b)].push_back(&j);
  }
  std::vector<Hinge> all;
  for (const auto& [ids, joints] : between) {
    const Vec3 turn = body(ids.second)->rotation - body(ids.first)->rotation;
    const double angle = norm(turn);
    if (joints.size() < 3) continue;
    if (angle < kTurns) {
      if (const std::optional<Hinge> line = slide(joints, poses, found, ids.first)) all.push_back(*line);
      continue;
    }
    // Motion of the second body relative to the first, at the middle of the joints between the two.
    Vec3 middle, moved;
    for (const Joint* j : joints) {
      const Vec3 at_a = nth(poses, j->a).point(j->from_a), at_b = nth(poses, j->b).point(j->from_b);
      const bool in_order = nth(found.id, j->a) == ids.first;
      middle = middle + j->centre, moved = moved + (in_order ? at_b - at_a : at_a - at_b);
    }
    const double share = 1.0 / static_cast<double>(joints.size());
    middle = share * middle, moved = share * moved;
    const Vec3 axis = (1 / angle) * turn, aside = (1 / (angle * angle)) * cross(turn, moved);  // moved = turn × (middle − hinge)
    double reach = 0;
    for (const Joint* j : joints) reach = std::max(reach, dot(j->centre - middle, aside) / std::max(norm(aside), 1e-12));
    if (norm(aside) > std::min(kNear, kBeside + reach)) continue;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Joint* j : joints) {
      const double s = dot(axis, j->centre - middle);
      low = std::min(low, s), high = std::max(high, s);
    }
    if (high - low < kShort) continue;
    const Vec3 from = middle + aside + low * axis, to = middle + aside + high * axis;
    all.push_back({from, to, carriers(from, joints, found, ids.first), carriers(to, joints, found, ids.first)});
  }
  return all;
}

}  // namespace voussoir::io
