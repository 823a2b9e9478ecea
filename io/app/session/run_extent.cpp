// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/session/run_extent.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "cases/names.h"
#include "geometry/nth.h"
#include "io/output/results/checkpoints.h"

namespace voussoir::io {
namespace {

constexpr double kMostSteps = 1e10;      // a step of a single block takes half a microsecond: hours; of a house, months
constexpr double kMostRows = 1e9;        // of one table: some 50 GB
constexpr double kMostMotionRows = 5e6;  // of /motion, 80 bytes each: run.h5 is written anew with every part
constexpr double kMostFrameBytes = 1e13;
constexpr double kFrameBytes = 32.0;    // of an element in a frame
constexpr double kFineStep = 1e-7;      // s: no building has so short a step
constexpr double kShortestStep = 1e-9;  // s, as for time.step

const char* end_key(const cases::Case& c) { return cases::is_assessment(c.analysis) ? "analysis.longest" : "time.duration"; }

/// The time that a run may take before it shakes.
double settling(const cases::Case& c) { return c.gravity.settle ? c.gravity.ramp.value_or(0.0) + c.gravity.settle_limit : 0.0; }

/// Refuses the short step of an element: a quotient of its size, density and stiffness.
[[noreturn]] void refuse_step(const cases::Model& model, double dt, const std::string& so_many) {
  const auto element = static_cast<std::size_t>(std::max(cases::census(model).step_element, 0));
  const cases::Block& block = model.blocks.at(element);
  const cases::NamedMaterial& material = nth(model.materials, block.material);
  throw cases::InputError("materials." + material.name + ".young",
                          "= " + cases::text(material.value.young) + " Pa, with density = " + cases::text(material.value.density) +
                              " kg/m3 and the size of " + cases::describe(block, element) + ", makes a step of " + cases::text(dt) +
                              " s, the largest stable one, and " + so_many);
}

void refuse_steps(const cases::Case& c, const cases::Model& model, double dt) {
  const double before = settling(c), steps = (c.end() + before) / dt;
  if (before == 0.0 && c.end() > 0.0 && c.end() < dt)  // 0 is asked for: the model alone
    throw cases::InputError(end_key(c), "= " + cases::text(c.end()) + " s makes no step, of " + cases::text(dt) +
                                            " s, and without gravity.settle there is none before it; allowed: at least one step, or 0 for "
                                            "the model alone");
  if (steps <= kMostSteps && dt >= kShortestStep) return;
  const std::string so_many = cases::text(steps) + " steps; allowed: at most 1e10, of at least 1e-9 s";
  const auto seconds = [](double t) { return "= " + cases::text(t) + " s "; };
  if (c.time.step) throw cases::InputError("time.step", seconds(*c.time.step) + "makes " + so_many);
  if (dt > 0.99 * c.output.history_interval)
    throw cases::InputError("output.history_interval",
                            seconds(c.output.history_interval) + "is the step that divides it, and makes " + so_many);
  if (dt < kFineStep) refuse_step(model, dt, so_many);
  if (c.end() >= before) throw cases::InputError(end_key(c), seconds(c.end()) + "makes " + so_many);
  if (c.gravity.settle_limit > 0.5 * before)
    throw cases::InputError("gravity.settle_limit", seconds(c.gravity.settle_limit) + "makes " + so_many);
  throw cases::InputError("gravity.ramp", seconds(before - c.gravity.settle_limit) + "makes " + so_many);
}

void refuse_rows(const cases::Case& c, std::size_t elements, double dt) {
  const auto rows = [&](double interval) { return c.end() / std::max(interval, dt); };
  const auto refuse = [](const char* key, double interval, const std::string& what) {
    throw cases::InputError(key, "= " + cases::text(interval) + " s makes " + what);
  };
  const double frame = cases::frame_interval(c, elements), frames = rows(frame);
  for (const auto& [key, interval] :
       {std::pair{"output.history_interval", c.output.history_interval}, std::pair{"output.ledger_interval", c.output.ledger_interval},
        std::pair{"output.frame_interval", frame}})
    if (!(rows(interval) <= kMostRows)) refuse(key, interval, cases::text(rows(interval)) + " rows; allowed: at most 1e9");
  const double motion = c.time.duration / std::max(c.output.history_interval, dt);
  if (c.motion && !cases::is_assessment(c.analysis) && !(motion <= kMostMotionRows))
    refuse("output.history_interval", c.output.history_interval,
           cases::text(motion) + " rows of the base's motion in " + cases::text(c.time.duration) + " s; allowed: at most 5e6, with " +
               cases::text(c.time.duration / kMostMotionRows) + " s or more");
  const double bytes = frames * kFrameBytes * static_cast<double>(elements);
  if (!(bytes <= kMostFrameBytes)) refuse("output.frame_interval", frame, cases::text(bytes) + " bytes of frames; allowed: at most 1e13");
}

}  // namespace

DiskNeeds disk_needs(const cases::Case& c, const cases::Census& n) {
  const double elements = static_cast<double>(n.elements), joints = static_cast<double>(n.joints + n.base_joints);
  const double frames = std::floor(c.end() / cases::frame_interval(c, static_cast<std::size_t>(n.elements))) + 1.0;
  const double rows = c.end() / c.output.history_interval;
  // Measured on walls of 600 to 1,000 blocks: within a tenth.
  const double checkpoint =
      350.0 * elements + 360.0 * joints + 30.0 * static_cast<double>(n.joint_sides) + 40.0 * static_cast<double>(n.free_segments);
  return {frames * elements * kFrameBytes + rows * (8.0 + 72.0 * static_cast<double>(c.output.history.size()) + 56.0),
          kKeptCheckpoints * checkpoint};
}

void refuse_endless(const cases::Case& c, const cases::Model& model, const solver::Simulation& sim) {
  refuse_steps(c, model, sim.dt());
  refuse_rows(c, model.blocks.size(), sim.dt());
}

}  // namespace voussoir::io
