// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cases/case.h"
#include "cases/census.h"
#include "cases/house/house_thickness.h"
#include "cases/model.h"
#include "cases/names.h"
#include "cases/rules/contact_rules.h"
#include "cases/walls/walls.h"
#include "geometry/nth.h"
#include "io/app/commands/command.h"
#include "io/app/commands/words/bill.h"
#include "io/app/commands/words/case_words.h"
#include "io/app/commands/words/check_json.h"
#include "io/app/commands/words/command_word.h"
#include "io/app/commands/words/common_words.h"
#include "io/app/commands/words/joint_words.h"
#include "io/app/session/exit_code.h"
#include "io/app/session/likely_slips.h"
#include "io/app/session/prepared_case.h"
#include "io/app/session/process.h"
#include "io/app/session/progress.h"
#include "io/app/session/run_extent.h"
#include "io/app/session/run_time.h"
#include "io/app/session/words/advice.h"
#include "io/app/session/words/tie_lines.h"
#include "io/input/case_file/catalogue.h"
#include "io/input/files/output_path.h"
#include "io/input/messages/messages.h"
#include "io/input/motion/motion_files.h"
#include "io/output/drawing/drawing.h"
#include "io/output/measures/capacity/capacity_file.h"
#include "io/output/replay/run_file.h"
#include "io/output/replay/run_state.h"
#include "solver/contact/head_on.h"
#include "solver/run/simulation.h"
#include "solver/setup/laws/optional_laws.h"
#include "solver/setup/setup.h"
#include "solver/world/errors.h"

namespace voussoir::io {

namespace {

struct CheckOptions {
  std::string draw;  // SVG file for a drawing; empty: none
  bool overwrite = false;
  bool json = false;
  bool bill = false;  // all of it
};

struct CheckWords {
  CaseWords c;
  CheckOptions o;
};

constexpr double kMegabyte = 1e6;

void print_parts(const cases::Census& n) {
  std::printf("\n%-24s %10s %8s %12s\n", "part", "whole", "cut", "mass [kg]");
  for (const cases::CensusGroup& g : n.groups) {
    std::printf("%-24s %10s %8s %12.1f\n", g.name.c_str(), format_count(g.whole).c_str(), format_count(g.cut).c_str(), g.mass);
  }
}

/// Prints walls of any plan whose bricks were adapted. \param title  of the first line
void print_adapted_bricks(const cases::Case& c, const char* title) {
  const auto range = [](double low, double high) {
    return cases::text(std::round(low * 1e4) * 1e-4) + (high - low < 5e-5 ? "" : " to " + cases::text(std::round(high * 1e4) * 1e-4));
  };
  for (const cases::AdaptedBricks& w : cases::adapted_bricks(c.walls, cases::spans_of(c))) {
    const std::string lost =
        w.lost > 0.0 ? "; its blocks are straight: " + cases::text(std::round(w.lost * 1e4) * 1e-2) + " % less volume than along the curve"
                     : "";
    std::printf("%s%-24s %s wall: whole ones %s m long, %s m wide, %s m high%s\n", *title == '\0' ? "" : "\n", title, w.name.c_str(),
                range(w.shortest, w.longest).c_str(), range(w.width, w.width).c_str(), range(w.lowest, w.highest).c_str(), lost.c_str());
    title = "";
  }
}

/// Prints walls whose bricks were made wider or narrower for a true thickness.
void print_adapted_walls(const cases::Case& c) {
  const char* title = "bricks adapted";
  if (!c.house) return print_adapted_bricks(c, title);
  for (const cases::AdaptedWall& w : cases::adapted_walls(*c.house)) {
    std::printf("%s%-24s %s: %d of %.4g m in place of %.4g m through %.4g m\n", *title == '\0' ? "" : "\n", title, w.name.c_str(), w.bricks,
                w.width, w.nominal_width, w.thickness);
    title = "";
  }
  print_adapted_bricks(c, title);
}

/// Prints the laws of joints as used by runs: strength of the bond, and the friction that remains without it.
void print_joint_laws(const cases::Model& m) {
  struct Row {
    std::int64_t joints = 0;
    double least = 90.0, most = 0.0;  // degrees, friction without the bond
  };
  std::vector<Row> rows(m.laws.size());
  for (std::size_t j = 0; j < m.joint_law.size(); ++j) {
    const double after = cases::friction_without_bond(m, j);
    Row& row = nth(rows, m.joint_law[j]);
    ++row.joints, row.least = std::min(row.least, after), row.most = std::max(row.most, after);
  }
  std::printf("\n%-24s %10s %13s %13s %16s %13s %15s\n", "joint law", "joints", "tension [Pa]", "cohesion [Pa]", "compression [Pa]",
              "friction [°]", "when open [°]");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].joints == 0) continue;
    const cases::JointLaw& l = m.laws[i].value;
    const bool bond = i != 0 && !l.stiffens();
    const auto figure = [&](double v) { return bond ? cases::text(v) : std::string("none"); };
    std::string after = cases::text(rows[i].least);
    if (rows[i].most > rows[i].least) after += " to " + cases::text(rows[i].most);
    std::printf("%-24s %10s %13s %13s %16s %12s %14s\n", m.laws[i].name.c_str(), format_count(rows[i].joints).c_str(),
                figure(l.tension).c_str(), figure(l.cohesion).c_str(), figure(l.compression).c_str(), figure(l.friction).c_str(),
                after.c_str());
  }
}

