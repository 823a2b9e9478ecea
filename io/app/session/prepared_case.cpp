// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/session/prepared_case.h"

#include <cstdio>
#include <cstdlib>

#include "cases/case.h"
#include "cases/followed_points.h"
#include "cases/loads/control_point.h"
#include "io/app/session/likely_slips.h"
#include "io/app/session/process.h"
#include "io/input/messages/messages.h"
#include "io/input/motion/support_motion.h"
#include "solver/analysis/main_modes.h"

namespace voussoir::io {

namespace {

constexpr double kMore = 1.001;            // times as much mass: less is round-off
constexpr std::size_t kManyBlocks = 3000;  // of which modes take more than some seconds

}  // namespace

cases::Model prepared_model(const cases::Case& c, int threads) {
  now_doing("building the model");
  cases::Model model = cases::build_model(c, threads);
  load_support_motions(model, c.folder);
  cases::check_followed_points(c, model);
  cases::check_control(c, model);
  now_doing("setting up the computation");
  give_memory_back();
  return model;
}

void fill_own_frequency(cases::Case& c, int threads) {
  if (!c.damping.own_frequency || c.damping.frequency) return;
  const cases::Model model = prepared_model(c, threads);
  if (model.blocks.size() > kManyBlocks)
    say_info("damping.frequency = \"auto\": looks for the natural frequency of " + std::to_string(model.blocks.size()) +
             " elements, which may take minutes; a number of Hz in its place saves that");
  using solver::DryJoints;
  // Beams held on walls by friction only have six modes of zero frequency each; in that case their joints count as held by weight. Many
  // rafters have modes of their own below those of the building.
  struct Way {
    DryJoints dry;
    bool all;
  };
  solver::MainMode mode;
  bool held = false;
  for (const Way way : {Way{DryJoints::open, false}, {DryJoints::closed, false}, {DryJoints::closed, true}, {DryJoints::open, true}}) {
    if (mode.frequency > 0.0) break;
    mode = (way.all ? solver::main_modes_of_all(c, model, way.dry) : solver::main_modes(c, model, way.dry))[1];
    held = way.dry == DryJoints::closed;
  }
  if (mode.number > 0) {  // among the lowest: one above them may move more
    const solver::MainMode above = solver::main_modes_of_all(c, model, held ? DryJoints::closed : DryJoints::open)[1];
    if (above.mass_share > kMore * mode.mass_share) mode = above;
  }
  if (mode.frequency == 0.0)
    throw cases::InputError("damping.frequency",
                            "is \"auto\", but no mode moves a tenth of the mass along y (voussoir modes lists them once a number stands "
                            "here); give a number of Hz");
  c.damping.frequency = std::strtod(four_digits(mode.frequency).c_str(), nullptr);
  say_info("damping.frequency = \"auto\": " + mode_words(mode, 1) +
           (held ? ", with joints without a bond held as if bonded, as by voussoir modes --closed" : ""));
}

}  // namespace voussoir::io
