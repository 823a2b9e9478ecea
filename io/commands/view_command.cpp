// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/commands/view_command.h"

#include <cstdio>
#include <filesystem>

#include "cases/loose_model.h"
#include "io/files/errors.h"
#include "io/files/scratch_folder.h"
#include "io/files/text_file.h"
#include "io/report/report_data.h"
#include "io/results/results.h"
#include "io/session/exit_code.h"
#include "io/session/prepared_case.h"
#include "io/session/session.h"

namespace voussoir::io {
namespace {

/// Elements that a message names: "stone "a" (element 12) overlaps block "b" (element 3) ...".
std::vector<std::int32_t> elements_in(const std::string& message, std::size_t count) {
  const std::string mark = "(element ";
  std::vector<std::int32_t> found;
  for (std::size_t at = message.find(mark); at != std::string::npos; at = message.find(mark, at + 1)) {
    const auto e = std::strtol(message.c_str() + at + mark.size(), nullptr, 10);
    if (e >= 0 && static_cast<std::size_t>(e) < count) found.push_back(static_cast<std::int32_t>(e));
  }
  return found;
}

}  // namespace

int view_command(const LoadedCase& c, const ViewOptions& o) {
  const std::string page = o.output.empty() ? std::filesystem::path(c.path).stem().string() + ".html" : o.output;
  std::error_code none;
  if (!o.overwrite && std::filesystem::exists(page, none)) throw FileError(page, "exists; --overwrite replaces it");
  cases::Model model;
  std::string fault;
  try {
    model = prepared_model(c.value);
  } catch (const cases::InputError& e) {
    model = cases::build_loose_model(c.value);
    fault = c.describe(e);
  }
  const ScratchFolder scratch;
  {
    ResultsWriter results(scratch.path(), model, resolved_toml(anchored(c.value)), history_names(c.value), provenance(1));
    results.flush();
  }
  const std::string text = model_html(scratch.path() + "/run.h5", fault, elements_in(fault, model.blocks.size()));
  write_text_file(page, text, o.overwrite);
  std::printf("%s  %.1f MB\n", page.c_str(), 1e-6 * static_cast<double>(text.size()));
  if (fault.empty()) return kDone;
  std::fprintf(stderr, "voussoir: %s\n", fault.c_str());
  return kInputFault;
}

}  // namespace voussoir::io
