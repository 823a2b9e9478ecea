// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/commands/view_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "cases/case.h"
#include "cases/loose_model.h"
#include "cases/model.h"
#include "io/app/commands/command.h"
#include "io/app/commands/words/case_words.h"
#include "io/app/session/exit_code.h"
#include "io/app/session/likely_slips.h"
#include "io/app/session/prepared_case.h"
#include "io/app/session/process.h"
#include "io/app/session/session.h"
#include "io/input/files/errors.h"
#include "io/input/files/output_path.h"
#include "io/input/files/scratch_folder.h"
#include "io/input/messages/messages.h"
#include "io/input/stones/stones.h"
#include "io/output/report/pictures/stills.h"
#include "io/output/report/report_data.h"
#include "io/output/results/results.h"

namespace voussoir::io {
namespace {

constexpr double kCoarse = 1e3;  // m, gives one segment per face

/// Elements named in a message: "stone "a" (element 12) overlaps block "b" (element 3) ...".
std::vector<std::int32_t> elements_in(const std::string& message, std::size_t count) {
  const std::string mark = "(element ";
  std::vector<std::int32_t> found;
  for (std::size_t at = message.find(mark); at != std::string::npos; at = message.find(mark, at + 1)) {
    const auto e = std::strtol(message.c_str() + at + mark.size(), nullptr, 10);
    if (e >= 0 && static_cast<std::size_t>(e) < count) found.push_back(static_cast<std::int32_t>(e));
  }
  return found;
}

/// The model, or the part of it that can be shown, and the reason why it is refused.
struct ShownModel {
  cases::Case value;
  cases::Model model;
  std::string fault;
  std::vector<std::int32_t> at_fault;  // elements
  std::vector<Message> faults{};       // with what they are about
};

/// Elements of faulty stones.
std::vector<std::int32_t> elements_of(const cases::Model& model, const cases::Case& c, const std::vector<ShownFault>& faults) {
  std::vector<std::int32_t> numbers, found;
  for (const ShownFault& f : faults) {
    std::size_t number = f.stone;
    for (std::size_t t = 0; t < f.table; ++t) number += c.stones[t].stones.size();
    numbers.push_back(static_cast<std::int32_t>(number));
  }
  std::sort(numbers.begin(), numbers.end());
  for (std::size_t e = 0; e < model.blocks.size(); ++e) {
    if (std::binary_search(numbers.begin(), numbers.end(), model.blocks[e].stone)) found.push_back(static_cast<std::int32_t>(e));
  }
  return found;
}

/// One line per stone, up to a limit.
std::string words_of(const std::vector<ShownFault>& faults, const std::string& otherwise) {
  constexpr std::size_t kMost = 6;
  if (faults.empty()) return otherwise;
  std::string text;
  for (std::size_t i = 0; i < std::min(faults.size(), kMost); ++i) text += (i > 0 ? "\n" : "") + faults[i].message;
  return faults.size() > kMost ? text + "\nand " + std::to_string(faults.size() - kMost) + " more" : text;
}

/// The model with refused stones as thin plates, with coarse segments.
ShownModel with_faults(const LoadedCase& given, const cases::InputError& e) {
  ShownModel s{given.value, {}, given.describe(e), {}};
  const std::vector<ShownFault> faults = load_shown_stones(s.value);
  if (!faults.empty()) s.value.segment_size = kCoarse;
  s.model = cases::build_loose_model(s.value);
  s.at_fault = faults.empty() ? elements_in(s.fault, s.model.blocks.size()) : elements_of(s.model, s.value, faults);
  s.fault = words_of(faults, s.fault);
  s.faults = given.messages(e);
  return s;
}

ShownModel shown_model(const LoadedCase& given, int threads) {
  ShownModel s{given.value, {}, "", {}};
  try {
    load_stones(s.value);
    fill_own_frequency(s.value, threads);
    s.model = prepared_model(s.value, threads);
  } catch (const cases::InputError& e) {
    return with_faults(given, e);
  }
  return s;
}

/// The text above the model: the reason of refusal, and all findings.
std::string in_page(const std::string& fault, const std::vector<std::string>& findings) {
  std::string text = fault;
  for (const std::string& f : findings) text += (text.empty() ? "" : "\n") + ("warning: " + f);
  return text;
}

struct ViewWords {
  CaseWords c;
  ViewOptions o;
};

}  // namespace

int view_command(const LoadedCase& c, const ViewOptions& o, int threads) {
  const std::string page = !o.still.empty()   ? o.still
                           : o.output.empty() ? std::filesystem::path(c.path).stem().string() + ".html"
                                              : o.output;
  const Output output =
      o.still.empty() ? Output{page, FileKind::page, "--output", o.overwrite} : Output{page, FileKind::picture, "--still", o.overwrite};
  check_output(output);
  const ShownModel s = shown_model(c, threads);
  const ScratchFolder scratch;
  {
    ResultsWriter results(scratch.path(), s.model, resolved_toml(anchored(s.value)), history_names(s.value), provenance(1));
    results.flush();
  }
  std::vector<std::string> findings = c.findings;
  const LoadedCase used{s.value, c.path, c.keys, {}, {}};  // including its stones
  const std::vector<std::string> slips = s.fault.empty() ? slips_of_model(used, s.model) : doubts_of_stones(used);
  warn_of(slips);
  findings.insert(findings.end(), slips.begin(), slips.end());
  const std::string run = scratch.path() + "/run.h5", said = in_page(s.fault, findings);
  if (o.still.empty()) {
    const std::string text = model_html(run, said, s.at_fault);
    write_output(output, text);
    std::printf("%s  %.1f MB%s\n", page.c_str(), 1e-6 * static_cast<double>(text.size()),
                findings.empty() ? "" : ("; warnings: " + std::to_string(findings.size())).c_str());
  } else {
    write_still({run, said, s.at_fault, o.view, o.plain}, output);
  }
  if (s.fault.empty()) return kDone;
  say_errors(kInputFault, says_json() ? s.faults : std::vector{Message{.text = s.fault}});
  return kInputFault;
}

Command add_view(CLI::App& program) {
  CLI::App* words =
      program.add_subcommand("view", "one HTML page of the model before any run: stones by material, joints by law, supports");
  auto w = std::make_shared<ViewWords>();
  add_case(*words, w->c);
  words->add_option("-o,--output", w->o.output, "file of the page (default: CASE.html)");
  CLI::Option* still =
      words->add_option("--still", w->o.still, "a picture, FILE.png, instead of the page; by Chromium, or plain without it")
          ->excludes(words->get_option("--output"));
  words->add_option("--view", w->o.view, "of the picture: " + view_names() + " (default: corner)")
      ->check(CLI::IsMember(kViews))
      ->needs(still);
  words->add_flag("--plain", w->o.plain, "a picture without Chromium, which has no title, scale, legend or ties")->needs(still);
  words->add_flag("--overwrite", w->o.overwrite, "replace an existing page or picture");
  words->footer("example: voussoir view my-vault.toml\n         voussoir view my-vault.toml --still my-vault.png --view front");
  return {.words = words,
          .work =
              [w] {
                return with_case(
                    w->c, [w](const auto& c) { return view_command(c, w->o, w->c.threads); }, Fill::none);
              },
          .threads = &w->c.threads};
}

}  // namespace voussoir::io
