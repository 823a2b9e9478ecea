// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <sstream>
#include <string>

#include "cases/case.h"
#include "cases/names.h"
#include "geometry/message.h"
#include "io/app/commands/command.h"
#include "io/app/commands/words/common_words.h"
#include "io/app/session/exit_code.h"
#include "io/app/session/process.h"
#include "io/app/session/restored_run.h"
#include "io/app/session/run_extent.h"
#include "io/app/session/session.h"
#include "io/app/session/views.h"
#include "io/input/case_file/case_file.h"
#include "io/input/files/run_folder.h"
#include "io/input/messages/messages.h"
#include "io/output/replay/run_file.h"
#include "io/output/results/base_motion.h"
#include "io/output/results/case_of_run.h"
#include "io/output/results/checkpoints.h"
#include "io/output/results/results_parts.h"

namespace voussoir::io {

namespace {

struct ResumeOptions {
  std::string folder;           // of the run
  std::optional<double> until;  // s of shaking; absent: the end of the earlier run
  int threads = 0;              // 0: the default of OpenMP
  bool quiet = false;
  CheckpointSchedule checkpoints;
  Views views;  // written at the end
};

namespace fs = std::filesystem;

struct Found {
  std::string path;
  Checkpoint checkpoint;
};

Found newest_good(const std::string& folder) {
  const std::vector<std::string> paths = checkpoint_files(folder);
  std::string faults;
  for (const std::string& path : paths) {
    try {
      Found found{path, read_checkpoint(path)};
      if (!faults.empty()) say_warning(faults + "; going on from " + path);
      return found;
    } catch (const DamagedFile& e) {
      faults += (faults.empty() ? "" : "; ") + std::string(e.what());
    }
  }
  if (!faults.empty()) throw FileError(folder, "holds no checkpoint that is whole (" + faults + "); the case must be run anew");
  if (fs::exists(folder + "/checkpoint-failed.h5"))
    throw FileError(folder, "holds a numerical failure only; run the case anew with what the failure's message said");
  throw FileError(folder,
                  "holds no checkpoint: nothing to go on from; run the case anew ('voussoir run CASE -o " + folder + " --overwrite')");
}

/// The first line in which two texts differ, as "'a' there, 'b' here"; empty if they are equal.
std::string difference(const std::string& there, const std::string& here) {
  std::istringstream a(there), b(here);
  for (std::string p, q;;) {
    const bool more_a = static_cast<bool>(std::getline(a, p)), more_b = static_cast<bool>(std::getline(b, q));
    if (!more_a && !more_b) return {};
    if (p != q || more_a != more_b) return "'" + (more_a ? p : "the end") + "' there, '" + (more_b ? q : "the end") + "' in the checkpoint";
  }
}

/// The first difference of two cases, except for their ends.
std::string difference(const cases::Case& there, cases::Case here) {
  here.set_end(there.end());
  here.time.after_collapse = there.time.after_collapse;
  return difference(resolved_toml(there), resolved_toml(here));
}

/// Checks that a folder's case.toml is that of the checkpoint. Only the end may differ, and is adopted: a resume with --until may have been
/// killed before its first checkpoint.
void take_end(const std::string& folder, const Found& found, cases::Case& saved) {
  const std::string path = folder + "/case.toml";
  if (!fs::exists(path)) return;
  const cases::Case there = load_case(path).value;
  const std::string what = difference(there, saved);
  if (!what.empty()) throw FileError(path, "is not the case of " + found.path + ": " + what + "; a changed case must be run anew");
  if (there.end() > found.checkpoint.facts.time) saved.set_end(there.end()), saved.time.after_collapse = there.time.after_collapse;
}

/// Checks that the results in run.h5 are of the same case as the checkpoint.
void check_results(const std::string& run, const Found& found, const cases::Case& saved) {
  const std::string what = difference(case_of_run(open_run(run)), saved);
  if (!what.empty()) throw FileError(run, "is not of the case of " + found.path + ": " + what + "; results of two runs do not go together");
}

/// Progress recorded in the results.
struct Extent {
  bool finished = false, merged = false;
  double end = 0.0;  // s
};
Extent extent_of(const std::string& run) {
  const Hdf5File file = open_run(run);
  if (!file.exists("/summary") || file.attribute_int("/summary", "finished") == 0) return {};
  return {.finished = true, .merged = file.attribute_int("/", "parts") == 0, .end = file.attribute_double("/summary", "end_time")};
}

/// Sets the new end of the run, whether or not the building has collapsed; a collapse may have ended the earlier run before its duration.
void set_end(cases::Case& c, const std::optional<double>& until, double time, const Extent& there) {
  if (!until) return;
  if (!(*until <= cases::kLongestRun))
    throw cases::InputError("--until", "= " + cases::text(*until) + " s; allowed: at most " + cases::text(cases::kLongestRun) + " s");
  const double own_end = there.finished && c.time.after_collapse ? there.end : std::max(time, c.end());
  if (*until <= time || *until < own_end) {
    throw cases::InputError("--until", "= " + cases::text(*until) + " s has passed or is before the run's own end; allowed: more than " +
                                           cases::text(own_end) + " s");
  }
  c.set_end(*until);
  c.time.after_collapse.reset();
}

/// Continues from the newest intact checkpoint; later rows of the results are dropped and computed again, to the same bits.
/// \return as `run`; kDone at once if the run is finished and `until` absent
/// \throw FileError if no checkpoint is intact, or if case, layout, physics or model differ from those of the checkpoint; the message names
/// the difference. cases::InputError for an `until` in the past
int resume(const ResumeOptions& o) {
  const RunFolder folder = RunFolder::open(o.folder);
  const std::string run = folder.file("run.h5");
  now_doing("reading the checkpoint");
  Found found = newest_good(folder.path());
  if (!fs::exists(run)) throw FileError(run, "is missing: there are no results to go on with");
  cases::Case c = read_case({found.path, found.checkpoint.facts.case_toml, folder.path()}).value;
  take_end(folder.path(), found, c);
  check_results(run, found, c);
  const Extent there = extent_of(run);
  if (!o.until && there.finished && there.merged) {
    remove_parts(folder.path(), {});  // a kill at the very end leaves some, whose rows are in run.h5
    std::printf("%s is finished, to %.3f s; --until T goes on\n", folder.path().c_str(), there.end);
    write_views(folder.path(), o.views);
    return kDone;
  }
  set_end(c, o.until, found.checkpoint.facts.time, there);

  solver::Options options;
  options.threads = o.threads, options.own_pace = true;
  const std::unique_ptr<RestoredRun> r = restore_run(found.path, std::move(found.checkpoint), std::move(c), options);
  refuse_endless(r->value, r->model, *r->sim);

  const std::string resolved = resolved_toml(r->value);
  ResultsOptions keep;
  keep.cuts = cut_names(r->value);
  keep.earlier = {.until = std::nextafter(r->facts.time, -INFINITY), .rows = r->facts.rows};
  keep.motion = motion_datasets(r->value, r->facts.motion, r->sim->dt(), r->sim->cycle());
  std::ranges::move(load_datasets(r->value, r->sim->world().model), std::back_inserter(keep.motion));
  ResultsWriter results(folder.path(), r->model, resolved, history_names(r->value), provenance(r->sim->threads()), keep);
  cases::forget_joints(r->model);
  give_memory_back();
  folder.write_case(resolved);  // after the results are known to be intact
  Checkpoints checkpoints(folder.path(), facts_of(*r->sim, resolved, r->facts.motion, r->facts.reference_kernels), o.checkpoints, r->path);
  if (!o.quiet) say_info("going on from " + r->path + geometry::printed(", at %.4f s", r->facts.time));
  const int code = run_session(r->value, std::move(r->sim), r->plan, results, checkpoints, folder.path(), o.quiet, o.views.page_every);
  if (code == kDone) write_views(folder.path(), o.views);
  return code;
}

}  // namespace

Command add_resume(CLI::App& program) {
  CLI::App* words = program.add_subcommand("resume", "go on from the newest good checkpoint of DIR");
  auto o = std::make_shared<ResumeOptions>();
  words->add_option("DIR", o->folder, "folder of the run")->required();
  add_threads(*words, o->threads);
  words->add_option("--until", o->until, "s of shaking: go on to a later end than the case's");
  add_checkpoints(*words, o->checkpoints);
  add_views(*words, o->views);
  words->add_flag("--quiet", o->quiet, "no progress");
  words->footer("example: voussoir resume results/flat20n --until 12");
  return {.words = words, .work = [o] { return resume(*o); }, .threads = &o->threads};
}

}  // namespace voussoir::io
