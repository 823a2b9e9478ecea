// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "geometry/message.h"
#include "io/output/assess/kinematic_check.h"

namespace voussoir::io {
namespace {

using solver::KinematicCurve;

constexpr int kShown = 10;  // intervals of a curve in text

std::string named(const std::string& name, const std::string& value) { return geometry::printed("%-25s", name.c_str()) + value + "\n"; }

std::string curve_text(const KinematicCurve& c) {
  std::string d, m;
  for (int i = 0; i <= kShown; ++i) {
    const double at = c.points.back().displacement * i / kShown;
    d += geometry::printed(" %8.4f", at), m += geometry::printed(" %8.5f", c.at(at));
  }
  return named("d_C [m]", d) + named("multiplier", m);
}

std::string line_text(const KinematicLine& l) {
  if (!l.open.empty()) return named(l.words, "NOT proven: " + l.open);
  const bool moves = !std::isnan(l.period);
  std::string text = moves ? geometry::printed("demand %.4f m at %.3f s, capacity %.4f m", l.demand, l.period, l.capacity)
                           : geometry::printed("demand %.3f m/s2, capacity %.3f m/s2", l.demand, l.capacity);
  text += geometry::printed(": demand over capacity %.3f", l.ratio());
  return named(l.words, text + (l.ratio() > 1.0 ? ", NOT borne" : ""));
}

}  // namespace

std::string kinematic_text(const KinematicCurve& c, const KinematicQuestion& asked, const KinematicCheck& check, const std::string& rule,
                           Vec3 origin) {
  std::string out = "\nkinematic analysis, " + rule + " (Circolare 7/2019, C8.7.1.2.1)\n";
  if (c.points.empty()) return out + named("curve", "NOT found: " + c.none);
  const Vec3 at = origin + c.control;
  out += named("control point", geometry::printed("(%.4f, %.4f, %.4f), centre of the part that moves fastest", at.x, at.y, at.z));
  out += named("activation", geometry::printed("multiplier %.5f, e* %.4f, a_0 = %.4f m/s2 with FC = %g", c.points.front().multiplier,
                                               c.participation, check.activation, asked.confidence));
  out += std::isnan(c.zero) ? named("zero", "NOT found: " + c.none)
                            : named("zero", geometry::printed("d_C0 = %.5f m, d_0 = %.5f m", c.zero, check.zero));
  if (c.points.size() > 1) out += curve_text(c);
  if (c.freedoms > 1)
    out +=
        named("not proven", geometry::printed("the parts have %zu freedoms on their hinges; the motion goes on as it begins", c.freedoms));
  if (c.sliding > 0 && c.points.size() > 1)
    out += named("not proven", geometry::printed("%zu seams slide or part, and hold the finite motion no more", c.sliding));
  if (!asked.demand) return out;
  out +=
      named("demand", asked.demand->name + (asked.around ? geometry::printed(", at %.2f of %.2f m of a building with T_1 = %.3f s",
                                                                             asked.around->height, asked.around->top, asked.around->period)
                                                         : std::string(", at the base")));
  for (const KinematicLine& l : check.lines) out += line_text(l);
  return out;
}

std::string kinematic_json(const KinematicCurve& c, const KinematicQuestion& asked, const KinematicCheck& check, Vec3 origin) {
  using Json = nlohmann::ordered_json;
  const Vec3 at = origin + c.control;
  Json out{{"parts", c.parts},
           {"control", {at.x, at.y, at.z}},
           {"weight", c.weight},
           {"participation", c.participation},
           {"displacement_factor", c.spectral},
           {"confidence", asked.confidence},
           {"activation", check.activation},
           {"zero_control", c.zero},
           {"zero", check.zero},
           {"freedoms", c.freedoms},
           {"sliding_seams", c.sliding},
           {"not_found", c.none},
           {"curve", {{"displacement", Json::array()}, {"multiplier", Json::array()}}},
           {"demand", asked.demand ? Json(asked.demand->name) : Json()},
           {"checks", Json::array()}};
  for (const solver::KinematicPoint& p : c.points) {
    out["curve"]["displacement"].push_back(p.displacement);
    out["curve"]["multiplier"].push_back(p.multiplier);
  }
  for (const KinematicLine& l : check.lines)
    out["checks"].push_back({{"name", l.name},
                             {"period", l.period},
                             {"demand", l.demand},
                             {"capacity", l.capacity},
                             {"demand_over_capacity", l.ratio()},
                             {"not_proven", l.open}});
  return out.dump();
}

}  // namespace voussoir::io
