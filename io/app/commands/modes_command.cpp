// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cases/case.h"
#include "cases/model.h"
#include "geometry/nth.h"
#include "io/app/commands/command.h"
#include "io/app/commands/words/case_words.h"
#include "io/app/commands/words/common_words.h"
#include "io/app/session/exit_code.h"
#include "io/app/session/prepared_case.h"
#include "io/app/session/progress.h"
#include "io/input/files/errors.h"
#include "io/input/files/output_path.h"
#include "io/output/report/vtu_file.h"
#include "solver/analysis/impulse.h"
#include "solver/analysis/modes.h"
#include "solver/setup/setup.h"

namespace voussoir::io {

namespace {

struct ModesOptions {
  int count = 6;
  std::string shapes;       // file for ParaView; empty: none
  bool no_impulse = false;  // eigenvalues only: seconds instead of minutes
  bool closed = false;      // eigenvalues count joints without a bond as bonded
  bool overwrite = false, quiet = false, json = false;
};

struct ModesWords {
  CaseWords c;
  ModesOptions o;
};

constexpr std::array<const char*, 2> kAxes{"x", "y"};

double share(const solver::Mode& m, int axis) { return axis == 0 ? m.mass_share.x : m.mass_share.y; }

const solver::Mode& dominant(const std::vector<solver::Mode>& modes, int axis) {
  return *std::max_element(modes.begin(), modes.end(), [&](const auto& a, const auto& b) { return share(a, axis) < share(b, axis); });
}

constexpr double kMechanism = 1e-3;  // Hz

/// The element that a mode moves most.
std::size_t most_moved_by(const solver::Mode& mode) {
  const auto& u = mode.displacement;
  return static_cast<std::size_t>(std::max_element(u.begin(), u.end(), [](Vec3 a, Vec3 b) { return dot(a, a) < dot(b, b); }) - u.begin());
}

/// What nothing holds: mechanisms, which have no frequency.
std::vector<std::string> free_bodies(const cases::Model& model, const std::vector<solver::Mode>& modes) {
  std::vector<std::string> names;
  for (const solver::Mode& mode : modes) {
    if (mode.frequency >= kMechanism) continue;
    const std::size_t e = most_moved_by(mode);
    std::string name = cases::describe(model.blocks[e], e);
    if (std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
  }
  return names;
}

void print_free_bodies(const std::vector<std::string>& names) {
  if (names.empty()) return;
  std::printf("0 Hz: held by no bond: %s", names.front().c_str());
  for (std::size_t i = 1; i < names.size(); ++i) std::printf(", %s", names[i].c_str());
  std::printf("; --closed holds such joints as their weight does\n");
}

struct MainMode {
  int axis = 0;
  solver::Mode mode;
};

/// The modes in which the building takes part, if the lowest ones are local.
std::vector<MainMode> main_modes(const solver::World& world, const std::vector<solver::Mode>& modes, solver::DryJoints dry) {
  std::vector<MainMode> found;
  for (const int axis : {0, 1}) {
    std::vector<solver::Mode> main = solver::modes_along(world, axis, 1, dry);
    if (main.empty() || share(main.front(), axis) <= share(dominant(modes, axis), axis) * 1.001) continue;
    found.push_back({axis, std::move(main.front())});
  }
  return found;
}

/// Of the lowest modes and those above local ones, that with the largest share of the mass along x or y.
const solver::Mode& of_building(const std::vector<solver::Mode>& modes, const std::vector<MainMode>& main, int axis) {
  const auto above = std::ranges::find(main, axis, &MainMode::axis);
  return above == main.end() ? dominant(modes, axis) : above->mode;
}

void print_main_modes(const std::vector<MainMode>& modes) {
  for (const auto& [axis, mode] : modes) {
    const Vec3 s = mode.mass_share;
    std::printf("%6s %16.3f %10.1f %9.1f %9.1f   the building along %s, above local modes\n", "", mode.frequency, 100.0 * s.x, 100.0 * s.y,
                100.0 * s.z, nth(kAxes, axis));
  }
}

void print_modes(const std::vector<solver::Mode>& modes, bool closed) {
  std::printf("eigenvalues of the assembled stiffness%s\n%6s %16s %31s\n%6s %16s %10s %9s %9s\n",
              closed ? ", joints without a bond held as if bonded" : "", "", "", "effective mass [%]", "mode", "frequency [Hz]", "x", "y",
              "z");
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const Vec3 s = modes[i].mass_share;
    std::printf("%6zu %16.3f %10.1f %9.1f %9.1f\n", i + 1, modes[i].frequency, 100.0 * s.x, 100.0 * s.y, 100.0 * s.z);
  }
}

/// Points whose motion is analysed if the case names none.
std::vector<cases::HistoryPoint> most_moved(const cases::Model& model, const std::vector<solver::Mode>& modes,
                                            const std::vector<MainMode>& main) {
  std::vector<cases::HistoryPoint> points;
  for (int axis = 0; axis < 2; ++axis) {
    const std::size_t element = most_moved_by(of_building(modes, main, axis));
    points.push_back({"element " + std::to_string(element), model.assembly.elements[element].mass.centroid});
  }
  return points;
}

/// Responses to an impulse along x and along y.
using Impulses = std::array<solver::ImpulseResponse, 2>;

Impulses impulses(const cases::Case& c, const cases::Model& model, const ModesOptions& o, int threads) {
  solver::Options options;
  options.threads = threads, options.own_pace = true;
  Impulses response;
  const bool on_terminal = Progress::mode_for(2, o.quiet) == Progress::Mode::terminal;
  for (int axis = 0; axis < 2; ++axis) {
    const auto tick = [&](double done) {
      if (on_terminal) std::fprintf(stderr, "\rimpulse along %s: %3.0f %%", nth(kAxes, axis), 100.0 * done);
    };
    nth(response, axis) = solver::impulse_response(c, model, options, axis, tick);
    if (on_terminal) std::fputc('\n', stderr);
  }
  return response;
}

void print_impulse(const cases::Case& c, const std::vector<solver::Mode>& modes, const std::vector<MainMode>& main,
                   const Impulses& response) {
  std::printf("\nimpulse of 1 m/s2 in one sample of %g s, undamped, %g s; bins of %.3f Hz\n%-16s %14s %14s\n", solver::kImpulseInterval,
              solver::kImpulseInterval * solver::kImpulseSamples, 1.0 / (solver::kImpulseInterval * solver::kImpulseSamples), "point",
              "x by x [Hz]", "y by y [Hz]");
  for (std::size_t k = 0; k < c.output.history.size(); ++k) {
    std::printf("%-16s", c.output.history[k].name.c_str());
    for (const solver::ImpulseResponse& r : response)
      std::printf(" %14.3f", solver::dominant_frequency(r.displacement[k], solver::kImpulseInterval));
    std::printf("\n");
  }
  std::printf("%-16s %14.3f %14.3f\n", "eigenvalue", of_building(modes, main, 0).frequency, of_building(modes, main, 1).frequency);
  const std::int64_t broken = response[0].broken + response[1].broken;
  if (broken > 0)
    std::printf("warning: %lld contact points of joints broke or slipped under the impulse: its frequencies are not the sound house's\n",
                static_cast<long long>(broken));
}

using Json = nlohmann::ordered_json;

Json mode_json(const solver::Mode& m) {
  return {{"frequency", m.frequency}, {"mass_share", {m.mass_share.x, m.mass_share.y, m.mass_share.z}}};
}

Json impulse_json(const cases::Case& c, const Impulses& response) {
  Json points = Json::array();
  for (std::size_t k = 0; k < c.output.history.size(); ++k) {
    Json point{{"name", c.output.history[k].name}};
    for (const int axis : {0, 1})
      point[nth(kAxes, axis)] = solver::dominant_frequency(nth(response, axis).displacement[k], solver::kImpulseInterval);
    points.push_back(std::move(point));
  }
  return {{"points", std::move(points)}, {"broken", response[0].broken + response[1].broken}};
}

/// One object with frequencies in Hz and shares of mass along x, y, z.
void print_json(const cases::Case& c, const std::vector<solver::Mode>& modes, const std::vector<MainMode>& main,
                const std::vector<std::string>& held_by_nothing, const std::optional<Impulses>& response) {
  Json out{{"title", c.title}, {"modes", Json::array()}, {"main", Json::object()}, {"held_by_nothing", held_by_nothing}};
  for (const solver::Mode& m : modes) out["modes"].push_back(mode_json(m));
  for (const auto& [axis, mode] : main) out["main"][nth(kAxes, axis)] = mode_json(mode);
  out["impulse"] = response ? impulse_json(c, *response) : Json(nullptr);
  std::printf("%s\n", out.dump(1, ' ', false, Json::error_handler_t::replace).c_str());
}

/// Prints first natural frequencies from the eigenvalues of the assembled stiffness, and from the impulse and Fourier transform of the
/// paper's section 3.5 at the points that the case follows (if it follows none: at the element that the mode with the largest share of mass
/// moves most).
/// \throw cases::InputError, FileError, solver::NumericalError
int modes(const LoadedCase& loaded, const ModesOptions& o, int threads) {
  const Output shapes{o.shapes, FileKind::shapes, "--shapes", o.overwrite};
  check_output(shapes);
  cases::Case c = loaded.value;
  const cases::Model model = prepared_model(c, threads);
  const solver::DryJoints dry = o.closed ? solver::DryJoints::closed : solver::DryJoints::open;
  const auto world = solver::build_world(c, model, {});
  const std::vector<solver::Mode> modes = solver::natural_modes(*world, o.count, dry);
  if (modes.empty()) throw cases::InputError("", "has nothing that moves");
  const std::vector<MainMode> main = main_modes(*world, modes, dry);
  const std::vector<std::string> held_by_nothing = free_bodies(model, modes);
  if (!o.json) {
    std::printf("%s\n\n", c.title.c_str());
    print_modes(modes, o.closed);
    print_main_modes(main);
    print_free_bodies(held_by_nothing);
  }
  if (!o.shapes.empty()) write_output(shapes, mode_shapes_vtu(model, modes));
  std::fflush(stdout);
  if (!o.no_impulse && c.output.history.empty()) c.output.history = most_moved(model, modes, main);
  const std::optional<Impulses> response = o.no_impulse ? std::nullopt : std::optional(impulses(c, model, o, threads));
  if (o.json)
    print_json(c, modes, main, held_by_nothing, response);
  else if (response)
    print_impulse(c, modes, main, *response);
  return kDone;
}

}  // namespace

Command add_modes(CLI::App& program) {
  CLI::App* words = program.add_subcommand("modes", "first natural frequencies: eigenvalues, and an impulse with a Fourier transform");
  auto w = std::make_shared<ModesWords>();
  add_case(*words, w->c);
  words->add_option("--count", w->o.count, "how many modes (default 6)")->check(CLI::Range(1, 200));
  words->add_option("--shapes", w->o.shapes, "write the mode shapes to this .vtu file for ParaView");
  words->add_flag("--no-impulse", w->o.no_impulse, "eigenvalues only: seconds instead of minutes");
  words->add_flag(
      "--closed", w->o.closed,
      "eigenvalues with joints without a bond held as if bonded, as weight holds them while the motion is small: for beams that "
      "lie loose on walls");
  add_format(*words, w->o.json);
  words->add_flag("--overwrite", w->o.overwrite, "replace an existing file of shapes");
  words->add_flag("--quiet", w->o.quiet, "no progress");
  words->footer("example: voussoir modes vault20n --shapes vault20n-modes.vtu");
  return {.words = words,
          .work = [w] { return with_case(w->c, [w](const auto& c) { return modes(c, w->o, w->c.threads); }); },
          .threads = &w->c.threads};
}

}  // namespace voussoir::io
