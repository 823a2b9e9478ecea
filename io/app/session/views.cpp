// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/session/views.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>

#include "io/app/session/process.h"
#include "io/input/files/errors.h"
#include "io/input/files/output_path.h"
#include "io/input/messages/messages.h"
#include "io/output/report/paraview_files.h"
#include "io/output/report/report_data.h"

namespace voussoir::io {

namespace {

constexpr double kOftenest = 5.0;  // s: a page loads itself anew no more often

}  // namespace

void write_page(const std::vector<std::string>& runs, const std::string& page, bool overwrite, const std::vector<solver::Mode>& modes) {
  const Output output{page, FileKind::page, "the page", overwrite};
  check_output(output);
  now_doing("making the page");
  const std::string text = report_html(runs, modes);
  write_output(output, text);
  std::printf("%s  %.1f MB\n", page.c_str(), 1e-6 * static_cast<double>(text.size()));
}

void write_for_paraview(const std::string& folder, bool overwrite) {
  write_paraview(folder, overwrite);
  std::printf("%s/run.xdmf\n", folder.c_str());
}

void write_views(const std::string& folder, const Views& views) {
  if (views.page || views.page_every > 0) write_page({folder + "/run.h5"}, folder + "/report.html", true);
  if (views.paraview) write_for_paraview(folder, true);
}

void LivePage::look(double now) {
  if (every_ <= 0 || now < next_) return;
  const auto start = std::chrono::steady_clock::now();
  try {
    write_output({folder_ + "/report.html", FileKind::page, "the page", true}, live_html(folder_ + "/run.h5", std::max(kOftenest, every_)));
  } catch (const std::exception& e) {
    say_warning(std::string(e.what()) + "; the run goes on without this page");
  }
  const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  next_ = now + took + std::max(every_, 20 * took);
}

}  // namespace voussoir::io
