// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "io/case_file/case_file.h"
#include "io/commands/assess/assess_command.h"
#include "io/commands/assess/assess_options.h"
#include "io/commands/assess/limit_command.h"
#include "io/commands/bench_command.h"
#include "io/commands/command_word.h"
#include "io/commands/compare_command.h"
#include "io/commands/modes_command.h"
#include "io/commands/motion_options.h"
#include "io/commands/number_range.h"
#include "io/commands/report_command.h"
#include "io/commands/resume_command.h"
#include "io/commands/run_command.h"
#include "io/commands/summary_command.h"
#include "io/commands/verify_command.h"
#include "io/commands/view_command.h"
#include "io/document/case_values.h"
#include "io/files/errors.h"
#include "io/manual/manual_commands.h"
#include "io/motion/motion_files.h"
#include "io/report/stills.h"
#include "io/results/provenance.h"
#include "io/session/likely_slips.h"
#include "io/session/prepared_case.h"
#include "io/session/process.h"
#include "io/session/threads.h"
#include "io/stones/stones.h"
#include "solver/world/errors.h"

namespace {

using namespace voussoir;

/// The words of the command line, before they mean anything.
struct Words {
  std::string name;                 // CASE
  std::vector<std::string> set;     // --set key=value
  std::vector<std::string> motion;  // --motion axis=file
  std::string direction, record, scale, duration, dt, frames, kernels = "fast", scatter = "colour", format = "text";
  std::vector<std::string> files;  // of `motion`
  std::string first, second;       // of `compare`
  std::string shell, man_folder;   // of `completion`, `man`
  bool verify = false, markdown = false;
  int threads = 0;  // 0: as OpenMP decides
  io::RunOptions run;
  io::BenchOptions bench;
  io::ResumeOptions resume;
  io::ReportOptions report;
  io::SummaryOptions summary;
  io::MotionOptions motion_options;
  io::CheckOptions check;
  io::ViewOptions view;
  io::ModesOptions modes;
  io::LimitCommandOptions limit;
  io::AssessOptions assess;
};

/// A path given on the command line starts at the working folder, not at the case's.
std::string from_here(const std::string& path) { return std::filesystem::absolute(path).lexically_normal().string(); }

/// A record or files on the command line take the place of those that the case names (apply_overrides).
std::vector<std::string> motion_overrides(const Words& w) {
  std::vector<std::string> given;
  const auto give = [&](const std::string& key, const std::string& value) {
    given.push_back("motion." + key + "=" + io::toml_string(value));
  };
  if (!w.direction.empty()) give("direction", w.direction);
  const bool in_folder = !io::is_built_in_record(w.record) && std::filesystem::exists(w.record);
  if (!w.record.empty()) give("record", in_folder ? from_here(w.record) : w.record);
  for (const std::string& m : w.motion) {
    const std::size_t equals = m.find('=');
    if (equals == std::string::npos || equals + 1 == m.size()) {
      throw cases::InputError("--motion", io::toml_string(m) + " is not AXIS=FILE; allowed axes: x, y, z, L, T, V");
    }
    give(m.substr(0, equals), from_here(m.substr(equals + 1)));
  }
  return given;
}

/// These options are short names of case keys: they become overrides, so the resolved case holds them.
std::vector<std::string> overrides(const Words& w) {
  std::vector<std::string> all = motion_overrides(w);
  if (!w.scale.empty()) all.push_back("motion.scale=" + w.scale);
  if (!w.duration.empty()) all.push_back("time.duration=" + w.duration);
  if (!w.dt.empty()) all.push_back("time.step=" + (w.dt == "auto" ? io::toml_string(w.dt) : w.dt));
  if (!w.frames.empty()) all.push_back("output.frame_interval=" + w.frames);
  all.insert(all.end(), w.set.begin(), w.set.end());
  return all;
}

void add_threads(CLI::App* command, int& threads) {
  command->add_option("-j,--threads", threads, "threads (default: OMP_NUM_THREADS, else all cores)")->check(CLI::Range(1, 1024));
}

void add_case(CLI::App* command, Words& w) {
  command->add_option("CASE", w.name, "a name of the catalogue (see `voussoir cases`), or the path of a .toml file")->required();
  command->add_option("--set", w.set, "override a key of the case: a.b[0].c=value (may be repeated)");
  add_threads(command, w.threads);
}

void add_checkpoints(CLI::App* command, io::CheckpointSchedule& schedule) {
  command->add_option("--checkpoint-every", schedule.wall_clock, "wall-clock between two checkpoints, s (default 300)")
      ->check(io::number_range(0.0, 1e12));
  command->add_option("--checkpoint-simulated", schedule.simulated, "simulated time between two checkpoints, s, if that comes sooner")
      ->check(io::number_range(1e-9, 1e12));
}

void add_views(CLI::App* command, io::Views& views) {
  command->add_flag("--report", views.page, "at the end write the page that `voussoir report` writes");
  command->add_option("--report-every", views.page_every, "write it while the run goes on, too: every so many s of wall-clock")
      ->check(io::number_range(1e-9, 1e12));
  command->add_flag("--paraview", views.paraview, "at the end write run.xdmf and paraview.h5 (0.3 MB a frame of a house)");
}

/// Short names of case keys (overrides()).
void add_short_keys(CLI::App* command, Words& w) {
  command->add_option("--direction", w.direction, "which of L, T, V goes to x, y, z: LTV, TLV, ...");
  command->add_option("--record", w.record, "name of a built-in record, a folder that holds record.toml, or a file that holds L, T and V");
  command->add_option("--motion", w.motion, "AXIS=FILE ...: files of ground motion, behind CASE: L=A.AT2 T=B.AT2 V=C.AT2, or x, y, z");
  command->add_option("--scale", w.scale, "factor on the motion, or [L, T, V]");
  command->add_option("--duration", w.duration, "of shaking, s");
  command->add_option("--dt", w.dt, "step in s, or auto (Eq. 19)");
  command->add_option("--frames", w.frames, "interval of frames, s");
}

void add_run(CLI::App& app, Words& w) {
  CLI::App* run = app.add_subcommand("run", "build, settle under gravity, shake, write results");
  add_case(run, w);
  run->add_option("-o,--output", w.run.folder, "folder of the results (default: results/CASE)");
  add_short_keys(run, w);
  run->add_option("--kernels", w.kernels, "fast, or reference: every segment on its own in plain code")
      ->check(CLI::IsMember({"fast", "reference"}));
  run->add_option("--scatter", w.scatter, "how forces are summed: colour by colour, or gather, by element (not the random [scatter])")
      ->check(CLI::IsMember({"colour", "gather"}));
  add_checkpoints(run, w.run.checkpoints);
  run->add_flag("--verify", w.verify, "no results: try in about a minute that threads and stops do not change a bit of this case");
  add_views(run, w.run.views);
  run->add_flag("--overwrite", w.run.overwrite, "replace the results that the folder holds");
  run->add_flag("--quiet", w.run.quiet, "no progress");
  run->footer("example: voussoir run flat20n --direction LTV --duration 6 -o results/flat20n-LTV");
}

void add_bench(CLI::App& app, Words& w) {
  CLI::App* bench = app.add_subcommand("bench", "time per step, joint and segment, and where it goes; thread scaling");
  add_case(bench, w);
  bench->add_option("--after", w.bench.after, "s of shaking before it is measured (default: 0, intact)")
      ->check(io::number_range(0.0, 1e12));
  bench
      ->add_option("--batches", w.bench.batches,
                   "a figure is the median of so many batches of steps (default: 15, up to 60 if the machine is seldom quiet)")
      ->check(CLI::Range(1, 1000));
  bench->add_option("--steps", w.bench.steps, "steps in a batch (default: about 0.1 s of them)")->check(CLI::Range(1, 1000000));
  bench->add_option("--csv", w.bench.csv, "also write the table of what a step takes to this file");
  bench->add_option("--stages-csv", w.bench.stages_csv, "also write the table of where it goes, part by part, to this file");
  bench->add_flag("--overwrite", w.bench.overwrite, "replace these files");
  bench->footer(
      "CASE may also be a checkpoint (.h5) of a run: measured as it stands there\nexample: voussoir bench flat20n -j 2 --after 3.5");
}

void add_resume(CLI::App& app, Words& w) {
  CLI::App* resume = app.add_subcommand("resume", "go on from the newest good checkpoint of DIR");
  resume->add_option("DIR", w.resume.folder, "folder of the run")->required();
  add_threads(resume, w.threads);
  resume->add_option("--until", w.resume.until, "s of shaking: go on to a later end than the case's");
  add_checkpoints(resume, w.resume.checkpoints);
  add_views(resume, w.resume.views);
  resume->add_flag("--quiet", w.resume.quiet, "no progress");
  resume->footer("example: voussoir resume results/flat20n --until 12");
}

void add_compare(CLI::App& app, Words& w) {
  CLI::App* compare =
      app.add_subcommand("compare", "are two runs the same, bit for bit (provenance apart)? If not: their measures side by side");
  compare->add_option("A", w.first, "folder of a run, or a file")->required();
  compare->add_option("B", w.second, "another")->required();
  compare->add_option("--format", w.format, "text, or json: one object")->check(CLI::IsMember({"text", "json"}));
  compare->footer("example: voussoir compare results/one results/other; exit code 0: identical, 1: different");
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& w : words) text += (text.empty() ? "" : ", ") + w;
  return text;
}