/// What optional laws do, those that some joint has.
void print_optional_laws(const cases::Case& c, const cases::Model& m) {
  const char* gap = "\n";
  for (const solver::OptionalLaw& law : solver::optional_laws()) {
    for (const std::string& line : law.words(c, m)) std::printf("%s%-24s %s\n", gap, law.name, line.c_str()), gap = "";
  }
}

/// One friction for all pairs of materials, and those that have their own.
void print_friction(const cases::Contact& c) {
  std::printf("\nfriction of contacts     %s degrees", cases::text(c.friction).c_str());
  for (const cases::ContactRule& r : c.between) {
    std::printf("; %s on %s %s", r.materials[0].c_str(), r.materials[1].c_str(), cases::text(r.friction).c_str());
  }
  std::printf("\n");
}

/// What impacts of free bodies give back: the given share, or that of the dashpots at this step for an example.
void print_restitution(const cases::Census& n, const cases::Model& m, const solver::World& w) {
  const auto e = static_cast<std::size_t>(n.step_element);
  const double given = w.contact.restitution, most = solver::kImpactShare * n.step_bound;
  if (given == 0.0) {
    std::printf("restitution              %.2f by the dashpots at this step, where %s and its like meet with face %d\n",
                solver::restitution_of(solver::head_on(w, n.step_element, n.step_face)), cases::describe(m.blocks[e], e).c_str(),
                n.step_face);
    return;
  }
  std::printf("restitution              %s of free bodies; for it \"auto\" takes steps of %s of the bound%s\n", cases::text(given).c_str(),
              cases::text(solver::kImpactShare).c_str(), w.dt > most ? ", this one is longer: less exact" : "");
}

void print_step(const cases::Census& n, const cases::Model& m, const solver::World& w) {
  if (n.step_element < 0) return;
  const double dt = w.dt;
  const auto e = static_cast<std::size_t>(n.step_element);
  std::printf("\nlargest stable step      %.4g s, from face %d of %s\n", n.step_bound, n.step_face,
              cases::describe(m.blocks[e], e).c_str());
  std::printf("step                     %.4g s%s\n", dt, dt > n.step_bound ? ", more than that: the run may diverge" : "");
  print_restitution(n, m, w);
  const solver::Multirate& rates = w.multirate;
  if (rates.wanted == 1) return;
  const auto elements = std::span(rates.of_joints).first(static_cast<std::size_t>(n.elements));
  for (std::size_t level = 0; level < rates.every.size(); ++level) {
    const std::string steps = level == 0 ? "every step" : "one step of " + std::to_string(rates.every[level]);
    std::printf("%-25s%s of %s elements in %s\n", level == 0 ? "rates" : "",
                format_count(std::ranges::count(elements, static_cast<std::uint8_t>(level))).c_str(), format_count(n.elements).c_str(),
                steps.c_str());
  }
}

/// Memory of a run [bytes], about.
double memory_needs(const cases::Census& n) {
  return 3e3 * static_cast<double>(n.elements) + 400.0 * static_cast<double>(n.joints + n.base_joints) +
         35.0 * static_cast<double>(n.joint_sides);
}

/// Prints what another number of rates would save. \param times  by rate, at least one
void print_rates(std::vector<RateTime> times, const RunTime& own) {
  const auto best = std::ranges::min_element(times, {}, [](const RateTime& t) { return t.time.collapse; });
  if (best->time.collapse > 0.9 * own.collapse) {
    std::printf("                         no other time.multirate would save a tenth of that\n");
    return;
  }
  std::printf("with time.multirate = %d  %s if nothing breaks (%.2f of the above), some %s if it collapses (%.2f)\n", best->multirate,
              format_duration(best->time.intact).c_str(), best->time.intact / own.intact, format_duration(best->time.collapse).c_str(),
              best->time.collapse / own.collapse);
}

