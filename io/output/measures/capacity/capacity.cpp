// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/capacity/capacity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "io/input/case_file/case_file.h"
#include "io/input/files/errors.h"
#include "io/input/files/hdf5_file.h"
#include "io/output/measures/capacity/equivalent_system.h"
#include "io/output/measures/debris/bodies.h"
#include "io/output/replay/collapse_parts.h"
#include "io/output/replay/frame_reader.h"
#include "io/output/replay/run_file.h"
#include "solver/run/run.h"

namespace voussoir::io {
namespace {

constexpr double kWindow = 0.1;        // of the pace: length of the window for the mean load factor
constexpr double kLost = 2.0;          // AssessmentRow::over of a row that is no state of rest
constexpr double kOnward = 0.9;        // least net share of the displacement path in such a window
constexpr double kLoaded = 0.25;       // of the largest load factor: the work put in before is too small to compare with
constexpr double kFirstShare = 0.15;   // of the largest base shear: its secant is the first stiffness
constexpr double kLeastShear = 1e-3;   // of the loads: a smaller base shear counts as none, as when only moments grow
constexpr double kRoundOff = 1e-8;     // of a largest value: a row that comes so close to it has it
constexpr double kLeftOpen = 1e-3;     // the same of states of rest, by what their tolerance leaves open
constexpr double kHalf = 0.5;          // of the least size of an element: it has fallen if it has moved farther while gravity was put on
constexpr double kNearCollapse = 0.8;  // of the largest base shear, on the falling branch: EN 1998-3:2005, C.4.1.1
constexpr double kItalianShare = 0.7;  // of the largest base shear: point on the elastic branch

using Values = std::vector<double>;

/// Value of x where `y` first passes `level` between rows `from` and `to`; NaN: it does not.
double crossing(const Values& x, const Values& y, std::size_t from, std::size_t to, double level) {
  for (std::size_t i = std::max<std::size_t>(from, 1); i <= to && i < y.size(); ++i) {
    const double a = y[i - 1] - level, b = y[i] - level;
    if (a == 0.0) return x[i - 1];
    if ((a < 0.0) != (b < 0.0)) return x[i - 1] + (x[i] - x[i - 1]) * a / (a - b);
  }
  return Bilinear::kNone;
}

/// ∫ y dx up to where x passes `end` for the first time after row `from`.
double area(const Values& x, const Values& y, std::size_t from, double end) {
  double sum = 0.0;
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (i > from && x[i] >= end) return sum + (end - x[i - 1]) * y[i - 1];
    sum += 0.5 * (y[i] + y[i - 1]) * (x[i] - x[i - 1]);
  }
  return sum;
}

Bilinear finished(Bilinear b) {
  b.ductility = b.ultimate < b.yield ? Bilinear::kNone : b.ultimate / b.yield;  // none where the curve turns back
  return b;
}

/// Bilinear curve of EN 1998-1, B.3: the plateau is the largest base shear, and the areas up to its displacement are equal.
Bilinear ec8_of(const Capacity& c, std::size_t peak) {
  Bilinear b;
  b.force = c.peak_shear;
  b.yield = 2.0 * (c.peak_displacement - area(c.curve.displacement, c.curve.base_shear, peak, c.peak_displacement) / b.force);
  b.stiffness = b.force / b.yield;
  b.ultimate = c.ultimate_displacement;
  return finished(b);
}

/// Bilinear curve of Circolare 7/2019, C7.8.1.6 (masonry): through the point at 0.7 of the largest base shear, with equal areas up to the
/// ultimate displacement.
Bilinear ntc_of(const Capacity& c, std::size_t peak) {
  Bilinear b;
  const double at = crossing(c.curve.displacement, c.curve.base_shear, 0, peak, kItalianShare * c.peak_shear);
  b.stiffness = kItalianShare * c.peak_shear / at;
  b.ultimate = c.ultimate_displacement;
  const double below = area(c.curve.displacement, c.curve.base_shear, peak, b.ultimate);
  b.force = b.stiffness * (b.ultimate - std::sqrt(b.ultimate * b.ultimate - 2.0 * below / b.stiffness));
  b.yield = b.force / b.stiffness;
  return finished(b);
}

/// Mean load factor over rows `from` to `to`, weighted by the displacement of its forces, and the part of it borne by motion.
struct Window {
  double mean = 0.0, motion = 0.0;
  [[nodiscard]] double at_rest() const { return mean - motion; }
};
/// The window of given rows; nothing if the structure oscillates in it, since no virtual work is defined along a path that turns back.
std::optional<Window> window_of(const CapacityCurve& r, double weight, std::size_t from, std::size_t to) {
  double way = 0.0, sum = 0.0;
  for (std::size_t i = from + 1; i <= to; ++i) {
    const double on = r.moved[i] - r.moved[i - 1];
    way += std::abs(on), sum += 0.5 * (r.factor[i] + r.factor[i - 1]) * on;
  }
  const double moved = r.moved[to] - r.moved[from];
  if (moved <= 0.0 || moved < kOnward * way) return {};
  const double motion = r.kinetic[to] - r.kinetic[from] + r.damping[to] - r.damping[from];
  return Window{sum / moved, std::max(0.0, motion) / (weight * moved)};
}

/// A largest value, and the first row that has it but for round-off, or for what a tolerance leaves open. Where the curve is level, as
/// while blocks slide, these alone decide which row is the very largest.
struct Peak {
  double value = 0.0;
  std::size_t row = 0;
};
Peak peak_of(const CapacityCurve& r, const Values& values) {
  const double most = *std::ranges::max_element(values), open = r.unbalanced.empty() ? kRoundOff : kLeftOpen;
  const double enough = most - open * std::abs(most);
  return {most, static_cast<std::size_t>(std::ranges::find_if(values, [=](double v) { return v >= enough; }) - values.begin())};
}

/// Finds the largest load factor borne by the structure itself, (30) of THEORY.md; of states of rest it is the largest.
void look_at_motion(Capacity& c, double pace, double weight) {
  const CapacityCurve& r = c.curve;
  const auto [most_factor, peak] = peak_of(r, r.factor);
  c.multiplier = most_factor;
  c.least_factor = *std::ranges::min_element(r.factor);
  if (!r.unbalanced.empty()) {
    c.unbalanced = *std::ranges::max_element(r.unbalanced);
    c.multiplier_at_rest = c.multiplier, c.multiplier_time = r.time[peak], c.multiplier_displacement = r.displacement[peak];
    return;
  }
  std::size_t from = 0, at = 0;
  double most = -1.0;
  for (std::size_t i = 1; i < r.time.size(); ++i) {
    while (from + 1 < i && r.time[from] < r.time[i] - kWindow * pace) ++from;
    const std::optional<Window> w = window_of(r, weight, from, i);
    if (!w || w->at_rest() <= most) continue;
    most = w->at_rest(), at = i;
    c.multiplier_at_rest = w->at_rest(), c.motion_share = w->motion / w->mean;
  }
  c.multiplier_time = r.time[at], c.multiplier_displacement = r.displacement[at];
  for (std::size_t i = 0; i <= at; ++i) {
    const double put_in = r.input[i] - r.input.front();
    if (r.factor[i] >= kLoaded * c.multiplier_at_rest && put_in > 0.0) c.kinetic_share = std::max(c.kinetic_share, r.kinetic[i] / put_in);
  }
}

void look_at_shear(Capacity& c, double drop, double weight) {
  const CapacityCurve& r = c.curve;
  const auto [most, peak] = peak_of(r, r.base_shear);
  c.peak_shear = most, c.peak_displacement = r.displacement[peak], c.peak_time = r.time[peak];
  if (c.peak_shear <= kLeastShear * weight * c.multiplier) return;
  c.first_stiffness = kFirstShare * c.peak_shear / crossing(r.displacement, r.base_shear, 0, peak, kFirstShare * c.peak_shear);
  const double left = (1.0 - drop) * c.peak_shear;
  c.ultimate_displacement = crossing(r.displacement, r.base_shear, peak + 1, r.time.size(), left);
  c.ultimate_drift = crossing(r.drift, r.base_shear, peak + 1, r.time.size(), left);
  c.near_collapse = crossing(r.displacement, r.base_shear, peak + 1, r.time.size(), kNearCollapse * c.peak_shear);
  c.ec8 = ec8_of(c, peak);
  c.ntc = ntc_of(c, peak);
}

/// Computes the work of the pattern's forces, the losses and the growth of the stored energy.
void look_at_work(Capacity& c, double weight) {
  const CapacityCurve& r = c.curve;
  for (std::size_t i = 1; i < r.time.size(); ++i)
    c.loop_area += 0.5 * weight * (r.factor[i] + r.factor[i - 1]) * (r.moved[i] - r.moved[i - 1]);
  c.dissipated = r.losses.back() - r.losses.front();
  c.stored = r.stored.back() - r.stored.front();
}

/// Finds the last time at which the structure only followed its supports, with quiet kinetic energy.
void look_at_fall(Capacity& c, double quiet) {
  const CapacityCurve& r = c.curve;
  if (!r.unbalanced.empty()) {  // the last state of rest
    c.unbalanced = *std::ranges::max_element(r.unbalanced);
    if (r.over.back() == kLost) c.collapse_movement = r.support_moved.back(), c.collapse_time = r.time.back();
    return;
  }
  std::size_t i = r.time.size();
  while (i > 0 && r.kinetic[i - 1] > quiet) --i;
  if (i == 0 || i == r.time.size()) return;
  c.collapse_movement = r.support_moved[i - 1], c.collapse_time = r.time[i - 1];
}

std::vector<std::string> names_of(const BodiesInFrame& found, const Building& building) {
  std::vector<std::string> names;
  const double mass = std::accumulate(building.mass.begin(), building.mass.end(), 0.0);
  for (const Body& b : found.bodies) {
    std::array<char, 120> size{};
    std::snprintf(size.data(), size.size(), " (elements: %td, of the mass: %.1f %%, moved by %.1f mm)", std::ranges::count(found.id, b.id),
                  100.0 * b.mass / mass, 1e3 * norm(b.displacement));
    names.push_back(body_name(b, building) + size.data());
  }
  return names;
}

std::vector<std::string> bodies_at(const Hdf5File& run, const FrameReader& frames, const Building& building, std::uint64_t frame) {
  BodyFinder finder(run, building, first_poses(frames));
  return names_of(finder.find(frames.times()[frame], poses_of(frames, frame)), building);
}

/// Names of the parts that move as one from the largest load factor on, with their motion.
std::vector<std::string> parts_from(const Hdf5File& run, const FrameReader& frames, const Building& building, double peak) {
  CollapseParts found = collapse_parts(run, frames, building.mass, peak);
  BodyFinder finder(run, building, found.from == 0 ? first_poses(frames) : poses_of(frames, found.from));
  finder.take(std::move(found.part), frames.times()[found.from]);
  return names_of(finder.find(frames.times()[found.to], poses_of(frames, found.to)), building);
}

/// The share of the mass that moved by more than half its least size before the load began.
double fallen_before(const FrameReader& frames, const Building& building) {
  const std::vector<Pose> at_first = first_poses(frames), loaded = poses_of(frames, 0);
  double all = 0.0, fallen = 0.0;
  for (std::size_t i = 0; i < building.mass.size(); ++i) {
    const Box& box = building.box[i];
    const double least = std::min({box.size(0), box.size(1), box.size(2)});
    all += building.mass[i];
    if (norm(loaded[i].centre - at_first[i].centre) > kHalf * least) fallen += building.mass[i];
  }
  return all > 0.0 ? fallen / all : 0.0;
}

/// Finds the mechanism from the largest load factor on, and bodies at the end, if joints are open enough to separate them.
void look_at_mechanism(const Hdf5File& run, Capacity& c) {
  const FrameReader frames(run);
  if (frames.frames() == 0) return;
  const Building building = building_of(run);
  c.fallen_before = fallen_before(frames, building);
  if (c.kind == cases::AnalysisKind::rest && c.fallen_before > 0.0) c.ended = "collapse";
  const auto& times = frames.times();
  const auto next = static_cast<std::uint64_t>(std::ranges::lower_bound(times, c.multiplier_time) - times.begin());
  const std::uint64_t at = std::min(next, frames.frames() - 1);
  c.mechanism = has_peak(c) ? parts_from(run, frames, building, c.multiplier_time) : bodies_at(run, frames, building, at);
  c.mechanism_time = times[at];
  c.mechanism_at_end = bodies_at(run, frames, building, frames.frames() - 1);
  if (follows_supports(c.kind)) c.hanging = hanging_walls(run, building, first_poses(frames), poses_of(frames, frames.frames() - 1));
}

/// Whether something has fallen in a run, however little.
bool has_fallen(const Hdf5File& run) {
  return run.has_attribute("/summary", "fallen_mass_fraction") && run.attribute_double("/summary", "fallen_mass_fraction") > 0.0;
}

/// \param end  s, up to which the run has come: beyond the last row where that is the last state of rest
/// \param failed  the program ended the run, since it could not vouch for what came next
const char* why_ended(const Capacity& c, const cases::Analysis& a, bool collapsed, double end, bool failed) {
  const CapacityCurve& r = c.curve;
  if (failed) return "numerical failure";
  if (r.over.back() == kLost) return "no further state of rest";
  if (r.over.back() == 0.0) return collapsed ? "collapse" : end < a.longest * (1.0 - 1e-3) ? "not yet" : "longest";
  if (a.kind == cases::AnalysisKind::rest) return collapsed ? "collapse" : "all is on";
  if (a.kind == cases::AnalysisKind::settlement || a.kind == cases::AnalysisKind::cyclic) return "history";
  if (r.factor.back() >= a.largest_factor * (1.0 - 1e-3)) return "largest factor";
  return r.drift.back() >= a.largest_drift * (1.0 - 1e-3) ? "largest drift" : "drop";
}

/// Running mean over one period, centred at each row, of equally spaced rows; over less at the ends. Removes vibration without a lag.
Values smoothed(const Values& time, const Values& y, double period) {
  Values out(y.size());
  for (std::size_t i = 0; i < y.size(); ++i) {
    std::size_t half = 0;
    while (half < i && i + half + 1 < y.size() && time[i + half + 1] - time[i] <= 0.5 * period) ++half;
    double sum = 0.0;
    for (std::size_t k = i - half; k <= i + half; ++k) sum += y[k];
    out[i] = sum / static_cast<double>(2 * half + 1);
  }
  return out;
}

/// Base shear along the push at the rows of /assessment, from /forces, which has the same times.
Values base_shear(const Hdf5File& run, const Values& time, const std::array<double, 2>& direction, double period) {
  const auto at = run.read<double>("/forces/time"), force = run.read<double>("/forces/base_shear");
  if (force.size() != 3 * at.size()) throw FileError(run.path(), "/forces does not fit together");
  const double length = std::hypot(direction[0], direction[1]);
  Values out;
  for (std::size_t k = 0; k < at.size() && out.size() < time.size(); ++k) {
    if (at[k] < time[out.size()]) continue;
    out.push_back(-(force[3 * k] * direction[0] + force[3 * k + 1] * direction[1]) / length);
  }
  return smoothed({time.begin(), time.begin() + static_cast<std::ptrdiff_t>(out.size())}, out, period);
}

/// Rows of /assessment with those of /energy and /forces at the same times, which all tables have from time zero on.
CapacityCurve curve_of(const Hdf5File& run, const std::array<double, 2>& direction, double period) {
  const auto of = [&](const char* name) { return run.read<double>(std::string("/assessment/") + name); };
  CapacityCurve c{of("time"),
                  of("factor"),
                  of("displacement"),
                  of("drift"),
                  of("moved"),
                  of("base_shear"),
                  of("support_moved"),
                  of("over"),
                  {},
                  {},
                  {},
                  {},
                  {},
                  {}};
  if (run.exists("/assessment/unbalanced")) c.unbalanced = of("unbalanced");
  const bool at_rest = !c.unbalanced.empty() && !std::isnan(c.unbalanced.front());
  if (!at_rest) c.unbalanced.clear();
  const auto time = run.read<double>("/energy/time");
  const auto column = [&](const char* name) { return run.read<double>(std::string("/energy/") + name); };
  const Values input = column("input"), kinetic = column("kinetic"), damping = column("damping"), dashpot = column("dashpot"),
               friction = column("friction"), fracture = column("fracture"), strain = column("strain"), contact = column("contact"),
               gravity = column("gravity"), residual = column("residual");
  std::size_t k = 0, kept = 0;
  for (; kept < c.time.size(); ++kept) {
    while (k < time.size() && time[k] < c.time[kept]) ++k;
    if (k == time.size()) break;
    const bool lost = c.over[kept] == kLost;  // its motion is no result, whatever its residual
    if (lost) c.lost_residual = residual[k];
    if (!lost && !(residual[k] <= solver::kResidualLimit)) break;  // a row after the run was lost
    c.input.push_back(input[k]), c.kinetic.push_back(kinetic[k]), c.damping.push_back(damping[k]);
    c.losses.push_back(dashpot[k] + friction[k] + fracture[k] + damping[k]);
    c.stored.push_back(kinetic[k] + strain[k] + contact[k] + gravity[k]);
  }
  c.base_shear = base_shear(run, c.time, direction, at_rest ? 0.0 : period);
  kept = std::min(kept, c.base_shear.size());
  const std::array columns = {&c.time, &c.factor, &c.displacement, &c.drift,   &c.moved,  &c.base_shear, &c.support_moved,
                              &c.over, &c.input,  &c.kinetic,      &c.damping, &c.losses, &c.stored};
  for (Values* v : columns) v->resize(kept);
  if (!at_rest) return c;
  c.unbalanced.resize(kept);
  if (kept > 1 && c.over.back() == kLost) {  // no state of rest, so no point of the curve
    for (Values* v : columns) v->pop_back();
    c.unbalanced.pop_back();
    c.over.back() = kLost;
  }
  return c;
}

std::optional<ControlPoint> control_of(const Hdf5File& run) {
  if (!run.has_attribute("/assessment", "control")) return {};
  const std::int64_t element = run.attribute_int("/assessment", "control");
  const std::vector<std::string> tags = run.read_strings("/model/element/tag");
  const auto k = static_cast<std::size_t>(element);
  if (element < 0 || k >= tags.size()) throw FileError(run.path(), "/assessment: control is no element of the model");
  const std::vector<double> position = run.read<double>("/model/element/position0");
  return ControlPoint{element, tags[k], Vec3{position.at(3 * k), position.at(3 * k + 1), position.at(3 * k + 2)} + origin_of_run(run),
                      building_of(run).is_timber(k)};
}

}  // namespace

