// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "cases/case.h"
#include "cases/model.h"
#include "cases/names.h"
#include "io/app/commands/command.h"
#include "io/app/commands/words/case_words.h"
#include "io/app/commands/words/common_words.h"
#include "io/app/commands/words/number_range.h"
#include "io/app/session/exit_code.h"
#include "io/app/session/prepared_case.h"
#include "io/app/session/process.h"
#include "io/app/session/words/limit_progress.h"
#include "io/input/files/errors.h"
#include "io/input/files/output_path.h"
#include "io/input/messages/messages.h"
#include "io/input/motion/spectra/intensity.h"
#include "io/output/assess/limit_words.h"
#include "solver/limit/load_path.h"
#include "solver/limit/programme/linear_programme.h"

namespace voussoir::io {
namespace {

struct LimitCommandOptions {
  std::string direction;         // x, -x, y, -y, z, -z, degrees from x towards y, or a vector X,Y,Z; empty: x, for point loads -z
  std::vector<std::string> on;   // loaded blocks
  std::optional<double> force;   // N, instead of weights
  std::vector<double> at, path;  // m, coordinates of a point; of the corners of a path, in order
  int positions = 21;            // number of positions on the path
  int facets = 8;                // of the friction cone
  bool outer = false;            // facets outside the cone instead of inside
  std::string mechanism;         // CSV file for the mechanism; empty: none
  bool associated = false;       // associated flow only
  bool kinematic = false;        // follow the mechanisms by finite displacements
  std::string demand;            // spectrum for their verification; empty: none
  std::optional<std::string> unit;
  double confidence = 1.35, behaviour = 2.0;  // FC, q
  std::optional<double> height, top, period;  // m, m, s: of the mechanism, of the building, its first period
  int storeys = 1;
  bool json = false, overwrite = false, quiet = false;
};

struct LimitWords {
  CaseWords c;
  LimitCommandOptions o;
};

using solver::LiveLoad;

/// Direction from "x", "-z", "30" (degrees from x towards y) or "0.6,0,-0.8" as a unit vector.
Vec3 direction_of(const std::string& words) {
  const auto refuse = [&] {
    throw cases::InputError("--direction", "\"" + words +
                                               "\" is none; allowed: x, -x, y, -y, z, -z, degrees from x towards y, -360 to 360, "
                                               "or X,Y,Z, not all zero");
  };
  if (words == "x") return {1, 0, 0};
  if (words == "-x") return {-1, 0, 0};
  if (words == "y") return {0, 1, 0};
  if (words == "-y") return {0, -1, 0};
  if (words == "z") return {0, 0, 1};
  if (words == "-z") return {0, 0, -1};
  std::vector<double> numbers;
  for (const char *at = words.data(), *end = at + words.size(); at <= end; ++at) {
    const auto [next, error] = std::from_chars(at, end, numbers.emplace_back());
    if (error != std::errc() || (next != end && *next != ',') || !std::isfinite(numbers.back())) refuse();
    at = next;
  }
  if (numbers.size() == 3) {
    const double largest = std::max({std::abs(numbers[0]), std::abs(numbers[1]), std::abs(numbers[2])});
    if (largest == 0.0) refuse();
    return normalised(Vec3{numbers[0] / largest, numbers[1] / largest, numbers[2] / largest});
  }
  if (numbers.size() != 1 || std::abs(numbers[0]) > 360.0) refuse();
  const double angle = numbers[0] * std::numbers::pi / 180.0;
  return {std::cos(angle), std::sin(angle), 0.0};
}

std::vector<Vec3> points_of(const std::vector<double>& numbers, const char* option) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) points.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  if (numbers.size() % 3 != 0 || points.empty())
    throw cases::InputError(option, std::to_string(numbers.size()) + " numbers are not the coordinates of points; allowed: X,Y,Z of each");
  return points;
}

LiveLoad live_load(const LimitCommandOptions& o, const cases::Case& c) {
  const bool is_force = o.force || !o.at.empty() || !o.path.empty();
  if (!o.path.empty() && !(o.at.empty() && o.on.empty()))
    throw cases::InputError("--path", "says where the force acts; allowed beside it: --force, --direction, --positions");
  if (!o.path.empty() && points_of(o.path, "--path").size() < 2)
    throw cases::InputError("--path", "has one point; allowed: two or more, as X,Y,Z,X,Y,Z");
  if (o.force && o.at.empty() && o.path.empty() && o.on.empty())
    throw cases::InputError("--force", "acts nowhere; allowed with it: --on, --at or --path");
  if (o.on.size() > 1 && !o.at.empty()) throw cases::InputError("--at", "is one point; allowed with it: one name of --on, or none");
  LiveLoad live;
  live.on = o.on;
  live.direction = direction_of(!o.direction.empty() ? o.direction : is_force ? "-z" : "x");
  if (is_force) live.kind = LiveLoad::Kind::force;
  if (o.force) live.force = *o.force;
  if (!o.at.empty()) live.at = points_of(o.at, "--at").front() - c.origin.value_or(Vec3{});
  const bool given = is_force || !o.direction.empty() || !o.on.empty();
  if (!given && std::ranges::any_of(c.loads, &cases::Load::grows)) live.kind = LiveLoad::Kind::loads;
  return live;
}

