// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/commands/report_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>

#include "cases/case.h"
#include "cases/model.h"
#include "io/app/commands/command.h"
#include "io/app/commands/words/number_range.h"
#include "io/app/session/exit_code.h"
#include "io/app/session/prepared_case.h"
#include "io/app/session/views.h"
#include "io/input/files/errors.h"
#include "io/input/files/output_path.h"
#include "io/input/stones/stones.h"
#include "io/output/replay/run_file.h"
#include "io/output/replay/run_state.h"
#include "io/output/report/pictures/stills.h"
#include "io/output/results/case_of_run.h"
#include "solver/analysis/modes.h"
#include "solver/setup/setup.h"

namespace voussoir::io {
namespace {

constexpr double kFarthest = 1e9;  // s, of a picture

/// Numbers from words, which commas may divide further: {"1.2,2", "3,"}. \throw cases::InputError
std::vector<double> numbers(const char* key, const std::vector<std::string>& words) {
  std::vector<double> all;
  for (const std::string& word : words)
    for (std::size_t from = 0; from < word.size();) {
      const std::size_t end = std::min(word.find(',', from), word.size());
      double value = 0;
      const auto [rest, fault] = std::from_chars(word.data() + from, word.data() + end, value);
      if (from < end && (fault != std::errc() || rest != word.data() + end || !(std::abs(value) <= kFarthest)))
        throw cases::InputError(key, "'" + word.substr(from, end - from) + "' is no number");
      if (from < end) all.push_back(value);
      from = end + 1;
    }
  if (!words.empty() && all.empty()) throw cases::InputError(key, "names no time");
  return all;
}

/// Modes of the undamaged structure of a run.
std::vector<solver::Mode> modes_of(const std::string& run, int count) {
  if (count == 0) return {};
  const Hdf5File file = open_run(run);
  cases::Case c = case_of_run(file);
  load_stones(c);
  const cases::Model model = prepared_model(c);
  if (const Shape elements = file.shape("/model/element/tag"); elements.at(0) != model.blocks.size())
    throw FileError(run, "has " + std::to_string(elements[0]) + " elements, its case now " + std::to_string(model.blocks.size()) +
                             ": its files have changed; no mode shapes");
  return solver::natural_modes(*solver::build_world(c, model, {}), count);
}

}  // namespace

int report_command(const ReportOptions& o) {
  start_command();
  std::vector<std::string> runs;
  for (const std::string& folder : o.folders) {
    note_run(folder), runs.push_back(folder + "/run.h5");
    note_state(open_run(runs.back()));
  }
  const std::string& folder = o.folders.front();
  const std::vector<double> times = numbers("--stills", o.times);
  const bool film = !o.film.file.empty();
  if (runs.size() > 1 && o.paraview) throw cases::InputError("--paraview", "is of one run, not of two");
  if (film && !times.empty()) throw cases::InputError("--film", "does not go with --stills");
  if (!o.views.empty() && !film && times.empty()) throw cases::InputError("--view", "is of pictures: it needs --stills or --film");
  if (o.plain && times.empty()) throw cases::InputError("--plain", "is of pictures: it needs --stills");
  if (film && o.views.size() > 1) throw cases::InputError("--view", "a film has one");
  if (o.modes > 0 && (runs.size() > 1 || film || !times.empty() || o.paraview))
    throw cases::InputError("--modes", "is of the page of one run");
  if (o.paraview) write_for_paraview(folder, o.overwrite);
  if (!times.empty()) {
    StillsOptions s;
    s.times = times;
    if (!o.views.empty()) s.views = o.views;
    s.folder = o.output.empty() ? folder + "/stills" : o.output;
    s.overwrite = o.overwrite, s.plain = o.plain;
    write_stills(runs, s);
  }
  if (film) {
    FilmOptions f = o.film;
    if (!o.views.empty()) f.view = o.views.front();
    f.overwrite = o.overwrite;
    write_film(runs, f);
  }
  if (!o.paraview && times.empty() && !film)
    write_page(runs, o.output.empty() ? folder + (runs.size() > 1 ? "/comparison.html" : "/report.html") : o.output, o.overwrite,
               modes_of(runs.front(), o.modes));
  return kDone;
}

Command add_report(CLI::App& program) {
  CLI::App* words = program.add_subcommand("report", "one HTML page that shows a run: 3D replay, histories, damage, energy");
  auto o = std::make_shared<ReportOptions>();
  words->add_option("DIR", o->folders, "folder of the run, or of two to see side by side")->required()->expected(1, 2);
  words->add_option("-o,--output", o->output,
                    "file of the page, or folder of the pictures (default: DIR/report.html, of two runs DIR/comparison.html; DIR/stills)");
  words->add_flag("--paraview", o->paraview, "write DIR/run.xdmf and DIR/paraview.h5 for ParaView instead of the page");
  words->add_option("--stills", o->times,
                    "pictures at these times, s, instead of the page: T,T,... or T T ...; by Chromium, or plain without it");
  words->add_flag("--plain", o->plain, "pictures without Chromium, which have no title, scale, legend or ties");
  words->add_option("--film", o->film.file, "a film instead of the page: FILE.mp4, .webm or .gif; needs Chromium and ffmpeg");
  words->add_option("--speed", o->film.speed, "of the film: 0.25 is four times slower than it was (default: 1)")
      ->check(number_range(0.001, 100.0));
  words->add_option("--rate", o->film.rate, "pictures a second of the film (default: 25)")->check(CLI::Range(1, 50));
  words->add_option("--view", o->views, "of the pictures or the film: " + view_names() + ", or some of them (default: corner)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(kViews));
  words->add_option("--modes", o->modes, "so many mode shapes of the undamaged structure in the page, too (default: none)")
      ->check(CLI::Range(1, 50));
  words->add_flag("--overwrite", o->overwrite, "replace existing files");
  words->footer(
      "example: voussoir report results/flat20n --stills 1.2,2.0,2.8,4.8 --view front\n"
      "         voussoir report results/flat20n --film flat20n.mp4 --speed 0.5\n"
      "         voussoir report results/flat20n --modes 6\n"
      "         voussoir report results/flat20n results/flat20s");
  return {.words = words, .work = [o] { return report_command(*o); }};
}

}  // namespace voussoir::io
