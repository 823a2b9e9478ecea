// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/capacity/performance_file.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "geometry/message.h"

namespace voussoir::io {
namespace {

using geometry::printed;

constexpr double kSignificantDamage = 0.75;  // of the displacement at near collapse: EN 1998-3:2005, C.4.1.2; Circolare 7/2019, C8.7.1.3.1
constexpr const char* kUnknown = "1 (NaN: not known)";

std::string sentences(const PerformancePoint& p) {
  std::string all;
  for (const std::string& s : p.open) all += (all.empty() ? "" : "; ") + s;
  return all;
}

std::string row_text(const std::string& name, const std::string& value) { return printed("%-21s", name.c_str()) + value + "\n"; }

std::string demand_words(const PerformancePoint& p, const Performance& all) {
  std::string text = printed("target displacement %.2f mm (d*_t %.2f mm)", 1e3 * p.target, 1e3 * p.target_star);
  if (std::isnan(p.demand)) return text + "; demand over capacity not known";
  const double capacity = p.at_most ? all.end : all.near_collapse;
  text += printed("; demand over capacity %s%.3f (near collapse %s%.2f mm)", p.at_most ? "at most " : "", p.demand,
                  p.at_most ? "beyond " : "", 1e3 * capacity);
  if (!p.at_most) text += printed(", %.3f of significant damage (3/4)", p.demand / kSignificantDamage);
  return text + (p.demand > 1.0 ? ": NOT borne" : "");
}

std::string steps_words(const PerformancePoint& p) {
  if (!std::isnan(p.ratio)) {
    return printed("F*_y %.2f kN, d*_y %.3f mm, T* %.4f s, S_e %.3f m/s2, q_u %.3f, d*_et %.3f mm", 1e-3 * p.force, 1e3 * p.yield, p.period,
                   p.spectral, p.ratio, 1e3 * p.elastic);
  }
  return printed("secant period %.4f s, damping %.1f %%, S_e %.3f m/s2", p.period, 1e2 * p.damping, p.spectral);
}

}  // namespace

std::vector<Figure> figures_of(const Performance& p) {
  std::vector<Figure> f{{"demand", p.spectrum, "spectrum"},
                        {"demand_damping", p.damping, "1, of critical"},
                        {"corner_period", p.corner, "s"},
                        {"participation", p.system.participation, kUnknown},
                        {"equivalent_mass", p.system.mass, "kg (NaN: not known)"},
                        {"effective_mass_share", p.system.effective_share(), kUnknown},
                        {"shape_displacement", p.system.shape_at, "m (NaN: not known)"}};
  for (const PerformancePoint& q : p.points) {
    f.push_back({q.name + "_period", q.period, "s (NaN: not known)"});
    f.push_back({q.name + "_target", q.target, "m (NaN: not known)"});
    f.push_back({q.name + "_demand_over_capacity", q.demand, kUnknown});
    f.push_back({q.name + "_not_proven", sentences(q), "what is not proven"});
  }
  return f;
}

std::string performance_text(const Performance& p) {
  std::string text = row_text("demand", printed("%s, %.1f %% of damping, T_C %.2f s", p.spectrum.c_str(), 1e2 * p.damping, p.corner));
  if (!std::isnan(p.system.mass)) {
    text += row_text(
        "equivalent system",
        printed("participation %.3f, m* %.2f t of %.2f t, effective %.1f %%, shape at %.3f mm of the control point", p.system.participation,
                1e-3 * p.system.mass, 1e-3 * p.system.all_mass, 1e2 * p.system.effective_share(), 1e3 * p.system.shape_at));
    if (p.system.participation < 1.0)
      text += row_text("", "participation below 1: the control point moves less than other parts do, so F* is larger than the base shear");
  }
  for (const PerformancePoint& q : p.points) {
    text += row_text(q.words, std::isnan(q.target) ? "no target displacement" : demand_words(q, p));
    if (!std::isnan(q.period)) text += row_text("", steps_words(q));
    for (const std::string& s : q.open) text += row_text("  not proven", s);
  }
  return text;
}

std::string performance_json(const Performance& p) {
  using Json = nlohmann::ordered_json;
  Json out{{"spectrum", p.spectrum},
           {"damping", p.damping},
           {"corner_period", p.corner},
           {"participation", p.system.participation},
           {"mass", p.system.mass},
           {"all_mass", p.system.all_mass},
           {"shape_displacement", p.system.shape_at},
           {"near_collapse", p.near_collapse},
           {"end", p.end},
           {"points", Json::array()}};
  for (const PerformancePoint& q : p.points) {
    out["points"].push_back({{"name", q.name},
                             {"force", q.force},
                             {"yield", q.yield},
                             {"period", q.period},
                             {"acceleration", q.spectral},
                             {"ratio", q.ratio},
                             {"elastic", q.elastic},
                             {"target_star", q.target_star},
                             {"target", q.target},
                             {"damping", q.damping},
                             {"demand_over_capacity", q.demand},
                             {"at_most", q.at_most},
                             {"not_proven", q.open}});
  }
  return out.dump();
}

}  // namespace voussoir::io
