// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/commands/assess/limit_command.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>

#include "io/assess/limit_words.h"
#include "io/files/errors.h"
#include "io/files/output_path.h"
#include "io/files/text_file.h"
#include "io/session/exit_code.h"
#include "io/session/prepared_case.h"
#include "io/session/progress.h"
#include "solver/analysis/linear_programme.h"

namespace voussoir::io {
namespace {

Vec3 live_direction(const std::string& words) {
  if (words == "x") return {1, 0, 0};
  if (words == "-x") return {-1, 0, 0};
  if (words == "y") return {0, 1, 0};
  if (words == "-y") return {0, -1, 0};
  double degrees = 0.0;
  const auto [end, error] = std::from_chars(words.data(), words.data() + words.size(), degrees);
  if (error != std::errc() || end != words.data() + words.size() || !(std::abs(degrees) <= 360.0)) {
    throw cases::InputError("--direction", "\"" + words + "\" is none; allowed: x, -x, y, -y, or degrees from x towards y, -360 to 360");
  }
  const double angle = degrees * std::numbers::pi / 180.0;
  return {std::cos(angle), std::sin(angle), 0.0};
}

}  // namespace

int limit_command(const LoadedCase& c, const LimitCommandOptions& o) {
  if (!solver::has_linear_programmes()) {
    std::fprintf(
        stderr,
        "voussoir: limit: this program was built without Clp, which it needs (Debian: coinor-libclp-dev; CMake: -DVOUSSOIR_CLP=ON)\n");
    return kInputFault;
  }
  check_output(o.mechanism, o.overwrite);
  LimitQuestion asked{c.value.title, o.direction, {live_direction(o.direction), o.facets, o.outer, {}}};
  asked.options.coulomb = !o.associated;
  const bool on_terminal = Progress::mode_for(2, o.quiet) == Progress::Mode::terminal;
  if (on_terminal) {
    const int least = o.associated ? 1 : solver::LimitResult::kLeastProgrammes,
              most = o.associated ? 1 : solver::LimitResult::kMostProgrammes;
    asked.options.tick = [least, most](int programmes, double multiplier) {
      std::fprintf(stderr, "\rlinear programme %d of %d to %d: multiplier %.5f", programmes, least, most, multiplier);
    };
  }
  const cases::Model model = build_on_all_threads(c.value);
  if (!model.ties.empty())
    std::fprintf(stderr, "voussoir: warning: limit analysis leaves ties out: the multiplier is that of the blocks alone\n");
  if (std::ranges::any_of(c.value.loads, &cases::Load::grows))
    std::fprintf(stderr, "voussoir: warning: limit analysis takes loads with grows = true as dead loads, at their full size\n");
  const solver::LimitResult found = solver::limit_analysis(c.value, model, asked.options);
  if (on_terminal) std::fputc('\n', stderr);
  std::fputs((o.json ? limit_json(asked, model, found) : limit_text(asked, model, found)).c_str(), stdout);
  if (!o.mechanism.empty()) write_text_file(o.mechanism, limit_csv(asked, model, found), o.overwrite);
  return found.coulomb_converged() ? kDone : kNumericalFailure;
}

}  // namespace voussoir::io
