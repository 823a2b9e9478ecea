// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/analysis/drive.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "cases/case.h"
#include "cases/model.h"
#include "geometry/nth.h"
#include "solver/analysis/modes.h"
#include "solver/analysis/push_shape.h"
#include "solver/equilibrium/masses.h"

namespace voussoir::solver {

namespace {

using cases::AnalysisKind;
using cases::LoadPattern;

constexpr int kModes = 12;
constexpr double kStill = 0.05;                     // Hz: what is slower is no vibration, but a body that is free to turn or to slide
constexpr double kNoModes = 10.0;                   // Hz, of a structure without a joint
constexpr double kDampingRatio = 0.1;               // of critical, at the first frequency
constexpr double kPeriods = 20.0;                   // first periods in a pace
constexpr double kShortestPace = 2.0;               // s
constexpr double kFirstFactor = 0.05;               // load factor that the first pace brings, times e − 1, while nothing has cracked
constexpr double kRestFactor = 0.02;                // load factor of the first state of rest (analysis.solver)
constexpr double kRestMovement = 2e-4;              // of the height: how far supports go to the first such point
constexpr double kShare = 0.5, kCyclicShare = 5.0;  // of the first stiffness: see Analysis::share
constexpr double kStepMargin = 2e-3;                // of the square of the highest frequency that the step bears: what the spring may add
constexpr double kRestLoad = 0.01;                  // of the loads of analysis.kind = "rest": up to the first such point
constexpr double kSupportShare = 0.0025;            // of the height, in a pace: how fast supports move
constexpr double kEndShare = 0.002;                 // of the height, in a pace: as fast as the moving end goes at most
constexpr double kDrag = 0.002;           // of the weight: what mass damping may bear of a structure that moves as fast as the moving end
constexpr double kSupportDrag = 0.00125;  // the same of one that moves as fast as its supports
constexpr double kQuiet = 3.0;            // times as fast as its supports a structure may move that stands on them
constexpr double kLeastMassShare = 1e-3;  // of a mode, in the direction of a push

struct Totals {
  double mass = 0.0, height = 0.0;  // kg, m
};
Totals totals(const World& w) {
  Totals t;
  double low = 1e300, high = -1e300;
  const Elements& e = w.elements;
  for (std::size_t i = 0; i < static_cast<std::size_t>(e.count); ++i) {
    if (e.fixed[i]) continue;
    t.mass += e.mass[i];
    low = std::min(low, e.body[i].ref.z - e.radius[i]), high = std::max(high, e.body[i].ref.z + e.radius[i]);
  }
  t.height = high - low;
  return t;
}

Vec3 push_of(const cases::Analysis& a) {
  const double length = std::hypot(a.direction[0], a.direction[1]);
  return {a.direction[0] / length, a.direction[1] / length, 0.0};
}

bool pushes_by_loads(const cases::Case& c) { return c.analysis.kind == AnalysisKind::cyclic || c.analysis.pattern == LoadPattern::given; }

/// About the centroid, N m.
Vec3 torque_of(const PointLoad& l) { return l.moment + cross(l.arm, l.force); }

/// Power of the forces at a load factor of 1 with the motion of a mode. \param shape  of the push; empty: the same everywhere
double power_on_mode(const cases::Case& c, const World& w, const Mode& m, Vec3 push, const std::vector<Vec3>& shape, double g) {
  double power = 0.0;
  if (pushes_by_loads(c)) {
    for (const PointLoad& l : w.loads) {
      const auto i = static_cast<std::size_t>(l.element);
      if (l.grows) power += dot(l.force, m.displacement[i]) + dot(torque_of(l), m.rotation[i]);
    }
    return power;
  }
  for (std::size_t i = 0; i < m.displacement.size(); ++i) {
    if (!w.elements.fixed[i]) power += g * w.elements.mass[i] * dot(shape.empty() ? push : shape[i], m.displacement[i]);
  }
  return power;
}

/// T·J⁻¹·T, N²/kg.
double turning_square(const Elements& e, std::size_t i, Vec3 t) {
  return dot(t, {e.ixx[i] * t.x + e.ixy[i] * t.y + e.ixz[i] * t.z, e.ixy[i] * t.x + e.iyy[i] * t.y + e.iyz[i] * t.z,
                 e.ixz[i] * t.x + e.iyz[i] * t.y + e.izz[i] * t.z});
}

/// The loads that grow by their elements: force, torque. Those on one element act together.
std::map<std::int32_t, std::pair<Vec3, Vec3>> growing_by_element(const World& w) {
  std::map<std::int32_t, std::pair<Vec3, Vec3>> on;
  for (const PointLoad& l : w.loads) {
    if (l.grows) on[l.element].first += l.force, on[l.element].second += torque_of(l);
  }
  return on;
}

/// Σ p²/m + T·J⁻¹·T of the loads that grow, N²/kg.
double square_of_loads(const World& w) {
  double sum = 0.0;
  for (const auto& [element, push] : growing_by_element(w)) {
    const auto i = static_cast<std::size_t>(element);
    sum += dot(push.first, push.first) * w.elements.inv_mass[i] + turning_square(w.elements, i, push.second);
  }
  return sum;
}

/// Of a push by mass. \param shape  by element, of a mode; empty: it is the same everywhere
double square_of_masses(const World& w, const std::vector<Vec3>& shape, double g) {
  double sum = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(w.elements.count); ++i) {
    if (!shape.empty()) sum += g * g * w.elements.mass[i] * dot(shape[i], shape[i]);
    if (shape.empty() && !w.elements.fixed[i]) sum += g * g * w.elements.mass[i];
  }
  return sum;
}

/// 2 × the kinetic energy of an element that turns at this rate; nothing of one that cannot turn.
double turning_mass(const Elements& e, std::size_t i, Vec3 rate) {
  if (e.ixx[i] <= 0.0) return 0.0;
  Eigen::Matrix3d inverse;
  inverse << e.ixx[i], e.ixy[i], e.ixz[i], e.ixy[i], e.iyy[i], e.iyz[i], e.ixz[i], e.iyz[i], e.izz[i];
  const Eigen::Vector3d r(rate.x, rate.y, rate.z);
  return r.dot(inverse.ldlt().solve(r));
}

/// Σ p²/m + T·J⁻¹·T of all forces at a load factor of 1 with the masses of a relaxation, N²/kg.
double relaxed_square(const cases::Case& c, const World& w, const std::vector<Vec3>& shape, double g) {
  const Inert& inert = w.elements.inert;
  double sum = 0.0;
  if (pushes_by_loads(c)) {
    for (const auto& [element, push] : growing_by_element(w))
      sum += dot(push.first, push.first) * nth(inert.inv_mass, element) + dot(push.second, push.second) * nth(inert.inv_inertia, element);
    return sum;
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(w.elements.count); ++i) {
    const double p = g * w.elements.mass[i] * (shape.empty() ? 1.0 : norm(shape[i]));
    sum += p * p * inert.inv_mass[i];
  }
  return sum;
}

double modal_mass(const World& w, const Mode& m) {
  double sum = 0.0;
  for (std::size_t i = 0; i < m.displacement.size(); ++i) {
    if (w.elements.fixed[i]) continue;
    sum += w.elements.mass[i] * dot(m.displacement[i], m.displacement[i]) + turning_mass(w.elements, i, m.rotation[i]);
  }
  return sum;
}

double square_of(double frequency) { return std::pow(2.0 * std::numbers::pi * frequency, 2); }

/// Modes that vibrate.
std::vector<Mode> modes_of(const World& w) {
  std::vector<Mode> all = natural_modes(w, kModes, DryJoints::closed);
  std::erase_if(all, [](const Mode& m) { return m.frequency < kStill; });
  return all;
}

struct Shape {
  std::vector<Vec3> displacement;  // by element
  double frequency = 0.0;          // Hz
};
/// The mode with most mass along the push, so scaled that its mean by mass along it is 1: then λ is still a share of the weight.
Shape shape_of(const std::vector<Mode>& modes, const World& w, Vec3 push, double mass) {
  const Mode* best = nullptr;
  double most = kLeastMassShare, mean = 0.0;
  for (const Mode& m : modes) {
    double along = 0.0;
    for (std::size_t i = 0; i < m.displacement.size(); ++i) along += w.elements.mass[i] * dot(push, m.displacement[i]);
    const double share = along * along / (modal_mass(w, m) * mass);
    if (share > most) best = &m, most = share, mean = along / mass;
  }
  if (best == nullptr) throw cases::InputError("analysis.direction", "no mode of the structure has mass in this direction");
  Shape shape{best->displacement, best->frequency};
  for (Vec3& v : shape.displacement) v *= 1.0 / mean;
  return shape;
}

/// The distribution of a pushover's forces over the elements; empty: the same acceleration everywhere, or given loads.
std::vector<Vec3> push_shape(const cases::Analysis& a, const World& w, const Shape& mode, Vec3 push) {
  if (!cases::has_push_shape(a)) return {};
  std::vector<Vec3> shape = a.pattern == LoadPattern::mode         ? mode.displacement
                            : a.pattern == LoadPattern::triangular ? triangular_shape(w, push)
                                                                   : mass_shape(w, push);
  if (a.eccentricity != 0.0) shift_shape(shape, w, push, a.eccentricity);
  return shape;
}

/// m, of the elements that are not fixed, from the lowest corner to the highest.
double height_that_moves(const World& w) {
  double low = 1e300, high = -1e300;
  for (const cases::Block& b : w.model.blocks) {
    if (b.fixed) continue;
    const auto [from, to] = geometry::bounds(b.shape);
    low = std::min(low, from.z), high = std::max(high, to.z);
  }
  return high - low;
}

/// N, of all forces at a load factor of 1. A moment without a force counts as a force at the top with this moment about the foot, so that
/// the displacement that it works on is that of the top.
double weight_of(const cases::Case& c, const World& w, double gravity, double mass) {
  if (!pushes_by_loads(c)) return gravity * mass;
  double sum = 0.0;
  for (const PointLoad& l : w.loads) {
    if (!l.grows) continue;
    sum += l.force == Vec3{} ? norm(l.moment) / height_that_moves(w) : norm(l.force);
  }
  return sum;
}

/// So that supports go kSupportShare of the height in a pace.
double support_speed(const World& w, double wanted) {
  double fastest = 0.0;
  for (const Support& s : w.supports) {
    const cases::SupportHistory& h = *s.history;
    const Vec3 centroid = nth(w.elements.body, s.element).ref;
    const double reach = nth(w.elements.radius, s.element) + norm(centroid - h.about.value_or(centroid));
    for (std::size_t i = 1; i < h.time.size(); ++i) {
      double way = norm(h.displacement[i] - h.displacement[i - 1]);
      if (!h.rotation.empty()) way += reach * norm(h.rotation[i] - h.rotation[i - 1]);
      fastest = std::max(fastest, way / (h.time[i] - h.time[i - 1]));
    }
  }
  return fastest > 0.0 ? wanted / fastest : 1.0;
}

/// Way of the supports' clock to the first state of rest [s]; finite, since it is state, also where nothing moves or grows.
double first_on_clock(const Simulation& sim, const Totals& all) {
  const World& w = sim.world();
  double first = 1.0;
  if (std::ranges::any_of(w.loads, &PointLoad::grows)) first = kRestLoad * sim.program().last_support();
  return w.supports.empty() ? first : std::min(first, kRestMovement * all.height * support_speed(w, 1.0));
}

/// Load factor that the fictitious masses add while the clock speeds up, see Path::set. Loads set no mass in motion by themselves.
double inertia_on_clock(const World& w, const Totals& all, double gravity) {
  if (w.supports.empty() || !(gravity > 0.0)) return 0.0;
  const double masses = std::accumulate(w.elements.inert.mass.begin(), w.elements.inert.mass.end(), 0.0);
  return masses / (all.mass * gravity * w.dt * w.dt * support_speed(w, 1.0));
}

}  // namespace