std::string words_of(const LiveLoad& live, const LimitCommandOptions& o) {
  std::string on, at;
  for (const std::string& name : live.on) on += (on.empty() ? " on " : ", ") + name;
  if (live.at) {
    at = on.empty() ? " at (" : ", at (";
    for (std::size_t i = 0; i < 3; ++i) at += (i > 0 ? ", " : "") + cases::text(o.at[i]);
    at += ")";
  }
  const std::string along = !o.direction.empty() ? o.direction : live.kind == LiveLoad::Kind::force ? "-z" : "x";
  if (live.kind == LiveLoad::Kind::loads) return "multiplier x the loads of the case that grow";
  if (live.kind == LiveLoad::Kind::force)
    return "multiplier x " + cases::text(live.force) + " N, along " + along + (o.path.empty() ? on + at : ", along a path");
  return "multiplier x weight" + (on.empty() ? "" : " of" + on.substr(3)) + ", along " + along;
}

/// What the kinematic verification is asked for; nothing without --kinematic. \throw cases::InputError, FileError
std::optional<KinematicQuestion> kinematic_question(const LimitCommandOptions& o, const LiveLoad& live) {
  const bool at_height = o.height || o.top || o.period;
  if (!o.kinematic) {
    if (!o.demand.empty() || at_height)
      throw cases::InputError("--kinematic", "is missing: --demand, --height and what goes with it are of it");
    return {};
  }
  if (live.kind != LiveLoad::Kind::weight || !live.on.empty() || live.direction.z != 0.0)
    throw cases::InputError("--kinematic",
                            "is of the weight of all blocks as live load, along a horizontal direction; leave out --on, --force, "
                            "--at, --path, and loads that grow");
  KinematicQuestion q;
  q.confidence = o.confidence, q.behaviour = o.behaviour;
  if (!o.demand.empty()) q.demand = read_demand(o.demand, kIntensityDamping, {}, o.unit, "--demand");
  if (!at_height) return q;
  if (!o.height || !o.top || !o.period || o.demand.empty())
    throw cases::InputError("--height", "asks for --building-height, --building-period and --demand, too");
  if (*o.height > *o.top) throw cases::InputError("--height", "lies above the building; allowed: up to --building-height");
  q.around = BuildingAround{.height = *o.height, .top = *o.top, .period = *o.period, .damping = kIntensityDamping, .storeys = o.storeys};
  return q;
}

Output mechanism_of(const LimitCommandOptions& o) { return {o.mechanism, FileKind::table, "--mechanism", o.overwrite}; }

/// Prints the result and writes the mechanism. \return the exit code
int tell(const LimitQuestion& asked, const LimitCommandOptions& o, const cases::Case& c, const cases::Model& model,
         const solver::LimitResult& found, const solver::LoadPath* path) {
  const std::vector<Kinematics> followed = kinematics_of(asked, c, model, found);
  std::fputs((o.json ? limit_json(asked, model, found, path, followed) : limit_text(asked, model, found, path, followed)).c_str(), stdout);
  if (!o.mechanism.empty()) write_output(mechanism_of(o), limit_csv(asked, model, found));
  bool proven = o.associated || found.coulomb_proven();
  if (path != nullptr)
    for (const solver::LoadPosition& p : path->positions) proven = proven && (o.associated || !p.found || p.found->coulomb_proven());
  return proven ? kDone : kNumericalFailure;
}

/// What the multiplier takes for granted of ties.
void say_of_ties(const cases::Model& model) {
  const auto breaking = std::ranges::count_if(model.ties, [](const cases::TieBar& t) { return std::isfinite(t.breaking); });
  if (breaking > 0)
    say_warning(std::to_string(breaking) +
                " ties and bars of meshes break beyond their elongation; limit analysis takes them to yield as far as the "
                "mechanism moves");
}

