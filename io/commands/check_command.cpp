// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <omp.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "cases/census.h"
#include "cases/levers.h"
#include "cases/names.h"
#include "io/case_file/catalogue.h"
#include "io/commands/progress.h"
#include "io/commands/run_command.h"
#include "io/commands/tie_lines.h"
#include "io/files/text_file.h"
#include "io/motion/motion_files.h"
#include "io/motion/support_motion.h"
#include "io/report/drawing.h"
#include "solver/setup/setup.h"

namespace voussoir::io {

namespace {

// Rough figures for the estimate, from a 2021 server core: an intact house; a collapse takes several times as long.
constexpr double kSecondsPerSide = 4.0e-8, kSecondsPerElement = 4.0e-8;
constexpr double kSettling = 1.5;  // s simulated, typical
constexpr double kMegabyte = 1e6;

double degrees(double tangent) { return std::atan(tangent) * 180.0 / std::numbers::pi; }

/// What the rule of centres does to levers: a share of 1/n of each, THEORY.md (2).
void print_levers(const cases::Case& c, const cases::Model& m) {
  const std::vector<cases::Lever> levers = cases::levers(c, m);
  for (const cases::Lever& l : levers) {
    std::printf("levers                   %s of %.3g m: %.3g segments across, short by %.3g %%", l.joint < 0 ? "walls" : "coarsest joint",
                l.width, l.segments, 100.0 * l.short_by());
    if (l.joint < 0) {
      const double slope = l.width / l.height;
      std::printf(" (%.3g m high and free, such a wall overturns at %.2f instead of %.2f degrees)", l.height,
                  degrees(slope * (1.0 - l.short_by())), degrees(slope));
    }
    std::printf("\n");
  }
  if (c.segment_rule == geometry::SegmentRule::rim) std::printf("levers                   exact\n");
  if (!levers.empty()) std::printf("                         segments.rule = \"rim\" has exact ones\n");
}

void print_parts(const cases::Census& n) {
  std::printf("\n%-24s %10s %8s %12s\n", "part", "whole", "cut", "mass [kg]");
  for (const cases::CensusGroup& g : n.groups) {
    std::printf("%-24s %10s %8s %12.1f\n", g.name.c_str(), format_count(g.whole).c_str(), format_count(g.cut).c_str(), g.mass);
  }
}

std::string dimensions(const cases::BillLine& line) {
  if (line.edges[0] == 0.0) return line.corners == 4 ? "hexahedron" : "prism of " + std::to_string(line.corners) + " corners";
  std::string text;
  for (const double edge : line.edges) text += (text.empty() ? "" : " x ") + cases::text(edge);
  return text + " m";
}

void print_bill(const cases::Census& n, const cases::Model& m) {
  std::printf("\n%-52s %10s %12s\n", "bill of blocks", "count", "volume [m3]");
  for (const cases::BillLine& line : n.bill) {
    const std::string what = m.materials[static_cast<std::size_t>(line.material)].name + " " + cases::name(line.kind) +
                             (line.whole ? ", " : ", cut, ") + dimensions(line);
    std::printf("%-52s %10s %12.4f\n", what.c_str(), format_count(line.count).c_str(), line.volume);
  }
}

/// One friction for all pairs of materials, and those that have their own.
void print_friction(const cases::Contact& c) {
  std::printf("\nfriction of contacts     %s degrees", cases::text(c.friction).c_str());
  for (const cases::ContactRule& r : c.between) {
    std::printf("; %s on %s %s", r.materials[0].c_str(), r.materials[1].c_str(), cases::text(r.friction).c_str());
  }
  std::printf("\n");
}

void print_step(const cases::Census& n, const cases::Model& m, double dt) {
  if (n.step_element < 0) return;
  const auto e = static_cast<std::size_t>(n.step_element);
  std::printf("\nstep bound (Eq. 19)      %.4g s, from face %d of %s\n", n.step_bound, n.step_face,
              cases::describe(m.blocks[e], e).c_str());
  std::printf("step                     %.4g s%s\n", dt, dt > n.step_bound ? ", above its bound: the run may diverge" : "");
}

void print_estimate(const cases::Case& c, const cases::Census& n, double dt, int threads) {
  const double duration = c.time.duration + (c.gravity.settle ? kSettling : 0.0);
  const double joints = static_cast<double>(n.joints + n.base_joints), elements = static_cast<double>(n.elements);
  const double step = (joints * kSecondsPerSide + elements * kSecondsPerElement) / threads;
  const double sides = static_cast<double>(n.joint_sides);
  const double memory = 3e3 * elements + 400.0 * joints + 35.0 * sides;
  const double frames = std::floor(c.time.duration / c.output.frame_interval) + 1.0;
  const double rows = c.time.duration / c.output.history_interval;
  const double disk = frames * elements * 32.0 + rows * (8.0 + 72.0 * static_cast<double>(c.output.history.size()) + 56.0);
  std::printf("\nestimate, %d threads      %s if nothing breaks, several times that in a collapse\n", threads,
              format_duration(duration / dt * step).c_str());
  std::printf("memory, disk             about %.0f MB, %.0f MB\n", memory / kMegabyte, disk / kMegabyte);
}

}  // namespace

int check_command(const LoadedCase& c, const CheckOptions& o) {
  cases::Model model = cases::build_model(c.value);
  load_support_motions(model, c.value.folder);
  if (c.value.motion) load_motion(*c.value.motion, c.value.folder);
  const auto world = solver::build_world(c.value, model, {});
  const cases::Census n = cases::census(model);
  std::printf("%s\n\n", c.value.title.c_str());
  std::printf("elements                 %s\n", format_count(n.elements).c_str());
  std::printf("joints                   %s, and %s with the base; %s of them merged\n", format_count(n.joints).c_str(),
              format_count(n.base_joints).c_str(), format_count(n.merged_joints).c_str());
  std::printf("segment sides in joints  %s, and %s free segments\n", format_count(n.joint_sides).c_str(),
              format_count(n.free_segments).c_str());
  std::printf("volume, mass             %.4f m3, %.1f kg\n", n.volume, n.mass);
  print_levers(c.value, model);
  print_ties(model);
  print_step(n, model, world->dt);
  print_friction(c.value.contact);
  print_parts(n);
  print_bill(n, model);
  print_estimate(c.value, n, world->dt, o.threads > 0 ? o.threads : omp_get_max_threads());
  if (!o.draw.empty()) {
    write_text_file(o.draw, draw(c.value, model), o.overwrite);
    std::printf("\ndrawing                  %s\n", o.draw.c_str());
  }
  std::printf("\nno faults found\n");
  return kDone;
}

int cases_command() {
  for (const CatalogueEntry& e : catalogue()) std::printf("%-12s %s\n", e.name.c_str(), e.title.c_str());
  return kDone;
}

}  // namespace voussoir::io
