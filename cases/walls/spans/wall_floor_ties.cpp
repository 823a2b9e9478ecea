// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "cases/house/floors/house_floors.h"
#include "cases/names.h"
#include "cases/walls/spans/wall_bays.h"
#include "cases/walls/spans/wall_floors.h"

namespace voussoir::cases {
namespace {

std::string floor_word(std::size_t floor, const char* field) { return Spanning{"floor", floor}.key(field); }

/// The outer face of what stands behind the end of a beam: of a side, or of a wall upon it.
WallFace behind(const WallsPlan& plan, const BayFloor& laid, std::size_t side, double u) {
  for (const WallUpon& w : laid.upon) {
    const Leg& leg = plan.legs[w.leg];
    const double s = cut_at(leg, laid.bay, u).at;
    if (w.side == side && s > 0.0 && s < leg.length()) return {w.leg, -w.inner};
  }
  return {laid.bay.faces[side].leg, -laid.bay.faces[side].d};
}

}  // namespace

std::vector<PlannedTie> wall_beam_anchors(const std::vector<WallSpec>& walls, const WallsPlan& plan, const std::vector<WallFloor>& floors,
                                          double foot) {
  std::vector<PlannedTie> all;
  for (std::size_t i = 0; i < floors.size(); ++i) {
    const Floor& beams = floors[i].beams;
    if (beams.anchorage == Anchorage::friction) continue;
    const BayFloor& laid = plan.floors[i];
    const Bay& bay = laid.bay;
    int number = 0;
    for (const auto& room : laid.rooms) {
      for (std::size_t b = 0; b < room.size(); b += static_cast<std::size_t>(beams.anchor->every)) {
        const double u = 0.5 * metres(room[b].across.low + room[b].across.high);
        const auto v = [&](std::size_t k, double d) { return v_of(plan, bay, {bay.faces[k].leg, d}, u); };
        const double span = v(1, bay.faces[1].d) - v(0, bay.faces[0].d);
        if (!(beams.anchor->reach < 0.5 * span))
          throw InputError(floor_word(i, "anchor.reach"),
                           text(beams.anchor->reach) + " m is not less than half the span of the beams, " + text(0.5 * span) + " m");
        for (std::size_t k = 0; k < 2; ++k) {
          const WallFace held = behind(plan, laid, k, u);
          const Leg& leg = plan.legs[held.leg];
          const double end = 0.5 * (room[b].ends[k][0] + room[b].ends[k][1]), inwards = k == 0 ? 1.0 : -1.0;
          const double left = inwards * (end - v_of(plan, bay, held, u)), square = std::abs(dot(bay.along, leg.facets[0].across));
          if (beams.anchorage == Anchorage::anchor && left * square < kPlanTolerance)
            throw InputError(floor_word(i, "bearing"),
                             text(beams.bearing) + " m leaves nothing of the " + leg.tag +
                                 " behind the beams for anchors to hold; at most " +
                                 text(std::round((beams.bearing + left * square - least_piece(walls[leg.wall])) * 1e6) * 1e-6) + " m");
          BeamEnd at{bay.at(u, end), inwards * bay.along};
          at.at.z = 0.5 * metres(laid.height.low + laid.height.high) + foot;
          at.bearing = std::abs(v(k, bay.faces[k].d) - end), at.behind = std::abs(left);
          at.underside = metres(laid.height.low) + foot, at.course = metres(plan.bricks[leg.wall].brick_height);
          Tie tie = beam_anchor(beams, at);
          tie.name = floors[i].name + " anchor " + std::to_string(++number);
          all.push_back({tie, i});
        }
      }
    }
  }
  return all;
}

}  // namespace voussoir::cases