/// Prints the estimated time of a time history, or of an analysis by dynamics, and at other rates where that is worth a word. \param sim
/// ends here: other rates need its memory \throw solver::NumericalError
void print_run_time(const cases::Case& c, const cases::Model& model, const cases::GroundMotion& motion,
                    std::unique_ptr<solver::Simulation> sim) {
  const solver::Options options = sim->world().options;
  const double step = shaken_step(c, *sim), one_rate = one_rate_step(c, model, motion, *sim, step);
  const RunTime own = run_time(c, *sim, step, one_rate);
  std::printf("\nestimate, %d threads      %s if nothing breaks, some %s if it collapses (steps were timed on this machine)\n",
              sim->threads(), format_duration(own.intact).c_str(), format_duration(own.collapse).c_str());
  if (is_assessment(c.analysis))
    std::printf("                         for all %s s of analysis.longest; most analyses end in a tenth of it\n",
                cases::text(c.end()).c_str());
  std::fflush(stdout);
  if (own.collapse < kWorthAdvice) return;
  sim.reset();
  give_memory_back();
  std::vector<RateTime> rates = other_rates(c, model, motion, options, one_rate);
  if (!rates.empty()) print_rates(std::move(rates), own);
}

/// Prints the estimated time of a run. \return whether the first steps succeed
bool print_estimate(const cases::Case& c, const cases::Model& model, const cases::GroundMotion& motion,
                    std::unique_ptr<solver::Simulation> sim) {
  bool sound = true;
  const cases::Census n = cases::census(model);
  const double memory = memory_needs(n);
  try {
    if (cases::finds_rest(c.analysis)) {
      const double usual = rest_time(c.analysis, *sim);
      std::printf("\nestimate, %d threads      some %s, %.0f times that where much breaks (steps were timed on this machine)\n",
                  sim->threads(), format_duration(usual).c_str(), kMuchBreaks);
      std::printf("memory                   about %.0f MB\n", memory / kMegabyte);
      return true;
    }
    print_run_time(c, model, motion, std::move(sim));
  } catch (const solver::NumericalError& e) {
    std::printf("\nestimate                 none: the first steps go wrong (%s)\n", e.what());
    sound = false;
  }
  const DiskNeeds disk = disk_needs(c, n);
  std::printf("memory, disk             about %.0f MB, %.0f MB (a frame every %s s) and %.0f MB of checkpoints\n", memory / kMegabyte,
              disk.results / kMegabyte, cases::text(cases::frame_interval(c, static_cast<std::size_t>(n.elements))).c_str(),
              disk.checkpoints / kMegabyte);
  return sound;
}

/// Prints the contents of stone files, and changes made to them.
void print_stones(const cases::Case& c) {
  for (const cases::StonesSpec& spec : c.stones) {
    const auto fixed = std::count_if(spec.stones.begin(), spec.stones.end(), [](const cases::Stone& s) { return s.fixed; });
    const auto changed = std::count_if(spec.stones.begin(), spec.stones.end(), [](const cases::Stone& s) { return !s.change.empty(); });
    std::printf("\nstones of %s: %s, %s of them fixed, %s changed (in %s)\n", spec.file.c_str(),
                format_count(static_cast<std::int64_t>(spec.stones.size())).c_str(), format_count(fixed).c_str(),
                format_count(changed).c_str(), spec.unit.c_str());
    for (const std::string& note : spec.notes) std::printf("  %s\n", note.c_str());
    for (const cases::Stone& s : spec.stones) {
      if (!s.change.empty()) std::printf("  %-22s %s\n", s.name.c_str(), s.change.c_str());
    }
  }
}

/// Prints the motion, or the analysis that does not use it.
void print_loading(const cases::Case& c, const cases::GroundMotion& motion) {
  if (is_assessment(c.analysis))
    std::printf("\nanalysis                 %s%s\n", name_of(c.analysis.kind), c.motion ? "; [motion] is left out" : "");
  else
    std::printf("\n%s", c.motion ? motion_lines(c, motion).c_str() : "motion                   none\n");
}

/// All findings: of values, of the model and of the motion.
std::vector<std::string> findings_of(const LoadedCase& c, const cases::Model& model, const cases::GroundMotion& motion) {
  const std::vector<std::string> slips = likely_slips(c, model, motion);
  warn_of(slips);  // findings of values were printed when the case was read
  std::vector<std::string> all = c.findings;
  all.insert(all.end(), slips.begin(), slips.end());
  return all;
}

int check_as_json(const LoadedCase& c, const cases::Model& model, const cases::GroundMotion& motion, solver::Simulation& sim) {
  CheckFigures f{cases::census(model), sim.dt(), {}, {}, findings_of(c, model, motion)};
  try {
    if (cases::finds_rest(c.value.analysis)) {
      f.run_seconds = rest_time(c.value.analysis, sim);
    } else {
      const double step = shaken_step(c.value, sim);
      f.run_seconds = run_time(c.value, sim, step, one_rate_step(c.value, model, motion, sim, step)).intact;
    }
  } catch (const solver::NumericalError& e) {
    f.faults = {std::string("the first steps go wrong: ") + e.what()};
  }
  std::printf("%s\n", check_json(c.value, model, f).c_str());
  if (says_json() && !f.faults.empty()) say_error(kInputFault, {.text = f.faults.front()});
  return f.faults.empty() ? kDone : kInputFault;
}

