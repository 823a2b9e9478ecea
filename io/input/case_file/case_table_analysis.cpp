// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "cases/case.h"
#include "io/input/case_file/case_tables.h"
#include "io/input/case_file/usual_ranges.h"
#include "io/input/motion/spectra/target_file.h"

namespace voussoir::io {
namespace {

using namespace cases;

/// Checks keys against the kind of the analysis. Default values are accepted, since a resolved case has every key.
void check_own_keys(const Analysis& s, const RuleCheck& check) {
  const Analysis plain;
  const auto only = [&](const char* key, bool said, bool goes, const char* with) {
    if (said && !goes) check.fault(key, std::string("goes only with ") + with);
  };
  const AnalysisKind kind = s.kind;
  const bool grows = kind == AnalysisKind::pushover || kind == AnalysisKind::tilt, pushed = grows || kind == AnalysisKind::cyclic;
  const bool cyclic = kind == AnalysisKind::cyclic, slow = is_assessment(s);
  const char *to_push = "kind = \"pushover\", \"tilt\" or \"cyclic\"", *to_grow = "kind = \"pushover\" or \"tilt\"",
             *to_and_fro = "kind = \"cyclic\"", *any_slow = "a kind other than \"time-history\"";
  only("pattern", s.pattern != plain.pattern, kind == AnalysisKind::pushover, "kind = \"pushover\"");
  only("direction", s.direction != plain.direction, slow, any_slow);
  only("eccentricity", s.eccentricity != 0.0, has_push_shape(s), "kind = \"pushover\" and a pattern other than \"given\"");
  only("demand", !s.demand.empty(), kind == AnalysisKind::pushover, "kind = \"pushover\"");
  only("demand_damping", s.demand_damping != plain.demand_damping, !s.demand.empty(), "demand");
  if (const std::string fault = eurocode8_fault(s.demand); !s.demand.empty() && !fault.empty()) check.fault("demand", fault);
  only("share", s.share.has_value(), pushed, to_push);
  only("drop", s.drop != plain.drop, grows, to_grow);
  only("largest_factor", s.largest_factor != plain.largest_factor, grows, to_grow);
  only("largest_drift", s.largest_drift != plain.largest_drift, grows, to_grow);
  only("amplitudes", !s.amplitudes.empty(), cyclic, to_and_fro);
  only("cycles", s.cycles != plain.cycles, cyclic, to_and_fro);
  const bool by_loads = cyclic || (kind == AnalysisKind::pushover && s.pattern == LoadPattern::given);
  only("level", s.level != plain.level, by_loads, "kind = \"cyclic\", or \"pushover\" and pattern = \"given\"");
  only("control", s.control || !s.control_name.empty(), slow, any_slow);
  only("pace", s.pace.has_value(), slow, any_slow);
  only("damping", s.damping.has_value(), slow, any_slow);
  only("longest", s.longest != plain.longest, slow, any_slow);
  const bool at_rest = finds_rest(s);
  only("solver", s.solver == Solver::equilibrium, slow, any_slow);
  only("tolerance", s.tolerance != plain.tolerance, at_rest, "solver = \"equilibrium\"");
  only("path_step", s.path_step != plain.path_step, at_rest, "solver = \"equilibrium\"");
  only("pace", s.pace.has_value() && at_rest, false, "solver = \"dynamics\": states of rest have no rate");
  only("damping", s.damping.has_value() && at_rest, false, "solver = \"dynamics\": states of rest have no damping");
  if (std::hypot(s.direction[0], s.direction[1]) < kShortestVector) check.fault("direction", "has no direction");
  if (kind == AnalysisKind::cyclic && s.amplitudes.empty()) check.fault("amplitudes", "is missing: give those of the cycles (m, > 0)");
  if (std::ranges::any_of(s.amplitudes, [](double a) { return a <= 0.0; })) check.fault("amplitudes", "must all be > 0 (m)");
}

/// Key `control`: a point, or the name of what it is on top of.
Key<Analysis> control_key() {
  Key<Analysis> key = value<Analysis>(
      "control", &Analysis::control, "m", any().possibly(0.0, usual::kFarthest),
      "the control point, whose displacement is that of the capacity curve: the element whose centroid is nearest to a point; or, of a "
      "block, a stone or a part of the house by its name, as \"front wall, storey 2\", the element on top nearest to the axis of its "
      "centre of mass; none: the same of the whole model; where vertical loads grow, the loaded one");
  key.info.shape = "an array [x, y, z] or a name in quotes", key.info.types.push_back({"string", {}});
  key.read = [info = key.info](const Node& node, Analysis& a, Reading& reading, const std::string& path) {
    if (const auto* name = node.as<std::string>()) {
      a.control.reset(), a.control_name = *name;
      if (name->empty()) reading.bad_value(node, path, info, "must be a point [x, y, z] (m) or the name of a block or part");
    } else {
      a.control_name.clear();
      read_value(node, a.control, info, reading, path);
    }
  };
  key.text = [](const Analysis& a) { return a.control_name.empty() ? value_text(a.control) : value_text(a.control_name); };
  return key;
}

}  // namespace

Table<Analysis> analysis_table() {
  using S = Analysis;
  return {
      "what the run finds out: what an earthquake does, or a capacity by slow loading",
      {choice<S, AnalysisKind S::*, AnalysisKind>(
           "kind", &S::kind, "",
           {{"time-history", AnalysisKind::time_history},
            {"pushover", AnalysisKind::pushover},
            {"tilt", AnalysisKind::tilt},
            {"settlement", AnalysisKind::settlement},
            {"cyclic", AnalysisKind::cyclic},
            {"rest", AnalysisKind::rest}},
           "time-history: [motion] shakes; pushover: lateral forces grow; tilt: gravity turns; settlement: supports move by their "
           "[block.motion], [stones.motion], or that of a [[base.part]]; cyclic: the loads that grow push to and fro; rest: does it stand? "
           "Weights act first, then the loads that grow and the movements of supports increase together to their full values. All but the "
           "first go slowly and leave [motion] out"),
       choice<S, std::optional<Solver> S::*, Solver>(
           "solver", &S::solver, "", {{"dynamics", Solver::dynamics}, {"equilibrium", Solver::equilibrium}},
           "of all kinds but time-history. equilibrium: each row is a state of rest, found by relaxation, and the run's time counts "
           "iterations; dynamics: the structure moves slowly, so the result depends on the pace; none: equilibrium, but dynamics where "
           "pace or damping is given"),
       choice<S, LoadPattern S::*, LoadPattern>(
           "pattern", &S::pattern, "",
           {{"mass", LoadPattern::mass},
            {"mode", LoadPattern::mode},
            {"given", LoadPattern::given},
            {"triangular", LoadPattern::triangular}},
           "pushover: forces as the masses, as the masses times the mode with most mass in `direction`, the [[load]]s that grow, or as the "
           "masses times their height above the base"),
       value<S>("direction", &S::direction, "", any(),
                "x and y of the push (where gravity turns to); of any length, -x pushes back. Where vertical loads grow, displacements are "
                "measured along them"),
       value<S>("eccentricity", &S::eccentricity, "", within(-0.5, 0.5).usually(usual::kEccentricity),
                "pushover: shift of the resultant across the push, over the width of the plan there; above zero: to the left of the push. "
                "EN 1998-1, 4.3.2: 0.05 and -0.05"),
       control_key(),
       value<S>("drop", &S::drop, "", inside(0.0, 1.0),
                "the run ends when the base shear (tilt: the multiplier) has lost this share of its largest value"),
       value<S>(
           "share", &S::share, "", above(0.0).possibly(1e-6, 1e6),
           "stiffness of the loading spring over the initial one of the structure: displacement control begins where the tangent of the "
           "structure falls below that of the spring; none: 0.5, cyclic: 5"),
       value<S>("pace", &S::pace, "s", above(0.0).usually(usual::kDuration),
                "time in which the displacement grows e-fold; none: 20 first periods, 2 s at least. Twice the pace is half the rate"),
       value<S>("damping", &S::damping, "1/s", at_least(0.0).usually(usual::kDecay),
                "mass damping, of rotations too; none: a tenth of critical at the first frequency, less where it would bear 0.2 % of the "
                "weight"),
       value<S>("longest", &S::longest, "s", within(0.0, kLongestRun),
                "the run ends then at the latest, after settling; in place of time.duration"),
       value<S>("largest_factor", &S::largest_factor, "", above(0.0).possibly(1e-9, 1e9),
                "the run ends when the load factor (tangent of the tilt) gets there"),
       value<S>("largest_drift", &S::largest_drift, "", above(0.0).possibly(1e-9, 1e6),
                "the run ends when the control point has moved by this share of its height in `direction` (above the base; without one, "
                "above the lowest corner)"),
       value<S>("amplitudes", &S::amplitudes, "m", any().usually(usual::kAmplitude),
                "cyclic: of the displacement of the loads that grow, one after another"),
       value<S>("cycles", &S::cycles, "", within(1.0, 1000.0), "cyclic: at each amplitude"),
       value<S>(
           "demand", &S::demand, "", any(),
           "pushover: the spectrum that the capacity is compared with, of EN 1998-1: \"ec8:TYPE:GROUND:AG\", as \"ec8:1:B:0.25g\"; other "
           "spectra: `voussoir assess --demand`"),
       value<S>("demand_damping", &S::demand_damping, "", within(0.0, 0.5), "of critical, of the spectrum of demand"),
       value<S>(
           "tolerance", &S::tolerance, "", inside(0.0, 1.0),
           "equilibrium: largest unbalanced force over the mean weight of an element (or moment, over that and the element's radius) of "
           "a state of rest"),
       value<S>("path_step", &S::path_step, "", inside(0.0, 1.0),
                "equilibrium: change of the load factor from one state to the next, of the largest so far; more where nothing breaks"),
       value<S>("level", &S::level, "", any(),
               "blocks with a load that grows do not turn (the top is held level): cyclic, and pushover with pattern = \"given\"")},
      check_own_keys};
}

namespace {

/// Calls use(motion, path) for the motions of all supports.
template <class Use>
void each_motion(const Case& c, Use use) {
  const auto all = [&](const auto& supports, const std::string& table) {
    for (std::size_t i = 0; i < supports.size(); ++i)
      if (supports[i].motion) use(*supports[i].motion, path_to(table, i) + ".motion.");
  };
  all(c.blocks, "block"), all(c.stones, "stones");
  if (c.base) all(c.base->parts, "base.part");
}

/// An end says no time, and `rest` needs an end.
void check_motions(const Case& c, const RuleCheck& check) {
  each_motion(c, [&](const SupportMotion& m, const std::string& path) {
    if ((m.to || m.turn) && !follows_supports(c.analysis))
      check.fault(path + (m.to ? "to" : "turn"),
                  "needs analysis.kind = \"settlement\" or \"rest\"; else give velocity or file, which say when");
    if (m.velocity && c.analysis.kind == AnalysisKind::rest)
      check.fault(path + "velocity", "has no end; with analysis.kind = \"rest\" give to (m) or file in its place");
  });
}

/// States of rest know of no time, and neither may what acts on them.
void check_time(const Case& c, const RuleCheck& check) {
  const char* why = "has no meaning with analysis.solver = \"equilibrium\", which has no time; solver = \"dynamics\" has";
  for (std::size_t i = 0; i < c.loads.size(); ++i) {
    if (c.loads[i].history) check.fault(path_to("load", i) + ".history", why);
    if (c.loads[i].path) check.fault(path_to("load", i) + ".path", why);
    if (c.loads[i].ramp != Load{}.ramp) check.fault(path_to("load", i) + ".ramp", why);
  }
  for (std::size_t i = 0; i < c.blocks.size(); ++i) {
    if (c.blocks[i].velocity != Vec3{}) check.fault(path_to("block", i) + ".velocity", why);
    if (c.blocks[i].angular_velocity != Vec3{}) check.fault(path_to("block", i) + ".angular_velocity", why);
  }
}

}  // namespace

void check_analysis(const Case& c, const RuleCheck& check) {
  const Analysis& a = c.analysis;
  check_motions(c, check);
  if (!is_assessment(a)) {
    for (std::size_t i = 0; i < c.loads.size(); ++i) {
      if (c.loads[i].grows)
        check.fault(path_to("load", i) + ".grows",
                    "needs [analysis] with kind = \"cyclic\" or \"rest\", or \"pushover\" and pattern = \"given\"");
    }
    return;
  }
  const bool grow = std::ranges::any_of(c.loads, &Load::grows);
  const bool given = a.kind == AnalysisKind::cyclic || (a.kind == AnalysisKind::pushover && a.pattern == LoadPattern::given);
  if (given && !grow)
    check.fault(a.kind == AnalysisKind::cyclic ? "analysis.kind" : "analysis.pattern", "needs a [[load]] with grows = true");
  if (!given && grow && a.kind != AnalysisKind::rest) check.fault("analysis.kind", "has no use for a [[load]] with grows = true");
  bool moves = false;
  each_motion(c, [&](const SupportMotion&, const std::string&) { moves = true; });
  if (a.kind == AnalysisKind::settlement && !moves)
    check.fault("analysis.kind", "needs a motion of a fixed block, of fixed stones or of a [[base.part]]");
  if (a.kind == AnalysisKind::rest && !finds_rest(a))
    check.fault("analysis.kind", "= \"rest\" is found by analysis.solver = \"equilibrium\"; leave out solver, pace and damping");
  if (finds_rest(a)) check_time(c, check);
  const bool by_weight = a.kind == AnalysisKind::tilt || (a.kind == AnalysisKind::pushover && !given);
  if (by_weight && norm(c.gravity.acceleration) == 0.0)
    check.fault("analysis.kind", "needs gravity: its load factor is a share of the weight");
  for (std::size_t i = 0; i < c.loads.size(); ++i) {
    if (!c.loads[i].grows || c.loads[i].force != Vec3{}) continue;
    if (c.loads[i].moment == Vec3{}) check.fault(path_to("load", i), "grows from nothing: give it a force (N) or a moment (N m)");
    if (a.level)
      check.fault("analysis.level", "keeps loaded blocks from turning; load[" + std::to_string(i) + "] is a moment without force");
  }
}

}  // namespace voussoir::io
