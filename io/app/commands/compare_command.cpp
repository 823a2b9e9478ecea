// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "io/app/commands/command.h"
#include "io/app/commands/summary_command.h"
#include "io/app/commands/words/common_words.h"
#include "io/app/session/process.h"
#include "io/input/files/errors.h"
#include "io/input/files/hdf5_file.h"
#include "io/output/measures/compared_measures.h"
#include "io/output/replay/run_file.h"
#include "io/output/replay/run_state.h"
#include "io/output/results/comparison.h"

namespace voussoir::io {
namespace {

struct CompareWords {
  std::string first, second;
  bool json = false;
};

std::string results_of(const std::string& path) { return std::filesystem::is_directory(path) ? path + "/run.h5" : path; }

std::string summary_of(const std::string& path) { return summary_json(open_run(path)); }

std::string as_json(const Comparison& c, const std::string& a, const std::string& b) {
  using Ordered = nlohmann::ordered_json;
  Ordered out{
      {"identical", c.differing == 0}, {"datasets", c.datasets}, {"differing", c.differing}, {"first", nullptr}, {"measures", nullptr}};
  if (c.first) {
    out["first"] = Ordered{{"dataset", c.first->dataset}, {"what", c.first->what}, {"time", nullptr}};
    if (c.first->time) out["first"]["time"] = *c.first->time;
  }
  try {
    out["measures"] = Ordered::parse(measures_beside_json(summary_of(a), summary_of(b)));
  } catch (const FileError&) {  // not runs: null
  }
  return out.dump(1, ' ', false, Ordered::error_handler_t::replace);
}

/// Prints whether two runs are equal; if not, the first difference, and their measures side by side (compared_measures.h).
/// \param a,  b folders of runs, or files. \param json  one JSON object: identical, datasets, differing, first, measures (always; null if a
/// file is no run). \return 0: equal; 1: not \throw FileError
int compare(const std::string& a, const std::string& b, bool json) {
  now_doing("reading the results");
  for (const std::string& run : {a, b}) note_state(open_run(results_of(run)));
  const Comparison c = compare_files(results_of(a), results_of(b));
  const bool same = c.differing == 0;
  if (json) {
    std::printf("%s\n", as_json(c, results_of(a), results_of(b)).c_str());
    return same ? 0 : 1;
  }
  if (same) {
    std::printf("identical: %zu datasets\n", c.datasets);
    return 0;
  }
  std::printf("different: %zu of %zu datasets", c.differing_datasets, c.datasets);
  if (c.differing_attributes > 0) std::printf(", %zu attributes", c.differing_attributes);
  std::printf("\n");
  const auto print = [](const char* what, const Difference& d) {
    std::printf("%s: %s, %s", what, d.dataset.c_str(), d.what.c_str());
    if (d.time) std::printf(", at %.6f s", *d.time);
    std::printf("\n");
  };
  if (c.input) print("input", *c.input);
  print("first", *c.first);
  try {
    const std::string beside = measures_beside(summary_of(results_of(a)), summary_of(results_of(b)));
    std::printf("\nA: %s\nB: %s\n%s", a.c_str(), b.c_str(), beside.c_str());
  } catch (const FileError& e) {
    std::printf("\nno measures: %s\n", e.what());  // files other than runs can also be compared
  }
  return 1;
}

}  // namespace

Command add_compare(CLI::App& program) {
  CLI::App* words =
      program.add_subcommand("compare", "are two runs the same, bit for bit? If not: what differs first, and their measures side by side");
  auto w = std::make_shared<CompareWords>();
  words->add_option("A", w->first, "folder of a run, or a file")->required();
  words->add_option("B", w->second, "another")->required();
  add_format(*words, w->json);
  words->footer("example: voussoir compare results/one results/other; exit code 0: identical, 1: different");
  return {.words = words, .work = [w] { return compare(w->first, w->second, w->json); }};
}

}  // namespace voussoir::io