Capacity capacity_of(cases::AnalysisKind kind, double drop, double pace, double weight, double quiet, CapacityCurve curve) {
  Capacity c;
  c.kind = kind, c.drop = drop, c.lost_residual = curve.lost_residual;
  c.curve = std::move(curve);
  if (follows_supports(kind)) {
    look_at_fall(c, quiet);
    return c;
  }
  look_at_motion(c, pace, weight);
  look_at_work(c, weight);
  if (kind == cases::AnalysisKind::cyclic)
    c.loops = loops_of(c.curve, weight);
  else
    look_at_shear(c, drop, weight);
  return c;
}

std::optional<Capacity> capacity_figures(const Hdf5File& run) {
  if (!run.exists("/assessment") || !run.has_attribute("/assessment", "pace")) return {};
  const cases::Analysis a = read_case({run.path(), run.attribute_text("/case", "toml")}).value.analysis;
  const auto drive = [&](const char* name) { return run.attribute_double("/assessment", name); };
  CapacityCurve curve = curve_of(run, a.direction, 1.0 / drive("frequency"));
  if (curve.time.empty()) return {};
  Capacity c = capacity_of(a.kind, a.drop, drive("pace"), drive("weight"), drive("quiet"), std::move(curve));
  const bool collapsed = (run.has_attribute("/summary", "collapsed") && run.attribute_int("/summary", "collapsed") != 0) ||
                         (a.kind == cases::AnalysisKind::rest && has_fallen(run));  // rubble rests, too
  const bool told = run.has_attribute("/summary", "end_time");
  c.ended = why_ended(c, a, collapsed, told ? run.attribute_double("/summary", "end_time") : c.curve.time.back(),
                      run.has_attribute("/summary", "failure"));
  c.control = control_of(run);
  return c;
}

std::optional<Capacity> capacity_of(const Hdf5File& run) {
  std::optional<Capacity> c = capacity_figures(run);
  if (!c) return c;
  look_at_mechanism(run, *c);
  const cases::Analysis a = read_case({run.path(), run.attribute_text("/case", "toml")}).value.analysis;
  if (!a.demand.empty()) look_at_demand(run, a.direction, read_demand(a.demand, a.demand_damping, {}, {}, "analysis.demand"), *c);
  return c;
}

std::optional<Capacity> capacity_under(const Hdf5File& run, const DemandSpectrum& demand, const std::string& option) {
  std::optional<Capacity> c = capacity_figures(run);
  if (!c || c->kind != cases::AnalysisKind::pushover)
    throw cases::InputError(option, "asks for the capacity curve of a pushover; " + run.path() + " has none");
  look_at_mechanism(run, *c);
  look_at_demand(run, read_case({run.path(), run.attribute_text("/case", "toml")}).value.analysis.direction, demand, *c);
  return c;
}

}  // namespace voussoir::io
