// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/limit/limit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>

#include "cases/case.h"
#include "cases/loads/gravity.h"
#include "cases/model.h"
#include "solver/limit/balance.h"
#include "solver/limit/coulomb.h"
#include "solver/limit/friction_cone.h"
#include "solver/limit/programme/programmes.h"
#include "solver/world/errors.h"

namespace voussoir::solver {
namespace {

constexpr double kFalls = 1e-7;     // of the powers of all dead forces without their signs: a sum that is more than round-off
constexpr double kCertain = 100.0;  // so many times what a violation of the mechanism could hold back

/// The analysis in hand: the model, its programmes, and what checks them.
class Analysis {
 public:
  /// \pre out.contacts are those of the model
  Analysis(const cases::Case& c, const cases::Model& model, const LimitOptions& o, LimitResult& out)
      : model_(model),
        out_(out),
        direction_(main_direction(c, o.live)),
        forces_(limit_forces(c, model, out.contacts, o.live)),
        plane_(plane_of(out.contacts, forces_, direction_)),
        cone_(plane_ ? FrictionCone::in_plane() : FrictionCone(o.facets, o.outer)),
        balance_(out.contacts, forces_, plane_),
        programmes_(balance_, cone_, {o.inside_from, o.iterated}),
        checks_(model, out.contacts, forces_, cone_, direction_),
        tick_(o.tick) {
    out.plane = plane_.has_value();
    out.weight = forces_.weight;
    out.cone_error = cone_.error();
  }

  void find_associated() {
    refuse_what_falls();
    LimitState& s = out_.associated;
    std::vector<double> right = balance_.dead();
    for (double& r : right) r = -r;
    const ProgrammeSolution found = programmes_.solve({balance_.live(), right, LpGoal::most, kLpBound, {}, {}});
    if (found.outcome == LpOutcome::none) throw no_proof();
    if (found.outcome == LpOutcome::at_bound) refuse_what_never_falls();
    s.multiplier = found.factor * balance_.live_scale();
    s.motion = found.motion;
    s.programmes = 1;
    took(s.multiplier);
    prove(found, s);
    associated_ = found.forces;
  }
  /// \pre find_associated() has returned
  void find_coulomb() {
    CoulombSearch search(checks_, balance_, cone_, programmes_, [this](double multiplier) { took(multiplier); });
    out_.coulomb = search.find(associated_, out_.associated.multiplier);
    // Forces of Coulomb's flow are admissible for the associated one, so only round-off can put them above it.
    out_.coulomb.multiplier = std::min(out_.coulomb.multiplier, out_.associated.multiplier);
  }

 private:
  void took(double multiplier) {
    if (tick_) tick_(++programmes_taken_, multiplier);
  }
  [[nodiscard]] ModelForces on_model(const ProgrammeForces& f) const { return forces_on_model(balance_, f); }
  void prove(const ProgrammeSolution& found, LimitState& s) const {
    const ModelForces forces = on_model(found.forces);
    LimitProof& p = s.proof;
    s.ties = forces.of_ties;
    p.forces = checks_.check_forces(forces, 1.0, s.multiplier);
    p.motion = checks_.check_motion(s.motion);
    p.lower = s.multiplier;
    p.upper = (p.motion.tie_power - p.motion.dead_power) / p.motion.live_power + checks_.slack_of_bound(forces, p.motion);
    const double gap = std::abs(p.upper - p.lower) / std::max(p.lower, LimitProof::kLeast * balance_.live_scale());
    p.wide = gap > LimitProof::kGap;
    p.holds = p.forces.worst() <= LimitProof::kForces && p.motion.off_normal <= LimitProof::kMotion &&
              p.motion.stretch <= LimitProof::kMotion && p.motion.live_power > 0.0 && gap <= LimitProof::kWidest;
    if (p.holds) return;
    std::array<char, 300> text{};
    std::snprintf(
        text.data(), text.size(),
        "limit analysis: the multiplier is not proven: forces for %.6g (off by %.1g of a mean weight), a mechanism for %.6g (off by "
        "%.1g of its speed)",
        p.lower, p.forces.worst(), p.upper, p.motion.off_normal);
    throw NumericalError(text.data());
  }

