// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/report_command.h"

#include <cstdio>
#include <filesystem>

#include "io/errors.h"
#include "io/report_data.h"
#include "io/report_page.h"
#include "io/run_command.h"
#include "io/text_file.h"

namespace voussoir::io {

int report_command(const ReportOptions& o) {
  const std::string page = o.page.empty() ? o.folder + "/report.html" : o.page;
  std::error_code none;
  if (!o.overwrite && std::filesystem::exists(page, none)) throw FileError(page, "exists; --overwrite replaces it");
  const ReportPage parts = report_page();
  std::string text(parts.head);
  text += report_data(o.folder + "/run.h5");
  text += parts.tail;
  write_text_file(page, text, o.overwrite);
  std::printf("%s  %.1f MB\n", page.c_str(), 1e-6 * static_cast<double>(text.size()));
  return kDone;
}

}  // namespace voussoir::io
