// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/commands/words/joint_words.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "cases/levers.h"
#include "geometry/segments/torsion.h"

namespace voussoir::io {

namespace {

double degrees(double tangent) { return std::atan(tangent) * 180.0 / std::numbers::pi; }

}  // namespace

void print_levers(const cases::Case& c, const cases::Model& m) {
  const std::vector<cases::Lever> levers = cases::levers(c, m);
  for (const cases::Lever& l : levers) {
    std::printf("lever arms of joints     %s of %.3g m: %.3g segments across, short by %.3g %%", l.joint < 0 ? "walls" : "coarsest joint",
                l.width, l.segments, 100.0 * l.short_by());
    if (l.joint < 0) {
      const double slope = l.width / l.height;
      std::printf(" (%.3g m high and free, such a wall overturns at %.2f instead of %.2f degrees)", l.height,
                  degrees(slope * (1.0 - l.short_by())), degrees(slope));
    }
    std::printf("\n");
  }
  if (c.segment_rule != geometry::SegmentRule::centres) std::printf("lever arms of joints     exact\n");
  if (!levers.empty()) std::printf("                         segments.rule = \"rim\" has exact ones\n");
}

void print_torsion(const cases::Case& c, const cases::Model& m) {
  double least = 1e300, most = 0.0, polar = 0.0, solid = 0.0;
  for (const geometry::JointTorsion& j : geometry::joint_torsion(m.assembly)) {
    const double ratio = j.polar / j.solid;
    least = std::min(least, ratio), most = std::max(most, ratio);
    polar += j.polar, solid += j.solid;
  }
  if (most == 0.0) return;
  const bool paper = c.segment_torsion == geometry::Torsion::paper;
  std::printf("twist of joints          %s %.3g to %.3g times as stiff as solids, %.3g times on the whole\n",
              paper ? "G I_p," : "as solids; G I_p would be", least, most, polar / solid);
}

}  // namespace voussoir::io
