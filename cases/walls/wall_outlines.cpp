// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/walls/wall_outlines.h"

#include "cases/walls/spans/wall_bays.h"
#include "cases/walls/wall_plan.h"

namespace voussoir::cases {

namespace {

WallOutline outline_of(const Leg& leg, const Facet& f) {
  WallOutline o{side_name(leg),
                f.from,
                f.along,
                f.across,
                f.length,
                leg.half,
                metres(leg.height.low),
                metres(leg.eaves),
                leg.facets.size() > 1,
                (leg.place(f.start + f.length) - leg.place(f.start)) / f.length,
                {}};
  for (const LegHole& h : leg.holes) {
    if (h.kind != HoleKind::opening || h.high <= f.start || h.low >= f.start + f.length) continue;
    o.openings.push_back({h.low - f.start, h.high - f.start, metres(h.height.low), metres(h.height.high)});
  }
  return o;
}

}  // namespace

std::vector<WallOutline> wall_outlines(const std::vector<WallSpec>& walls, const WallSpans& spans) {
  std::vector<WallOutline> all;
  for (const Leg& leg : plan_walls(walls, spans).legs) {
    for (const Facet& f : leg.facets) all.push_back(outline_of(leg, f));
  }
  return all;
}

}  // namespace voussoir::cases
