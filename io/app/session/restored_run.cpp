// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/session/restored_run.h"

#include <cstdio>

#include "cases/model.h"
#include "cases/solids/origin.h"
#include "io/app/session/prepared_case.h"
#include "io/app/session/process.h"
#include "io/app/session/session.h"
#include "io/input/files/errors.h"
#include "io/input/messages/messages.h"
#include "solver/world/errors.h"

namespace voussoir::io {

namespace {

void fill_supports(RestoredRun& r) {
  const std::vector<cases::SupportHistory>& saved = r.facts.supports;
  if (saved.size() != r.model.support_motions.size()) throw FileError(r.path, "has the motions of other supports than its case");
  for (std::size_t i = 0; i < saved.size(); ++i) {
    r.model.support_motions[i].time = saved[i].time;
    r.model.support_motions[i].displacement = saved[i].displacement;
    r.model.support_motions[i].rotation = saved[i].rotation;
    r.model.support_motions[i].open_ended = saved[i].open_ended;
  }
}

void fill_stones(RestoredRun& r) {
  if (r.facts.stones.size() != r.value.stones.size()) throw FileError(r.path, "has other tables of stones than its case");
  for (std::size_t i = 0; i < r.facts.stones.size(); ++i) r.value.stones[i].stones = r.facts.stones[i];
}

void bring_back(RestoredRun& r, const solver::SavedState& state) {
  const CheckpointFacts now = facts_of(*r.sim, "", {}, false);
  const CheckpointFacts& then = r.facts;
  if (now.model_hash != then.model_hash) {
    throw FileError(r.path,
                    "is of a model that this program, or the mathematical library of this machine, builds differently from the "
                    "same case (written by " +
                        then.program + "; this is " + now.program + "): run the case anew");
  }
  try {
    solver::restore(*r.sim, r.plan, state);
  } catch (const solver::StateError& e) {
    throw FileError(r.path, e.what());
  }
  if (now.program != then.program) {
    say_warning("the run was begun by another build (" + then.program + "; this is " + now.program +
                "): it goes on, but not to the same bits");
  }
}

}  // namespace

std::unique_ptr<RestoredRun> restore_run(const std::string& path, Checkpoint checkpoint, cases::Case value, solver::Options options) {
  auto r = std::make_unique<RestoredRun>();
  r->path = path;
  r->facts = std::move(checkpoint.facts);
  r->value = std::move(value);
  cases::move_origin(r->value, r->facts.origin);
  fill_stones(*r);
  now_doing("building the model");
  r->model = cases::build_model(r->value, options.threads);
  fill_supports(*r);
  give_memory_back();
  options.reference_kernels = r->facts.reference_kernels;
  options.step = r->facts.step;
  r->sim = std::make_unique<solver::Simulation>(r->value, r->model, r->facts.motion, options);
  give_memory_back();
  bring_back(*r, checkpoint.state);
  return r;
}

}  // namespace voussoir::io