void add_report(CLI::App& app, Words& w) {
  CLI::App* report = app.add_subcommand("report", "one HTML page that shows a run: 3D replay, histories, damage, energy");
  report->add_option("DIR", w.report.folders, "folder of the run, or of two to see side by side")->required()->expected(1, 2);
  report->add_option("-o,--output", w.report.output,
                     "file of the page, or folder of the pictures (default: DIR/report.html, of two runs DIR/comparison.html; DIR/stills)");
  report->add_flag("--paraview", w.report.paraview, "write DIR/run.xdmf and DIR/paraview.h5 for ParaView instead of the page");
  report->add_option("--stills", w.report.times, "pictures at these times, s, instead of the page: T,T,... or T T ...; needs Chromium");
  report->add_option("--film", w.report.film.file, "a film instead of the page: FILE.mp4, .webm or .gif; needs Chromium and ffmpeg");
  report->add_option("--speed", w.report.film.speed, "of the film: 0.25 is four times slower than it was (default: 1)")
      ->check(io::number_range(0.001, 100.0));
  report->add_option("--rate", w.report.film.rate, "pictures a second of the film (default: 25)")->check(CLI::Range(1, 50));
  report->add_option("--view", w.report.views, "of the pictures or the film: " + joined(io::kViews) + ", or some of them (default: corner)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(io::kViews));
  report->add_option("--modes", w.report.modes, "so many mode shapes of the undamaged structure in the page, too (default: none)")
      ->check(CLI::Range(1, 50));
  report->add_flag("--overwrite", w.report.overwrite, "replace existing files");
  report->footer(
      "example: voussoir report results/flat20n --stills 1.2,2.0,2.8,4.8 --view front\n"
      "         voussoir report results/flat20n --film flat20n.mp4 --speed 0.5\n"
      "         voussoir report results/flat20n --modes 6\n"
      "         voussoir report results/flat20n results/flat20s");
}

void add_summary(CLI::App& app, Words& w) {
  CLI::App* summary = app.add_subcommand("summary", "what came out of a run: damage grade, fallen walls, debris, free volume, drift");
  summary->add_option("DIR", w.summary.folder, "folder of the run, finished or not")->required();
  summary->add_option("--format", w.format, "text, or json: one object")->check(CLI::IsMember({"text", "json"}));
  summary->footer("example: voussoir summary results/flat20n");
}

void add_check(CLI::App& app, Words& w) {
  CLI::App* check = app.add_subcommand("check", "read, build, report: counts, mass, step and what limits it, how long a run takes, faults");
  add_case(check, w);
  add_short_keys(check, w);
  check->add_option("--draw", w.check.draw, "write a drawing to this SVG file: plans of two courses and four elevations");
  check->add_flag("--overwrite", w.check.overwrite, "replace an existing drawing");
  check->add_option("--format", w.format, "text, or json: one object, with all findings")->check(CLI::IsMember({"text", "json"}));
  check->footer("example: voussoir check my-house.toml --draw my-house.svg");
}

void add_view(CLI::App& app, Words& w) {
  CLI::App* view = app.add_subcommand("view", "one HTML page of the model before any run: stones by material, joints by law, supports");
  add_case(view, w);
  view->add_option("-o,--output", w.view.output, "file of the page (default: CASE.html)");
  CLI::Option* still = view->add_option("--still", w.view.still, "a picture, FILE.png, instead of the page; needs Chromium")
                           ->excludes(view->get_option("--output"));
  view->add_option("--view", w.view.view, "of the picture: " + joined(io::kViews) + " (default: corner)")
      ->check(CLI::IsMember(io::kViews))
      ->needs(still);
  view->add_flag("--overwrite", w.view.overwrite, "replace an existing page or picture");
  view->footer("example: voussoir view my-vault.toml\n         voussoir view my-vault.toml --still my-vault.png --view front");
}

void add_modes(CLI::App& app, Words& w) {
  CLI::App* modes = app.add_subcommand("modes", "first natural frequencies: eigenvalues, and an impulse with a Fourier transform");
  add_case(modes, w);
  modes->add_option("--count", w.modes.count, "how many modes (default 6)")->check(CLI::Range(1, 200));
  modes->add_option("--shapes", w.modes.shapes, "write the mode shapes to this .vtu file for ParaView");
  modes->add_flag("--no-impulse", w.modes.no_impulse, "eigenvalues only: seconds instead of minutes");
  modes->add_flag(
      "--closed", w.modes.closed,
      "eigenvalues with joints without a bond held as if bonded, as weight holds them while the motion is small: for beams that "
      "lie loose on walls");
  modes->add_flag("--overwrite", w.modes.overwrite, "replace an existing file of shapes");
  modes->add_flag("--quiet", w.modes.quiet, "no progress");
  modes->footer("example: voussoir modes vault20n --shapes vault20n-modes.vtu");
}

void add_manual(CLI::App& app, Words& w) {
  CLI::App* completion = app.add_subcommand("completion", "print a script that lets the Tab key complete the words of this program");
  completion->add_option("SHELL", w.shell, "bash, zsh or fish")->required()->check(CLI::IsMember(io::kShells));
  completion->footer("example: source <(voussoir completion bash)");
  CLI::App* man = app.add_subcommand("man", "write the manual pages of the program and of its commands into a folder");
  man->add_option("FOLDER", w.man_folder, "made if it is missing; pages in it are replaced")->required();
  man->footer("example: voussoir man man1; man man1/voussoir-run.1");
}

/// \param view  which also shows what is refused, so it reads the stones itself
int with_case(Words& w, const std::function<int(const io::LoadedCase&)>& use, bool view = false) {
  io::LoadedCase c = io::load_case(w.name, overrides(w));
  for (const std::string& note : c.notes) std::fprintf(stderr, "voussoir: note: %s\n", note.c_str());
  io::warn_of(c.findings);
  try {
    if (!view) {
      io::load_stones(c.value);
      io::fill_own_frequency(c.value);
    }
    return use(c);
  } catch (const cases::InputError& e) {
    std::fprintf(stderr, "voussoir: %s\n", c.describe(e).c_str());
    return io::kInputFault;
  } catch (const io::NamedFileError& e) {
    std::fprintf(stderr, "voussoir: %s\n", c.describe({e.key(), std::string("cannot be used: ") + e.what()}).c_str());
    return io::kFileFault;
  }
}

int dispatch(const CLI::App& app, Words& w) {
  if (app.got_subcommand("cases")) return io::cases_command();
  if (app.got_subcommand("keys")) {
    std::fputs((w.markdown ? io::key_reference_markdown() : io::key_reference()).c_str(), stdout);
    return io::kDone;
  }
  if (app.got_subcommand("completion")) return io::completion_command(io::option_table(app), w.shell);
  if (app.got_subcommand("man")) return io::man_command(io::option_table(app), w.man_folder);
  if (app.got_subcommand("resume")) return io::resume_command(w.resume);
  if (app.got_subcommand("compare")) return io::compare_command(w.first, w.second, w.format == "json");
  if (app.got_subcommand("summary")) {
    w.summary.json = w.format == "json";
    return io::summary_command(w.summary);
  }
  if (app.got_subcommand("assess")) return io::assess_command(w.assess);
  if (app.got_subcommand("report")) return io::report_command(w.report);
  if (app.got_subcommand("motion")) return io::motion_command(w.files, w.motion_options);
  if (app.got_subcommand("check")) {
    w.check.json = w.format == "json";
    return with_case(w, [&](const auto& c) { return io::check_command(c, w.check); });
  }
  if (app.got_subcommand("view"))
    return with_case(
        w, [&](const auto& c) { return io::view_command(c, w.view); }, true);
  if (app.got_subcommand("modes")) return with_case(w, [&](const auto& c) { return io::modes_command(c, w.modes); });
  if (app.got_subcommand("limit")) {
    return with_case(w, [&](const auto& c) { return io::limit_command(c, w.limit); });
  }
  if (app.got_subcommand("bench")) {
    if (w.name.ends_with(".h5")) return io::bench_checkpoint(w.name, w.bench);
    return with_case(w, [&](const auto& c) { return io::bench_command(c, w.bench); });
  }
  w.run.reference_kernels = w.kernels == "reference";
  w.run.gather = w.scatter == "gather";
  if (w.verify) return with_case(w, [&](const auto& c) { return io::verify_command(c, w.run); });
  if (w.run.folder.empty()) w.run.folder = "results/" + std::filesystem::path(w.name).stem().string();
  return with_case(w, [&](const auto& c) { return io::run_command(c, w.run); });
}

/// Long enough to look first how busy the machine is.
bool takes_long(const CLI::App& app) {
  return std::ranges::any_of(std::array{"run", "resume", "modes", "bench"}, [&](const char* name) { return app.got_subcommand(name); });
}

}  // namespace

