// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/bench/bench_rows.h"

#include <string>

namespace voussoir::io {

namespace {

/// Known work of a part of a step; unknown: 0, 0.
solver::Work work_of(StepPart part, const solver::StepWork& w) {
  switch (part) {
    case StepPart::whole_joints:
      return w.whole_joints;
    case StepPart::damaged_joints:
      return w.damaged_joints;
    case StepPart::contacts:
      return w.contacts;
    case StepPart::assembly:
      return w.assembly;
    case StepPart::update:
      return w.update;
    default:
      return {};
  }
}

}  // namespace

Cells timing_header() {
  return {"threads",           "ms_per_step",       "steps_per_s",   "speedup",     "samples",      "quiet",
          "quiet_ms_per_step", "quiet_steps_per_s", "quiet_speedup", "handover_ns", "ns_per_joint", "ns_per_segment_side"};
}

Cells timing_row(const Timing& t, const cases::Census& n) {
  const double joints = static_cast<double>(n.joints + n.base_joints), segments = static_cast<double>(n.joint_sides);
  Cells cells{std::to_string(t.threads)};
  const auto put_if = [&](bool measured, const char* format, double value) {
    measured ? put(cells, format, value) : static_cast<void>(cells.emplace_back());
  };
  put(cells, "%.4f", 1e3 * t.step), put(cells, "%.0f", 1.0 / t.step), put(cells, "%.2f", t.speedup);
  put(cells, "%.0f", t.samples), put(cells, "%.0f", t.quiet);
  put_if(t.quiet > 0, "%.4f", 1e3 * t.quiet_step), put_if(t.quiet > 0, "%.0f", 1.0 / t.quiet_step);
  put_if(t.quiet_speedup > 0.0, "%.2f", t.quiet_speedup);
  put(cells, "%.0f", 1e9 * t.handover), put(cells, "%.1f", 1e9 * t.step / joints), put(cells, "%.2f", 1e9 * t.step / segments);
  return cells;
}

Cells stage_header() {
  return {"threads", "part_of_the_step", "ms_per_step", "share_of_step", "gflops", "share_of_peak", "gbytes_per_s", "share_of_triad"};
}

std::vector<Cells> stage_rows(const StepSplit& split, MachineLimits best) {
  std::vector<Cells> rows;
  const auto add = [&](const char* name, double time, solver::Work its) {
    Cells cells{std::to_string(split.threads), name};
    put(cells, "%.4f", 1e3 * time), put(cells, "%.3f", time / split.step());
    const auto put_rate = [&](double amount, double limit) {
      if (amount <= 0.0 || time <= 0.0) return static_cast<void>(cells.insert(cells.end(), 2, ""));
      put(cells, "%.1f", 1e-9 * amount / time), put(cells, "%.2f", amount / time / limit);
    };
    put_rate(its.operations, best.flops), put_rate(its.bytes, best.bandwidth);
    rows.push_back(std::move(cells));
  };
  for (std::size_t k = 0; k < split.parts.size(); ++k) {
    add(kStepPartNames[k], split.parts[k], work_of(static_cast<StepPart>(k), split.work));
  }
  add("step", split.step(), {});
  return rows;
}

Cells schedule_header() {
  return {"cores", "ms_by_model", "speedup", "ms_measured", "joints", "contacts", "others", "waiting", "alone", "share_alone"};
}

Cells schedule_row(const solver::PredictedStep& p, double scale, double on_one, double measured) {
  Cells cells{std::to_string(p.cores)};
  put(cells, "%.4f", 1e3 * scale * p.step), put(cells, "%.2f", on_one / (scale * p.step));
  if (measured > 0.0) {
    put(cells, "%.4f", 1e3 * measured);
  } else {
    cells.emplace_back();
  }
  for (const double part : {p.joints, p.contacts, p.others, p.waiting, p.alone}) put(cells, "%.4f", 1e3 * scale * part);
  put(cells, "%.3f", p.alone / p.step);
  return cells;
}

}  // namespace voussoir::io