/// Finds the collapse multiplier of a live load and its mechanism, by limit analysis of dry rigid blocks (solver/limit/limit.h).
/// \throw cases::InputError, FileError
int limit(const LoadedCase& c, const LimitCommandOptions& o, int threads) {
  if (!solver::has_linear_programmes()) {
    say_error(kInputFault, {.text = "limit: this program was built without Clp, which it needs (Debian: coinor-libclp-dev; CMake: "
                                    "-DVOUSSOIR_CLP=ON)"});
    return kInputFault;
  }
  if (const std::string file = demand_file(o.demand); !file.empty()) note_input(file);
  check_output(mechanism_of(o));
  LimitQuestion asked{c.value.title, "", {live_load(o, c.value), o.facets, o.outer, {}}, {}};
  asked.kinematic = kinematic_question(o, asked.options.live);
  asked.live = words_of(asked.options.live, o);
  asked.options.coulomb = !o.associated;
  std::optional<LimitProgress> progress(std::in_place, o.quiet, asked.options.coulomb);
  progress->watch(asked.options);
  now_doing("building the model");
  const cases::Model model = cases::build_model(c.value, threads);
  now_doing("looking for the multiplier");
  say_of_ties(model);
  if (o.path.empty()) {
    const solver::LimitResult found = solver::limit_analysis(c.value, model, asked.options);
    progress.reset();
    return tell(asked, o, c.value, model, found, nullptr);
  }
  std::vector<Vec3> corners = points_of(o.path, "--path");
  for (Vec3& corner : corners) corner -= model.origin;
  const solver::LoadPath path = solver::limit_along_path(c.value, model, asked.options, corners, o.positions);
  progress.reset();
  if (!path.weakest)
    throw solver::NothingFalls("--path", "nothing falls at any place of it, whatever the force, or it meets no block that can move");
  return tell(asked, o, c.value, model, *path.positions[*path.weakest].found, &path);
}

}  // namespace

Command add_limit(CLI::App& program) {
  CLI::App* words = program.add_subcommand("limit", "collapse multiplier and mechanism of dry blocks by limit analysis; runs nothing");
  auto w = std::make_shared<LimitWords>();
  add_case(*words, w->c);
  words->add_option("--direction", w->o.direction,
                    "of the live load: x, -x, y, -y, z, -z, degrees from x towards y, or X,Y,Z (default: x; of point loads -z)");
  words->add_option("--on", w->o.on, "NAME,...: the live load is the weight of these blocks, stones or groups alone, or --force on each")
      ->delimiter(',');
  words->add_option("--force", w->o.force, "N (default 1000): the live load is this force, on the blocks of --on, at --at or along --path")
      ->check(number_range(1e-9, 1e15));
  words->add_option("--at", w->o.at, "X,Y,Z: where the force acts; without --on on the block that holds the point, or the first behind it")
      ->delimiter(',')
      ->expected(3)
      ->check(number_range(-1e7, 1e7));
  words
      ->add_option("--path", w->o.path,
                   "X,Y,Z,X,Y,Z,...: the force moves along this line, and acts where it meets the model; the weakest place")
      ->delimiter(',')
      ->check(number_range(-1e7, 1e7));
  words->add_option("--positions", w->o.positions, "places on the path, both ends among them (default 21)")->check(CLI::Range(1, 10000));
  words->add_option("--facets", w->o.facets, "of the friction cone (default 8; plane models need none)")->check(CLI::Range(4, 64));
  words
      ->add_option_function<std::string>(
          "--cone", [w = w.get()](const std::string& word) { w->o.outer = word == "outer"; },
          "facets in the cone, which err to the safe side (default), or round it")
      ->check(CLI::IsMember({"inner", "outer"}));
  words->add_flag("--associated", w->o.associated,
                  "associated flow alone, in which joints open as they slide: a multiplier at or above that of Coulomb's friction, in a "
                  "twentieth of the time");
  words->add_flag("--kinematic", w->o.kinematic,
                  "also the multiplier as the mechanism moves by finite displacements, and its kinematic verification (Circolare 7/2019, "
                  "C8.7.1.2.1)");
  words->add_option("--demand", w->o.demand,
                    "of --kinematic: ec8:TYPE:GROUND:AG, record:FILE, or a file of periods and accelerations at 5 %");
  words->add_option("--unit", w->o.unit, "of acceleration in a file of --demand that does not state it: g, m/s2, cm/s2");
  words->add_option("--confidence", w->o.confidence, "FC of --kinematic (default 1.35)")->check(number_range(1.0, 10.0));
  words->add_option("--behaviour", w->o.behaviour, "q of --kinematic (default 2)")->check(number_range(1.0, 10.0));
  words->add_option("--height", w->o.height, "m, z of the mechanism above the ground in a building, of --kinematic (default: at the base)")
      ->check(number_range(0.0, 1000.0));
  words->add_option("--building-height", w->o.top, "m, H")->check(number_range(0.1, 1000.0));
  words->add_option("--building-period", w->o.period, "s, T_1 (voussoir modes)")->check(number_range(0.001, 10.0));
  words->add_option("--storeys", w->o.storeys, "n of the building (default 1)")->check(CLI::Range(1, 100));
  words->add_option("--mechanism", w->o.mechanism, "write the velocities of all elements to this CSV file");
  add_format(*words, w->o.json);
  words->add_flag("--overwrite", w->o.overwrite, "replace an existing file of the mechanism");
  words->add_flag("--quiet", w->o.quiet, "no progress");
  words->footer("A case with loads that grow has these as live load.\nexample: voussoir limit flat20n --associated");
  return {.words = words,
          .work =
              [w] {
                return with_case(
                    w->c, [w](const auto& c) { return limit(c, w->o, w->c.threads); }, Fill::stones);
              },
          .threads = &w->c.threads};
}

}  // namespace voussoir::io
