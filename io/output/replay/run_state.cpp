// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/replay/run_state.h"

#include <cstdio>
#include <filesystem>
#include <optional>
#include <set>

#include "io/input/files/run_folder.h"
#include "io/input/messages/messages.h"

namespace voussoir::io {

const char* name_of(RunEnd end) noexcept {
  switch (end) {
    case RunEnd::finished:
      return "finished";
    case RunEnd::lost:
      return "lost";
    case RunEnd::goes_on:
      return "goes on";
    case RunEnd::left:
      return "stopped";
    case RunEnd::unknown:
      break;
  }
  return "unknown";
}

RunState run_state(const Hdf5File& run) {
  if (!run.exists("/summary")) return {RunEnd::unknown, "whether the run goes on is not known"};
  if (run.attribute_int("/summary", "finished") != 0) return {};
  if (run.has_attribute("/summary", "failure")) return {RunEnd::lost, ""};
  const bool dated = run.exists("/provenance") && run.has_attribute("/provenance", "written");
  const std::string rows = dated ? "rows written until " + run.attribute_text("/provenance", "written") : "rows written so far";
  const std::filesystem::path folder = std::filesystem::path(run.path()).parent_path();
  const std::optional<std::string> holder = holder_of(folder.empty() ? "." : folder.string());
  if (!holder) return {RunEnd::unknown, rows + "; a copy, the run may go on elsewhere"};
  if (holder->empty()) return {RunEnd::left, rows + "; the run was stopped or killed, and voussoir resume goes on with it"};
  return {RunEnd::goes_on, rows + "; the run goes on (" + *holder + ")"};
}

void note_state(const Hdf5File& run) {
  static std::set<std::string> told;
  const RunState state = run_state(run);
  if (state.words.empty() || !told.insert(run.path()).second) return;
  say_note(run.path() + ": not finished: " + state.words);
}

}  // namespace voussoir::io