/// Reads, builds and reports, without a run. \throw cases::InputError, FileError
int check(const LoadedCase& c, const CheckOptions& o, int threads) {
  const Output drawing{o.draw, FileKind::drawing, "--draw", o.overwrite};
  check_output(drawing);
  const cases::Model model = prepared_model(c.value, threads);
  const cases::GroundMotion motion = ground_motion(c.value);
  solver::Options options;
  options.threads = threads;
  auto sim = std::make_unique<solver::Simulation>(c.value, model, motion, options);
  give_memory_back();
  refuse_endless(c.value, model, *sim);
  if (o.json) {
    if (!o.draw.empty()) write_output(drawing, draw(c.value, model));
    return check_as_json(c, model, motion, *sim);
  }
  const cases::Census n = cases::census(model);
  std::printf("%s\n\n", c.value.title.c_str());
  std::printf("elements                 %s\n", format_count(n.elements).c_str());
  if (n.units > 0)
    std::printf("units in cells           %s, of %s cells with %s joints between them\n", format_count(n.units).c_str(),
                format_count(n.cells).c_str(), format_count(n.cell_joints).c_str());
  std::printf("joints                   %s, and %s with the base; in %s of them both faces share their contact points\n",
              format_count(n.joints).c_str(), format_count(n.base_joints).c_str(), format_count(n.merged_joints).c_str());
  std::printf("contact points of joints %s, and %s of free faces\n", format_count(n.joint_sides).c_str(),
              format_count(n.free_segments).c_str());
  std::printf("volume, mass             %.4f m3, %.1f kg\n", n.volume, n.mass);
  print_stones(c.value);
  print_levers(c.value, model);
  print_torsion(c.value, model);
  print_ties(model);
  print_bounded_ties(sim->world().ties, model);
  print_step(n, model, sim->world());
  print_joint_laws(model);
  print_optional_laws(c.value, model);
  print_friction(c.value.contact);
  print_loading(c.value, motion);
  print_parts(n);
  std::printf("%s", bill_words(n, model, o.bill).c_str());
  print_adapted_walls(c.value);
  print_tie_bill(model);
  std::fflush(stdout);  // the steps of the estimate take a while
  const bool sound = print_estimate(c.value, model, motion, std::move(sim));
  if (!o.draw.empty()) {
    write_output(drawing, draw(c.value, model));
    std::printf("\ndrawing                  %s\n", o.draw.c_str());
  }
  const std::size_t findings = findings_of(c, model, motion).size();
  if (!sound) std::printf("\na fault: the first steps go wrong, see estimate\n");
  if (findings > 0)
    std::printf("\nwarnings: %zu (on standard error)%s\n", findings,
                sound ? "; nothing else found, but each of them is likely a slip" : "");
  else if (sound)
    std::printf("\nno faults found\n");
  return sound ? kDone : kInputFault;
}

/// Whether the word is the folder of a run, or its run.h5.
bool is_run(const std::string& word) {
  std::error_code error;
  return word.ends_with(".h5") || std::filesystem::exists(word + "/run.h5", error);
}

/// Checks every byte of the results of a run. \throw FileError
int check_results(const std::string& run, bool json) {
  const std::size_t files = check_run(run);
  if (json)
    std::printf("{ \"files\": %zu }\n", files);
  else
    std::printf("results are as they were written: %zu %s\n", files, files == 1 ? "file" : "files");
  note_state(open_run(run));
  return kDone;
}

}  // namespace

Command add_check(CLI::App& program) {
  CLI::App* words =
      program.add_subcommand("check", "read, build, report: counts, mass, step and what limits it, how long a run takes, faults");
  auto w = std::make_shared<CheckWords>();
  add_case(*words, w->c);
  add_short_keys(*words, w->c);
  words->add_option("--draw", w->o.draw,
                    "write a drawing to this SVG file: four elevations, and plans of two courses or through all openings");
  words->add_flag("--overwrite", w->o.overwrite, "replace an existing drawing");
  words->add_flag("--bill", w->o.bill, "the whole bill of blocks, not only the kinds with most volume");
  add_format(*words, w->o.json);
  words->footer("example: voussoir check my-house.toml --draw my-house.svg");
  return {.words = words,
          .work =
              [w, words] {
                if (!is_run(w->c.name)) return with_case(w->c, [w](const auto& c) { return check(c, w->o, w->c.threads); });
                refuse_options(*words, {"--format"},
                               "goes with a case; " + w->c.name + " is the folder of a run, whose files check only verifies");
                return check_results(w->c.name, w->o.json);
              },
          .threads = &w->c.threads};
}

}  // namespace voussoir::io
