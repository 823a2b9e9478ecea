// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/run/load_program.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "cases/case.h"
#include "cases/loads/control_point.h"
#include "cases/loads/loads.h"
#include "cases/model.h"
#include "geometry/nth.h"
#include "solver/run/loads.h"
#include "solver/supports/supports.h"

namespace voussoir::solver {

namespace {

using cases::AnalysisKind;
using cases::LoadPattern;

constexpr std::int64_t kLook = 4;      // steps between two looks at the base shear
constexpr double kTop = 0.1;           // of the height: what lies higher is the top
constexpr double kLeastHeight = 1e-3;  // m, for the drift of a point on the ground
constexpr double kNoise = 5.0;         // times the tolerance, of the weight: what a load factor at rest may be off by, and more
constexpr double kCyclePace = 0.5;     // of the pace: in which the moving end goes on by an amplitude

/// Of some elements, the one in the uppermost tenth that is nearest to the vertical axis through their centre of mass.
std::int32_t top_element(const World& w, const std::vector<std::int32_t>& among) {
  const Elements& e = w.elements;
  double low = 1e300, high = -1e300, mass = 0.0, x = 0.0, y = 0.0;
  for (const std::int32_t of : among) {
    const auto i = static_cast<std::size_t>(of);
    if (e.fixed[i]) continue;
    const Vec3 c = e.body[i].ref;
    low = std::min(low, c.z), high = std::max(high, c.z);
    mass += e.mass[i], x += e.mass[i] * c.x, y += e.mass[i] * c.y;
  }
  std::int32_t best = 0;
  double least = 1e300;
  for (const std::int32_t i : among) {
    const auto k = static_cast<std::size_t>(i);
    if (e.fixed[k] || e.body[k].ref.z < high - kTop * (high - low)) continue;
    const double far = std::hypot(e.body[k].ref.x - x / mass, e.body[k].ref.y - y / mass);
    if (far < least - 1e-9) least = far, best = i;
  }
  return best;
}

std::vector<std::int32_t> all_elements(const World& w) {
  std::vector<std::int32_t> all(static_cast<std::size_t>(w.elements.count));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

Vec3 displacement(const Elements& e, std::int32_t i) {
  const auto k = static_cast<std::size_t>(i);
  return {e.ux[k], e.uy[k], e.uz[k]};
}

}  // namespace

LoadProgram::LoadProgram(const cases::Case& c, World& w) : analysis_(c.analysis) {
  if (!active()) return;
  Elements& e = w.elements;
  gravity_ = norm(c.gravity.acceleration);
  down_ = gravity_ > 0.0 ? (1.0 / gravity_) * c.gravity.acceleration : Vec3{0.0, 0.0, -1.0};
  across_ = cases::push_direction(c);
  const bool vertical = across_.z != 0.0;
  if (analysis_.kind == AnalysisKind::tilt) across_ = across_ - dot(across_, down_) * down_;
  across_ = (1.0 / norm(across_)) * across_;
  for (std::size_t i = 0; i < static_cast<std::size_t>(e.count); ++i) mass_ += e.fixed[i] ? 0.0 : e.mass[i];
  const auto pushed = std::ranges::find_if(w.loads, &PointLoad::grows);
  control_ = analysis_.control                     ? cases::nearest_element(w.model, *analysis_.control)
             : !analysis_.control_name.empty()     ? top_element(w, cases::elements_called(w.model, analysis_.control_name))
             : vertical && pushed != w.loads.end() ? pushed->element
                                                   : top_element(w, all_elements(w));
  height_ = std::max(kLeastHeight, nth(e.body, control_).ref.z - nth(e.body, e.base).ref.z);
  for (const Support& s : w.supports)
    last_support_ = std::max(last_support_, s.history->open_ended ? std::numeric_limits<double>::infinity() : s.history->time.back());
  if (analysis_.kind == AnalysisKind::rest && last_support_ == 0.0 && pushed != w.loads.end()) last_support_ = 1.0;  // loads alone
  if (cases::has_push_shape(analysis_)) shape_.assign(static_cast<std::size_t>(e.count), {});
  no_shear_ = vertical ||
              (pushed != w.loads.end() && std::ranges::none_of(w.loads, [](const PointLoad& l) { return l.grows && l.force != Vec3{}; }));
  if (!analysis_.level) return;
  for (const PointLoad& l : w.loads) {
    if (!l.grows) continue;
    for (auto* column : {&e.ixx, &e.iyy, &e.izz, &e.ixy, &e.ixz, &e.iyz}) nth((*column), l.element) = 0.0;
  }
}

void LoadProgram::set(const Drive& drive, const std::vector<Vec3>& shape) {
  drive_ = drive;
  if (!shape_.empty()) shape_ = shape;
}

void LoadProgram::begin(const World& w) {
  if (!active()) return;
  if (drive_.pace <= 0.0) throw std::logic_error("a quasi-static analysis begins without a drive");
  state_ = {};
  state_.start = displacement(w.elements, control_);
}

Vec3 LoadProgram::field(double factor) const noexcept {
  if (analysis_.kind == AnalysisKind::pushover && analysis_.pattern == LoadPattern::mass && shape_.empty())
    return (factor * gravity_) * across_;
  if (analysis_.kind != AnalysisKind::tilt) return {};
  const double c = 1.0 / std::sqrt(1.0 + factor * factor);
  return gravity_ * ((c - 1.0) * down_ + (factor * c) * across_);
}

/// Of q: the power of the forces over what they are in all, at a load factor of 1.
double LoadProgram::rate_of(const World& w) const {
  if (follows_supports(analysis_)) return 0.0;
  if (analysis_.kind == AnalysisKind::cyclic || analysis_.pattern == LoadPattern::given) return power_of_growing_loads(w) / drive_.weight;
  const Elements& e = w.elements;
  const auto velocity = [&](std::size_t i) { return Vec3{e.vx[i], e.vy[i], e.vz[i]}; };
  double sum = 0.0;
  if (!shape_.empty()) {
    for (std::size_t i = 0; i < shape_.size(); ++i) sum += e.mass[i] * dot(shape_[i], velocity(i));
    return sum / mass_;
  }
  // Where the force goes as it grows: a turning gravity pushes at right angles to itself.
  const double c = 1.0 / std::sqrt(1.0 + state_.factor * state_.factor);
  const Vec3 along = analysis_.kind == AnalysisKind::tilt ? c * across_ - (state_.factor * c) * down_ : across_;
  for (std::size_t i = 0; i < static_cast<std::size_t>(e.count); ++i) sum += e.fixed[i] ? 0.0 : e.mass[i] * dot(along, velocity(i));
  return sum / mass_;
}

/// Of the moving end, m/s.
double LoadProgram::end_rate() const {
  if (analysis_.kind != AnalysisKind::cyclic) return std::min((drive_.first + state_.target) / drive_.pace, drive_.fastest);
  const auto cycle = static_cast<std::size_t>(state_.half_cycles) / 2, each = static_cast<std::size_t>(analysis_.cycles);
  const double amplitude = analysis_.amplitudes[std::min(cycle / each, analysis_.amplitudes.size() - 1)];
  return state_.sense * std::min(amplitude / (kCyclePace * drive_.pace), drive_.fastest);
}

/// Reversals of the cycles: at each amplitude so often to and fro.
void LoadProgram::turn_round() {
  const auto cycle = static_cast<std::size_t>(state_.half_cycles) / 2, each = static_cast<std::size_t>(analysis_.cycles);
  if (cycle >= each * analysis_.amplitudes.size()) return;
  if (state_.sense * state_.moved < analysis_.amplitudes[cycle / each]) return;
  state_.sense = -state_.sense;
  state_.half_cycles += 1.0;
}

void LoadProgram::look(const World& w) {
  const Elements& e = w.elements;
  double sum = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(e.count); ++i) {
    const double* r = e.wrench.data() + i * kernels::kWrenchStride;
    if (!e.fixed[i]) sum -= r[0] * across_.x + r[1] * across_.y + r[2] * across_.z;
  }
  state_.shear_sum += sum, state_.factor_sum += state_.factor, state_.looks += 1.0;
  if (state_.looks * static_cast<double>(kLook) * w.dt < 1.0 / drive_.frequency) return;
  state_.shear = state_.shear_sum / state_.looks, state_.mean_factor = state_.factor_sum / state_.looks;
  state_.shear_sum = state_.factor_sum = state_.looks = 0.0;
  state_.most_shear = std::max(state_.most_shear, state_.shear), state_.most_factor = std::max(state_.most_factor, state_.mean_factor);
}

bool LoadProgram::is_over(const World& w) const {
  const double left = 1.0 - analysis_.drop;
  // Whether all loads so far are within what the tolerance of states of rest leaves open.
  const auto is_noise = [&] {
    if (!cases::finds_rest(analysis_) || no_shear_) return false;
    const double most = analysis_.kind == AnalysisKind::tilt ? state_.most_factor : state_.most_shear / (mass_ * gravity_);
    return most < kNoise * analysis_.tolerance;
  };
  switch (analysis_.kind) {
    case AnalysisKind::pushover:
    case AnalysisKind::tilt: {
      // A jolt lowers one of them for a moment, but not the means of both over a first period; and while loads are small, vibrations that
      // settling has left are not.
      const bool softer =
          analysis_.kind == AnalysisKind::tilt || no_shear_
              ? state_.mean_factor < left * state_.most_factor
              : state_.mean_factor < (1.0 - 0.5 * analysis_.drop) * state_.most_factor && state_.shear < left * state_.most_shear;
      const bool dropped = softer && state_.target > drive_.first && !is_noise();
      return dropped || state_.factor >= analysis_.largest_factor || control_displacement(w) >= largest_displacement();
    }
    case AnalysisKind::cyclic:
      return half_cycles() >= whole_half_cycles() && state_.moved >= 0.0;
    default:
      return false;
  }
}

void LoadProgram::advance(const World& w, std::int64_t step) {
  if (!active() || drive_.pace <= 0.0 || step == 0) return;
  const bool at_rest = cases::finds_rest(analysis_);
  state_.factor_before = state_.factor;
  if (analysis_.kind == AnalysisKind::rest) {
    if (last_support_ > 0.0) state_.factor = std::min(1.0, state_.factor + pull_ / last_support_);
  } else if (analysis_.kind != AnalysisKind::settlement) {
    state_.speed = rate_of(w);
    const double on = at_rest ? state_.sense * pull_ : w.dt * end_rate(), moved = w.dt * state_.speed;
    state_.target += on, state_.moved += moved;
    state_.factor += drive_.stiffness * (on - moved);
    if (analysis_.kind == AnalysisKind::cyclic && !at_rest) turn_round();
  }
  if (step % kLook != 0 || at_rest) return;
  look(w);
  const bool over = follows_supports(analysis_) ? support_time(static_cast<double>(step) * w.dt) >= last_support_ : is_over(w);
  if (over && state_.ended == 0.0) state_.ended = static_cast<double>(step);
}

void LoadProgram::rest_at(const World& w, double base_shear, std::int64_t step) {
  state_.shear = base_shear, state_.mean_factor = state_.factor;
  state_.most_shear = std::max(state_.most_shear, state_.shear), state_.most_factor = std::max(state_.most_factor, state_.factor);
  if (analysis_.kind == AnalysisKind::cyclic) turn_round();
  if (!follows_supports(analysis_) && is_over(w)) end_at(step);
}

double LoadProgram::share_of_largest() const noexcept {
  const bool by_factor = analysis_.kind == AnalysisKind::tilt || no_shear_;
  const double now = by_factor ? state_.mean_factor : state_.shear, most = by_factor ? state_.most_factor : state_.most_shear;
  return most > 0.0 ? now / most : 1.0;
}

double LoadProgram::way_left() const noexcept {
  if (analysis_.kind != AnalysisKind::cyclic) return std::numeric_limits<double>::infinity();
  const double least = 0.01 * analysis_.amplitudes.front();  // the spring gives way: the moving end goes a little farther
  const auto cycle = static_cast<std::size_t>(state_.half_cycles) / 2, each = static_cast<std::size_t>(analysis_.cycles);
  const bool over = cycle >= each * analysis_.amplitudes.size();
  const double goal = over ? 0.0 : analysis_.amplitudes[cycle / each];
  return std::max(least, goal - state_.sense * state_.moved);
}

double LoadProgram::add_forces(World& w) const {
  if (shape_.empty()) return 0.0;
  for (std::int32_t i = 0; i < w.elements.count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    kernels::add_wrench(w.elements.wrench.data(), i, (state_.factor * gravity_ * w.elements.mass[k]) * shape_[k], {});
  }
  return 0.5 * w.dt * (state_.factor + state_.factor_before) * drive_.weight * state_.speed;
}

double LoadProgram::control_displacement(const World& w) const { return dot(displacement(w.elements, control_) - state_.start, across_); }

AssessmentRow LoadProgram::row(const World& w, double time) const {
  const double u = control_displacement(w);
  double support = 0.0;
  for (const Support& s : w.supports) support = std::max(support, moved(w, s));
  return {time, state_.factor, u, u / height_, state_.moved, state_.shear, support, state_.ended > 0.0 ? 1.0 : 0.0};
}

}  // namespace voussoir::solver
