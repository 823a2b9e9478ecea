// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/run/simulation.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include "cases/case.h"
#include "cases/loads/gravity.h"
#include "cases/model.h"
#include "geometry/nth.h"
#include "solver/contact/contact_forces.h"
#include "solver/contact/contact_lists.h"
#include "solver/contact/overlap_contact.h"
#include "solver/run/loads.h"
#include "solver/run/multirate.h"
#include "solver/run/over_elements.h"
#include "solver/setup/setup.h"
#include "solver/supports/supports.h"
#include "solver/ties/tie_forces.h"
#include "solver/world/errors.h"

namespace voussoir::solver {

namespace {

constexpr double kRelaxedRamp = 2000.0;      // iterations, of gravity in a relaxation
constexpr double kRelaxedLimit = 200'000.0;  // iterations, of settling after it

std::unique_ptr<World> world_of(const cases::Case& c, const cases::Model& m, const Options& o) {
  return cases::finds_rest(c.analysis) ? build_world(without_rates(c), m, o) : build_world(c, m, o);
}

constexpr std::int64_t kGuardInterval = 20;  // steps
constexpr double kRamp = 1.0;                // s, of gravity, if the case says nothing of it
constexpr double kShortestRamp = 0.05;       // s: a shorter one says nothing of how slowly a structure sways
// Of (22a) in a relaxation: with more, elements under much pressure stick before they are at rest.
constexpr double kRestRoundOff = 1e-10;
constexpr double kRest = 1e-8;      // kinetic over elastic energy
constexpr double kRoundOff = 1e-9;  // of the histories of supports: what the sums of many increments may leave of them

}  // namespace

Simulation::Simulation(const cases::Case& c, const cases::Model& m, const cases::GroundMotion& motion, const Options& o)
    : case_(c), motion_(motion), ground_velocity_(motion), world_(world_of(c, m, o)), program_(c, *world_) {
  World& w = *world_;
  set_threads(o.threads);
  list_live_blocks(w);
  forces_stage_.tasks = JointTasks(w);
  full_gravity_ = cases::gravity_on_base(c);
  const double frequency = c.damping.frequency.value_or(0.0);
  ramp_ = c.gravity.ramp.value_or(frequency > 0.0 ? 5.0 / frequency : kRamp);
  settle_limit_ = c.gravity.settle_limit;
  if (cases::finds_rest(c.analysis)) {
    relaxation_ = Relaxation(c, w), path_ = Path(c.analysis), lead_ = Lead(w);
    ramp_ = kRelaxedRamp * w.dt, settle_limit_ = kRelaxedLimit * w.dt;
  }
  damage_ = initial_damage(w);
  ledger_ = Ledger(w);
  case_alpha_ = w.elements.alpha;
  for (const cases::HistoryPoint& p : c.output.history) followed_.push_back(cases::nearest_element(m, p.point));
  start_.resize(followed_.size());
  turned_.resize(followed_.size());
  velocity_before_.resize(followed_.size());
  samples_.resize(followed_.size());
  cuts_ = Cuts(w, c.output.cuts);
  load_before_.resize(2 * w.loads.size());
  load_start_.resize(w.loads.size());
  if (c.gravity.settle && norm(full_gravity_) > 0.0) {
    phase_ = Phase::settling;
    // Near-critical for the slowest sway the case names; else for one that the ramp calls slow.
    settling_alpha_ =
        2.0 * 2.0 * std::numbers::pi * (frequency > 0.0 ? frequency : 5.0 / (ramp_ > 0.0 ? std::max(ramp_, kShortestRamp) : kRamp));
    set_damping(settling_alpha_);
  } else {
    if (!relaxation_.on()) set_initial_velocities(w);
    start_cycles(w);
  }
  // Rows follow from the state: a drift of no time writes them.
  kernels::drift(w.elements.view(), w.element_rows(), 0.0, 0, w.elements.rows);
}

Simulation::~Simulation() = default;

double Simulation::time_of(std::int64_t step) const {
  const double t = static_cast<double>(step) * world_->dt;
  return phase_ == Phase::settling ? t - (ramp_ + settle_limit_) : t;
}

double Simulation::gravity_share(double t) const {
  return phase_ == Phase::shaking || t >= ramp_ ? 1.0 : 0.5 - 0.5 * std::cos(std::numbers::pi * t / ramp_);
}

Vec3 Simulation::gravity_at(double t) const { return gravity_share(t) * full_gravity_; }

Vec3 Simulation::ground_at(double t) const { return phase_ == Phase::shaking ? cases::acceleration_at(motion_, t) : Vec3{}; }

Vec3 Simulation::damped_ground(double t) const {
  return phase_ == Phase::shaking && case_.damping.inertial ? ground_velocity_.at(t) : Vec3{};
}

bool Simulation::damps_rotation() const { return phase_ == Phase::settling || program_.active(); }

/// On elements that are moved on in steps of a level. Gravity and ground act with the impulse of all of them, as pairs of that level do:
/// what rests on these has no velocity then.
kernels::BodyForces Simulation::body_forces(int level) const {
  const double dt = world_->step_of(level), t = static_cast<double>(step_) * world_->dt;
  kernels::BodyForces f{dt, gravity_at(t), ground_at(t), {}, {}, damps_rotation(), damped_ground(t)};
  if (step_ == 0) {  // no interval behind the first step
    const double share = world_->multirate.impulse_share(level, 0);
    f.gravity = share * f.gravity, f.ground = share * f.ground;
  } else {
    f.mean_gravity = 0.5 * (f.gravity + gravity_at(t - dt));
    f.mean_ground = 0.5 * (f.ground + ground_at(t - dt));
    if (phase_ == Phase::shaking && program_.active()) {
      // As if the base were accelerated the other way.
      f.ground = -1.0 * program_.acceleration();
      f.mean_ground = -1.0 * program_.mean_acceleration();
    }
  }
  if (relaxation_.on()) {
    f.gravity = f.ground = {};  // weights are among the forces of the rows
    f.round_off = kRestRoundOff;
  }
  return f;
}

/// Time in the histories of supports, at this step or so far ahead [s].
double Simulation::support_time(double ahead) const {
  if (!relaxation_.on()) return program_.support_time(static_cast<double>(step_) * world_->dt + ahead);
  return path_.clock() + (ahead > 0.0 ? path_.pull() : 0.0);
}

void Simulation::place_supports() {
  if (phase_ != Phase::settling) moved_ = std::max(moved_, solver::place_supports(*world_, support_time(0.0)));
}

void Simulation::move_supports_on() {
  if (phase_ != Phase::settling) solver::move_supports_on(*world_, support_time(0.0), support_time(world_->dt));
}

void Simulation::apply_loads() {
  World& w = *world_;
  const bool shaking = phase_ == Phase::shaking;
  if (shaking) ledger_.add_load_work(program_.add_forces(w));
  solver::apply_loads(w, ledger_, load_before_, step_, shaking ? static_cast<double>(step_) * w.dt : 0.0, program_.factor());
}

/// Adds the weights, measures how far the structure is from rest, and goes on along the path.
void Simulation::relax() {
  const Vec3 gravity = gravity_at(static_cast<double>(step_) * world_->dt);
  lead_.step(path_.pull());  // 0 while settling
  relaxation_.look(*world_, phase_ == Phase::settling ? gravity : gravity + program_.acceleration(), path_.pull() > 0.0, lead_);
  if (phase_ == Phase::shaking) path_.iterated(program_.factor());
}

void Simulation::accept_rest() {
  const World& w = *world_;
  const double sense = program_.sense();
  program_.rest_at(w, -dot(forces_.base_shear, program_.across()), step_);
  lead_.accept(w, program_.sense() == sense ? path_.increment() : 0.0);
  RestPoint p{.factor = program_.factor(), .done = program_.way(), .left = program_.way_left()};
  if (follows_supports(program_.analysis())) {
    p.done = path_.clock(), p.left = program_.last_support() - path_.clock();
    if (p.left <= kRoundOff * program_.last_support()) program_.end_at(step_);
  }
  p.broken = damage_.tension + damage_.shear + damage_.compression, p.slipped = damage_.slipped;
  for (const std::int32_t bonds : w.elements.bonds_at_start) p.bonds += bonds;
  path_.accept(p, 2.0 * std::numbers::pi / std::max(relaxation_.frequency() * w.dt, 1e-6), lead_.open());
}

/// A search waits for the first step of a cycle.
void Simulation::note_move(double moved) { moved_ = world_->multirate.starts_cycle(step_) ? moved : std::max(moved_, moved); }

/// Calls `work(move, first, last)` for all batches that are moved on in this step. \return the most of what it returns
template <class Work>
double Simulation::over_due_elements(Work work) {
  World& w = *world_;
  std::array<Move, Multirate::kMostLevels> moves{};
  const int due = w.multirate.due(step_);
  for (int level = 0; level < due; ++level) nth(moves, level) = {body_forces(level), w.travel.view(w.elements, w.step_of(level))};
  return over_elements(w, update_shares_, most_, [&](std::int64_t first, std::int64_t last) {
    const int level = w.batch_level(static_cast<std::size_t>(first / kernels::kBatch));
    return level < due ? work(nth(moves, level), first, last) : 0.0;
  });
}

void Simulation::kick() {
  World& w = *world_;
  over_due_elements([&, view = w.elements.view(), rows = w.element_rows()](const Move& m, std::int64_t first, std::int64_t last) {
    kernels::kick(view, rows, m.forces, first, last);
    return 0.0;
  });
}

void Simulation::drift() {
  World& w = *world_;
  note_move(over_due_elements([&, view = w.elements.view(), rows = w.element_rows()](const Move& m, std::int64_t first, std::int64_t last) {
    kernels::drift(view, rows, m.forces.dt, first, last);
    if (w.multirate.on()) sum_velocities(w, step_, first, last);
    return kernels::advance_travel(view, m.travel, first, last);
  }));
}

// In one go where nobody looks in between: an element's rows are then still at hand.
void Simulation::kick_and_drift() {
  World& w = *world_;
  note_move(over_due_elements([&, view = w.elements.view(), rows = w.element_rows()](const Move& m, std::int64_t first, std::int64_t last) {
    kernels::kick(view, rows, m.forces, first, last);
    kernels::drift(view, rows, m.forces.dt, first, last);
    if (w.multirate.on()) sum_velocities(w, step_, first, last);
    return kernels::advance_travel(view, m.travel, first, last);
  }));
}

void Simulation::set_threads(int threads) {
  pace_ = TeamSize(threads);
  world_->team.set_size(pace_.size());
}

void Simulation::step(Due due) {
  if (!world_->options.own_pace) return advance(due);
  using Clock = std::chrono::steady_clock;
  world_->team.set_size(pace_.size());
  const Clock::time_point start = Clock::now();
  advance(due);
  pace_.note(std::chrono::duration<double>(Clock::now() - start).count());
}

void Simulation::advance(Due due) {
  World& w = *world_;
  const double t = time();
  const auto note = [&w](StepStage s) { w.log.note(s); };  // see step_stages.h
  note(StepStage::supports);
  place_supports();
  {
    const StageTimer timer(times_, Stage::search);
    const bool search = w.multirate.starts_cycle(step_) && w.travel.search_due(moved_);
    if (search) note(StepStage::search), search_contacts(w);
    if (search && w.multirate.on()) note(StepStage::contact_levels), renew_contact_levels(w);
    if (w.contacts.stale_level < w.multirate.due(step_)) note(StepStage::gather_lists), build_gather(w);
    if ((search || step_ == 0) && w.multirate.on()) note(StepStage::moves), renew_moves(w);
  }
  const bool cuts_due = due.ledger && cuts_.any() && phase_ == Phase::shaking;
  {
    const StageTimer timer(times_, Stage::forces);
    if (cuts_due) std::ranges::fill(w.sides.pair_on, std::uint8_t{0});
    w.keep_pairs = cuts_due;
    solver::forces(w, t, step_, forces_stage_);
    note(StepStage::ties);
    ledger_.add_load_work(apply_ties(w, gravity_share(static_cast<double>(step_) * w.dt)));
    if (cuts_due) note(StepStage::cuts), cuts_.measure(w, cut_samples_);
  }
  {
    const StageTimer timer(times_, Stage::damage);
    note(StepStage::damage);
    record_damage(w, forces_stage_.events, t, damage_, cracks_);
  }
  if (due.sample) note(StepStage::base_forces), measure_base_forces();
  if (w.multirate.on()) note(StepStage::impulses), add_impulses(w, step_);
  if (due.ledger) {
    const StageTimer timer(times_, Stage::ledger);
    note(StepStage::ledger_before);
    ledger_.before_kick(w);
  }
  const StageTimer timer(times_, Stage::update);
  note(StepStage::support_work);
  ledger_.add_support_work(w);
  if (due.sample) note(StepStage::velocities_before), note_velocities();
  if (phase_ == Phase::shaking) note(StepStage::load_program), program_.pull(path_.pull()), program_.advance(w, step_);
  note(StepStage::loads);
  apply_loads();
  note(StepStage::support_velocities);
  move_supports_on();
  if (relaxation_.on()) note(StepStage::relaxation), relax();
  note(StepStage::kick);
  if (due.sample) {
    kick();
    note(StepStage::samples);
    take_samples();
    note(StepStage::drift);
    drift();
  } else {
    note(StepStage::drift);
    kick_and_drift();
  }
  if (phase_ != Phase::settling && supports_turn(w)) note(StepStage::support_spins), spin_supports(w);
  if (due.ledger) note(StepStage::ledger_after), ledger_.after_drift(w, body_forces(0), t, !path_.is_lost());
  ++step_;
  if (step_ % kGuardInterval == 0) peak_speed_ = std::max(peak_speed_, std::sqrt(fastest_square()));
}

// The row of the first step knows of no motion yet, and one from before the last step was perhaps of the ramp.
bool Simulation::at_rest() const {
  if (relaxation_.on()) return static_cast<double>(step_) * world_->dt > ramp_ && relaxation_.unbalanced() <= program_.analysis().tolerance;
  return step_ > 1 && static_cast<double>(step_) * world_->dt > ramp_ && ledger_.last().time == time_of(step_ - 1) &&
         ledger_.kinetic_over_elastic() < kRest;
}

// Not one step longer: settling has negative times, and time zero belongs to the shaking alone.
bool Simulation::settled_too_long() const { return static_cast<double>(step_) * world_->dt >= ramp_ + settle_limit_; }

void Simulation::set_damping(double alpha) {
  Elements& e = world_->elements;
  for (std::int32_t i = 0; i < e.count; ++i) {
    if (!nth(e.fixed, i)) nth(e.alpha, i) = alpha;
  }
}

void Simulation::start_shaking() {
  Elements& e = world_->elements;
  if (phase_ == Phase::settling) {
    if (!relaxation_.on()) set_initial_velocities(*world_);
    e.alpha = case_alpha_;
  }
  if (program_.active()) set_damping(program_.drive().damping);
  if (world_->drop_debris_damping) {
    for (std::size_t i = 0; i < e.bonds.size(); ++i) {
      if (e.bonds[i] == 0) e.alpha[i] = 0.0;
    }
  }
  phase_ = Phase::shaking;
  step_ = 0;
  start_cycles(*world_);
  ledger_.restart(*world_);
  program_.begin(*world_);
  for (std::size_t k = 0; k < followed_.size(); ++k) {
    const auto i = static_cast<std::size_t>(followed_[k]);
    start_[k] = {e.ux[i], e.uy[i], e.uz[i]};
    turned_[k] = {e.qw[i], e.qx[i], e.qy[i], e.qz[i]};
  }
  load_start_ = places_of_loads(*world_);
}

}  // namespace voussoir::solver
