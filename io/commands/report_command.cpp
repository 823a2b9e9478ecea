// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/commands/report_command.h"

#include <algorithm>
#include <charconv>

#include "cases/case.h"
#include "io/files/errors.h"
#include "io/report/stills.h"
#include "io/results/case_of_run.h"
#include "io/session/exit_code.h"
#include "io/session/prepared_case.h"
#include "io/session/views.h"
#include "io/stones/stones.h"
#include "solver/analysis/modes.h"
#include "solver/setup/setup.h"

namespace voussoir::io {
namespace {

/// Numbers of words that commas part, too: {"1.2,2", "3,"}. \throw cases::InputError
std::vector<double> numbers(const char* key, const std::vector<std::string>& words) {
  std::vector<double> all;
  for (const std::string& word : words)
    for (std::size_t from = 0; from < word.size();) {
      const std::size_t end = std::min(word.find(',', from), word.size());
      double value = 0;
      const auto [rest, fault] = std::from_chars(word.data() + from, word.data() + end, value);
      if (from < end && (fault != std::errc() || rest != word.data() + end))
        throw cases::InputError(key, "'" + word.substr(from, end - from) + "' is no number");
      if (from < end) all.push_back(value);
      from = end + 1;
    }
  if (!words.empty() && all.empty()) throw cases::InputError(key, "names no time");
  return all;
}

/// Modes of the structure that the run was made of, before anything of it was damaged.
std::vector<solver::Mode> modes_of(const std::string& run, int count) {
  if (count == 0) return {};
  const Hdf5File file = Hdf5File::open(run);
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
  std::vector<std::string> runs;
  for (const std::string& folder : o.folders) runs.push_back(folder + "/run.h5");
  const std::string& folder = o.folders.front();
  const std::vector<double> times = numbers("--stills", o.times);
  const bool film = !o.film.file.empty();
  if (runs.size() > 1 && o.paraview) throw cases::InputError("--paraview", "is of one run, not of two");
  if (film && !times.empty()) throw cases::InputError("--film", "does not go with --stills");
  if (!o.views.empty() && !film && times.empty()) throw cases::InputError("--view", "is of pictures: it needs --stills or --film");
  if (film && o.views.size() > 1) throw cases::InputError("--view", "a film has one");
  if (o.modes > 0 && (runs.size() > 1 || film || !times.empty() || o.paraview))
    throw cases::InputError("--modes", "is of the page of one run");
  if (o.paraview) write_for_paraview(folder, o.overwrite);
  if (!times.empty()) {
    StillsOptions s;
    s.times = times;
    if (!o.views.empty()) s.views = o.views;
    s.folder = o.output.empty() ? folder + "/stills" : o.output;
    s.overwrite = o.overwrite;
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

}  // namespace voussoir::io
