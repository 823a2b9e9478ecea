// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/commands/report_command.h"

#include <cstdio>
#include <filesystem>

#include "io/commands/run_command.h"
#include "io/files/errors.h"
#include "io/files/text_file.h"
#include "io/report/paraview_files.h"
#include "io/report/report_data.h"

namespace voussoir::io {
namespace {

void write_page(const std::string& run, const std::string& page, bool overwrite) {
  std::error_code none;
  if (!overwrite && std::filesystem::exists(page, none)) throw FileError(page, "exists; --overwrite replaces it");
  const std::string text = report_html({run});
  write_text_file(page, text, overwrite);
  std::printf("%s  %.1f MB\n", page.c_str(), 1e-6 * static_cast<double>(text.size()));
}

void write_for_paraview(const std::string& folder, bool overwrite) {
  write_paraview(folder, overwrite);
  std::printf("%s/run.xdmf\n", folder.c_str());
}

}  // namespace

int report_command(const ReportOptions& o) {
  const std::string run = o.folder + "/run.h5";
  const bool stills = !o.stills.times.empty();
  if (o.paraview) write_for_paraview(o.folder, o.overwrite);
  if (stills) {
    StillsOptions s = o.stills;
    s.folder = o.output.empty() ? o.folder + "/stills" : o.output;
    s.overwrite = o.overwrite;
    write_stills(run, s);
  }
  if (!o.paraview && !stills) write_page(run, o.output.empty() ? o.folder + "/report.html" : o.output, o.overwrite);
  return kDone;
}

void write_views(const std::string& folder, const Views& views) {
  if (views.page) write_page(folder + "/run.h5", folder + "/report.html", true);
  if (views.paraview) write_for_paraview(folder, true);
}

}  // namespace voussoir::io
