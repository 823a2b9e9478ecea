// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/commands/report_command.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <filesystem>

#include "cases/case.h"
#include "io/commands/run_command.h"
#include "io/files/errors.h"
#include "io/files/text_file.h"
#include "io/report/paraview_files.h"
#include "io/report/report_data.h"
#include "io/report/stills.h"

namespace voussoir::io {
namespace {

void write_page(const std::vector<std::string>& runs, const std::string& page, bool overwrite) {
  std::error_code none;
  if (!overwrite && std::filesystem::exists(page, none)) throw FileError(page, "exists; --overwrite replaces it");
  const std::string text = report_html(runs);
  write_text_file(page, text, overwrite);
  std::printf("%s  %.1f MB\n", page.c_str(), 1e-6 * static_cast<double>(text.size()));
}

void write_for_paraview(const std::string& folder, bool overwrite) {
  write_paraview(folder, overwrite);
  std::printf("%s/run.xdmf\n", folder.c_str());
}

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
    write_page(runs, o.output.empty() ? folder + (runs.size() > 1 ? "/comparison.html" : "/report.html") : o.output, o.overwrite);
  return kDone;
}

void write_views(const std::string& folder, const Views& views) {
  if (views.page || views.page_every > 0) write_page({folder + "/run.h5"}, folder + "/report.html", true);
  if (views.paraview) write_for_paraview(folder, true);
}

void LivePage::look(double now) {
  if (every_ <= 0 || now < next_) return;
  const auto start = std::chrono::steady_clock::now();
  try {
    write_text_file(folder_ + "/report.html", report_html({folder_ + "/run.h5"}), true);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "voussoir: warning: %s; the run goes on without this page\n", e.what());
  }
  const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  next_ = now + took + std::max(every_, 20 * took);
}

}  // namespace voussoir::io