  /// Without ties that yield, forces of contacts form a cone: they bear all of the dead forces or none. What they and the ties cannot bear
  /// falls by a mechanism in which the dead forces do more power than those ties take. A live force
  /// that holds up what would fall is no reason to go on.
  void refuse_what_falls() const {
    const ProgrammeSolution s = programmes_.solve({balance_.dead(), std::vector<double>(balance_.rows(), 0.0), LpGoal::most, 1.0, {}, {}});
    if (s.outcome == LpOutcome::at_bound && checks_.check_forces(on_model(s.forces), s.factor, 0.0).worst() <= LimitProof::kForces) return;
    if (s.outcome != LpOutcome::solved) throw no_proof();
    const MotionCheck m = checks_.check_motion(s.motion);
    const double least = std::max(kFalls * m.dead_terms, kCertain * std::max(m.off_normal, m.stretch) * forces_.weight);
    if (std::max(m.off_normal, m.stretch) > LimitProof::kMotion || !(m.dead_power - m.tie_power > least)) throw no_proof();
    throw cases::InputError("", "does not stand under its dead loads alone, as dry blocks with the friction of their contacts" +
                                    std::string(model_.ties.empty() ? "" : " and its ties") +
                                    ": a mechanism was found and checked in which " + fastest(s.motion) + " moves fastest");
  }
  [[noreturn]] void refuse_what_never_falls() const {
    ConeProgramme alone{balance_.live(), std::vector<double>(balance_.rows(), 0.0), LpGoal::most, 1.0, {}, {}};
    alone.ties.yielding = false;  // so that any multiple of the forces found is borne, too
    const ProgrammeSolution s = programmes_.solve(alone);
    if (s.outcome != LpOutcome::at_bound ||
        checks_.check_forces(on_model(s.forces), 0.0, balance_.live_scale()).worst() > LimitProof::kForces) {
      throw NumericalError("limit analysis: the multiplier is above " + std::to_string(kLpBound * balance_.live_scale()) +
                           ", which is beyond what is looked for");
    }
    throw NothingFalls("", "has no collapse multiplier in this direction: nothing falls, whatever the force");
  }
  static NumericalError no_proof() {
    return NumericalError(
        "limit analysis found neither forces nor a mechanism to the accuracy needed, which says nothing of the structure (it may stand by "
        "a "
        "hair); try another number of --facets or a larger segments.size, and look for blocks that are very small, or loads that are very "
        "large, beside the others");
  }
  [[nodiscard]] std::string fastest(const std::vector<kernels::Twist>& motion) const {
    std::size_t which = 0;
    double most = -1.0;
    for (std::size_t b = 0; b < motion.size(); ++b) {
      const double speed = norm(motion[b].v) + forces_.length * norm(motion[b].w);
      if (speed > most * (1.0 + 1e-9)) most = speed, which = b;
    }
    const auto e = static_cast<std::size_t>(out_.contacts.bodies[which].elements.front());
    return cases::describe(model_.blocks[e], e);
  }

  const cases::Model& model_;
  LimitResult& out_;
  Vec3 direction_;
  LimitForces forces_;
  std::optional<LimitPlane> plane_;
  FrictionCone cone_;
  Balance balance_;
  Programmes programmes_;
  LimitModel checks_;
  std::function<void(int, double)> tick_;
  int programmes_taken_ = 0;
  ProgrammeForces associated_;
};

}  // namespace

LimitResult limit_analysis(const cases::Case& c, const cases::Model& model, const LimitOptions& options) {
  if (norm(cases::gravity_on_base(c)) == 0.0) throw cases::InputError("gravity.acceleration", "is zero; limit analysis needs weights");
  if (std::ranges::all_of(model.blocks, &cases::Block::fixed)) throw cases::InputError("", "has no block that could move");
  LimitResult out;
  out.contacts = limit_contacts(model, main_direction(c, options.live));
  Analysis analysis(c, model, options, out);
  out.has_loads = std::ranges::any_of(c.loads, [](const cases::Load& l) { return !l.grows; });
  out.is_tilt = options.live.kind == LiveLoad::Kind::weight && options.live.on.empty() && options.live.direction.z == 0.0 &&
                !out.has_loads && (!c.base || (c.base->tilt[0] == 0.0 && c.base->tilt[1] == 0.0));
  analysis.find_associated();
  if (options.coulomb) analysis.find_coulomb();
  return out;
}

}  // namespace voussoir::solver