void choose_drive(Simulation& sim, const cases::Case& c) {
  if (!sim.program().active()) return;
  const World& w = sim.world();
  const cases::Analysis& a = c.analysis;
  const double g = norm(c.gravity.acceleration);
  const Totals all = totals(w);
  const Vec3 push = push_of(a);
  const std::vector<Mode> modes = modes_of(w);
  Drive d;
  d.frequency = modes.empty() ? kNoModes : modes.front().frequency;
  // By the pace that the program would choose, so that a slower one makes less drag, not more damping.
  const double own_pace = std::max(kShortestPace, kPeriods / d.frequency), tall = g > 0.0 ? all.height / g : 0.0;
  const bool settles = follows_supports(a);
  const double drag = settles ? kSupportDrag / kSupportShare : kDrag / kEndShare;
  d.pace = a.pace.value_or(own_pace);
  d.damping = 2.0 * kDampingRatio * std::sqrt(square_of(d.frequency));
  if (tall > 0.0) d.damping = std::min(d.damping, drag * own_pace / tall);
  d.damping = a.damping.value_or(d.damping);
  d.fastest = kEndShare * all.height / d.pace;
  d.weight = weight_of(c, w, g, all.mass);
  if (settles) {
    const double speed = kSupportShare * all.height / d.pace;
    d.speed = support_speed(w, speed);
    if (cases::finds_rest(a)) sim.path().set(d.first = first_on_clock(sim, all), inertia_on_clock(w, all, g));
    d.quiet = 0.5 * all.mass * std::pow(kQuiet * speed, 2);
    sim.program().set(d, {});
    return;
  }
  Shape mode;
  double inertia = 0.0;  // of the path from one state of rest to the next
  double square = 0.0;   // of the stiffness of the spring: THEORY.md, section 11
  const bool by_mode = a.kind == AnalysisKind::pushover && a.pattern == LoadPattern::mode;
  if (by_mode) mode = shape_of(modes, w, push, all.mass);
  const std::vector<Vec3> shape = push_shape(a, w, mode, push);
  if (by_mode && a.eccentricity == 0.0) {
    square = square_of_masses(w, shape, g);
    d.compliance = square / (square_of(mode.frequency) * d.weight);
  } else {
    square = pushes_by_loads(c) ? square_of_loads(w) : square_of_masses(w, shape, g);
    for (const Mode& m : modes) {
      const double power = power_on_mode(c, w, m, push, shape, g);
      d.compliance += power * power / (square_of(m.frequency) * modal_mass(w, m) * d.weight);
    }
  }
  if (!(d.compliance > 0.0)) d.compliance = g / square_of(d.frequency);
  const bool at_rest = cases::finds_rest(a);
  d.stiffness = a.share.value_or(at_rest || a.kind == AnalysisKind::cyclic ? kCyclicShare : kShare) / d.compliance;
  const double margin = at_rest ? kSpringShare : kStepMargin;
  if (at_rest) square = relaxed_square(c, w, shape, g);
  if (at_rest && square > 0.0) inertia = d.weight / (square * w.dt * w.dt);
  if (square > 0.0) d.stiffness = std::min(d.stiffness, margin * 4.0 / (w.dt * w.dt) * d.weight / square);
  d.first = (at_rest ? kRestFactor : kFirstFactor) * (d.compliance + 1.0 / d.stiffness);
  if (at_rest) sim.path().set(d.first, inertia);
  sim.program().set(d, shape);
}

}  // namespace voussoir::solver
