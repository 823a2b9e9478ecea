// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/members/member_words.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "geometry/message.h"

namespace voussoir::io {
namespace {

using geometry::printed;

std::string figure(const char* format, double value) {
  if (std::isnan(value)) return "-";
  const std::string text = printed(format, value);
  return text.find_first_of("123456789") == std::string::npos && text.starts_with('-') ? text.substr(1) : text;  // no sign for a shown zero
}
std::string percent(double x) { return figure("%.2f %%", 100.0 * x); }
std::string seconds(double t) { return t < 0 ? "-" : printed("%.2f s", t); }
std::string millimetres(double x) { return figure("%.2f mm", 1e3 * x); }

std::size_t width_of(std::size_t least, const auto& named) {
  for (const auto& item : named) least = std::max(least, item.name.size() + 2);
  return least;
}

/// "1 of 224" of a deck; "yes" of a tie.
std::string counted(double number, double bars) {
  if (bars == 0) return number > 0 ? "yes" : "-";
  return number > 0 ? printed("%.0f of %.0f", number, bars) : "-";
}

std::string tie_rows(const Measures& m, bool decks, int width) {
  std::string out;
  for (const TieMeasures& t : m.ties) {
    if ((t.bars > 0) != decks) continue;
    out += printed("  %-*s %11s %9s %12s %12s %11s %11s\n", width - 2, t.name.c_str(), printed("%.2f kN", 1e-3 * t.peak_force).c_str(),
                   seconds(t.peak_time).c_str(), millimetres(t.peak_elongation).c_str(), figure("%.0f %%", 100.0 * t.utilisation).c_str(),
                   counted(t.yielded, t.bars).c_str(), counted(t.broken, t.bars).c_str());
  }
  if (out.empty()) return out;
  const char* head = decks ? "decks and meshes: the bar that bears most" : "rods and other ties";
  return printed("\n%-*s %11s %9s %12s %12s %11s %11s\n", width, head, "force", "at", "elongation", "utilisation", "yielded", "broken") +
         out;
}

}  // namespace

std::string storeys_text(const Measures& m) {
  if (m.walls.empty()) return {};
  const int width = static_cast<int>(width_of(26, m.walls));
  std::map<double, std::vector<const WallMeasures*>> storeys;
  for (const WallMeasures& w : m.walls) storeys[w.storey].push_back(&w);
  std::string out = printed("\n%-*s %12s %9s %10s %13s %9s %12s\n", width, "storey drift", "along wall", "at", "at end", "out of plane",
                            "at", "beam slip");
  for (const auto& [number, walls] : storeys) {
    const double foot = std::ranges::min(walls, {}, &WallMeasures::foot)->foot, top = std::ranges::max(walls, {}, &WallMeasures::top)->top;
    out += printed("storey %.0f, %.2f to %.2f m\n", number, foot, top);
    for (const WallMeasures* w : walls) {
      out += printed("  %-*s %12s %9s %10s %13s %9s %12s\n", width - 2, w->name.c_str(), percent(w->peak_storey_drift).c_str(),
                     seconds(w->peak_storey_drift_time).c_str(), percent(w->residual_storey_drift).c_str(), percent(w->peak_drift).c_str(),
                     seconds(w->peak_drift_time).c_str(), millimetres(w->peak_seat_slip).c_str());
      if (!std::isnan(w->peak_gable_drift))
        out += printed("  %-*s %12s %9s %10s %13s %9s\n", width - 2, "  its gable", "", "", "", percent(w->peak_gable_drift).c_str(),
                       seconds(w->peak_gable_drift_time).c_str());
    }
  }
  return out;
}

std::string ties_text(const Measures& m) {
  const int width = static_cast<int>(width_of(42, m.ties));
  return tie_rows(m, false, width) + tie_rows(m, true, width);
}

std::string loads_text(const std::vector<LoadMeasures>& loads) {
  if (loads.empty()) return {};
  const auto kilonewtons = [](double f) { return figure("%.2f kN", 1e-3 * f); };
  std::string out = printed("\n%-20s %11s %9s %12s %15s %9s %11s %11s %12s\n", "loads, along force", "largest", "at", "displaced",
                            "displaced most", "at", "force then", "at end", "displaced");
  for (const LoadMeasures& l : loads)
    out += printed(
        "  %-18s %11s %9s %12s %15s %9s %11s %11s %12s\n", l.name.c_str(), kilonewtons(l.peak_force).c_str(),
        seconds(l.peak_force_time).c_str(), millimetres(l.displacement_at_peak).c_str(), millimetres(l.peak_displacement).c_str(),
        std::isnan(l.peak_displacement_time) ? "-" : seconds(l.peak_displacement_time).c_str(),
        kilonewtons(l.force_at_peak_displacement).c_str(), kilonewtons(l.end_force).c_str(), millimetres(l.end_displacement).c_str());
  for (const LoadMeasures& l : loads) out += "  " + l.name + ": " + l.place + "\n";
  return out;
}

}  // namespace voussoir::io