int main(int argc, char** argv) {
  io::prepare_process();
  CLI::App app{"Voussoir: how masonry buildings crack, fail and collapse in earthquakes"};
  app.set_version_flag("--version", "voussoir " + io::program_version());
  app.require_subcommand(1);
  app.footer("example: voussoir run flat20n --direction LTV --duration 6");
  Words w;
  add_run(app, w);
  add_resume(app, w);
  add_compare(app, w);
  add_summary(app, w);
  io::add_assess_options(*app.add_subcommand("assess", io::kAssess), w.assess);
  add_report(app, w);
  add_check(app, w);
  add_view(app, w);
  add_modes(app, w);
  CLI::App* limit = app.add_subcommand("limit", io::kLimit);
  add_case(limit, w);
  io::add_limit_options(*limit, w.limit);
  io::add_motion_options(*app.add_subcommand("motion", io::kMotion), w.files, w.motion_options);
  add_bench(app, w);
  app.add_subcommand("cases", "the catalogue, one line a case");
  app.add_subcommand("keys", "all keys of the case file")->add_flag("--markdown", w.markdown, "as tables, for a page");
  add_manual(app, w);
  try {
    if (argc > 1) io::check_command_word(app, argv[1]);
    app.parse(argc, argv);
    io::let_threads_sleep(argv, w.threads, takes_long(app));
    io::use_threads(w.threads);
    return io::code_after_output(dispatch(app, w));
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? io::kDone : io::kInputFault;
  } catch (const solver::NumericalError& e) {
    std::fprintf(stderr, "voussoir: numerical failure: %s\n", e.what());
    return io::kNumericalFailure;
  } catch (const io::FileError& e) {
    std::fprintf(stderr, "voussoir: %s\n", e.what());
    return io::kFileFault;
  } catch (const cases::InputError& e) {
    std::fprintf(stderr, "voussoir: %s\n", e.what());
    return io::kInputFault;
  } catch (const std::exception& e) {
    return io::end_unexpectedly(e);
  }
}
