// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/compared_measures.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <vector>

#include "geometry/message.h"

namespace voussoir::io {
namespace {

using Json = nlohmann::ordered_json;

/// Presentation of a measure.
struct ShownMeasure {
  const char* name;    // in the summary
  const char* label;   // including the unit
  double factor;       // from SI to that unit
  const char* format;  // of a value
};
constexpr ShownMeasure kShown[] = {
    {"end_time", "run to [s]", 1, "%.3f"},
    {"damage_grade", "damage grade (EMS-98)", 1, "%.0f"},
    {"collapse_time", "collapsed at [s]", 1, "%.3f"},
    {"first_crack_time", "first crack [s]", 1, "%.3f"},
    {"first_fallen_time", "first fallen [s]", 1, "%.3f"},
    {"fallen_mass_fraction", "fallen mass [%]", 100, "%.1f"},
    {"roof_fallen_mass_fraction", "fallen mass of the roof [%]", 100, "%.1f"},
    {"debris_area", "debris [m2]", 1, "%.2f"},
    {"debris_reach", "reach of debris [m]", 1, "%.2f"},
    {"debris_reach_95", "reach of 95 % of it [m]", 1, "%.2f"},
    {"free_volume", "free volume [%]", 100, "%.1f"},
    {"least_free_volume", "least free volume [%]", 100, "%.1f"},
    {"peak_drift", "out-of-plane drift [%]", 100, "%.2f"},
    {"residual_drift", "the same at the end [%]", 100, "%.2f"},
    {"peak_in_plane_drift", "in-plane drift [%]", 100, "%.2f"},
    {"peak_base_shear", "peak base shear [kN]", 1e-3, "%.1f"},
    {"peak_speed", "peak speed [m/s]", 1, "%.2f"},
    {"peak_penetration", "deepest in another [mm]", 1000, "%.3f"},
    {"tension", "sides opened in tension", 1, "%.0f"},
    {"shear", "sides opened in shear", 1, "%.0f"},
    {"compression", "sides opened in compression", 1, "%.0f"},
    {"slipped", "sides that hold, slipped", 1, "%.0f"},
};
constexpr ShownMeasure kShownOfWall[] = {
    {"fallen_mass_fraction", "fallen mass [%]", 100, "%.1f"},
    {"first_fallen_time", "first fallen [s]", 1, "%.3f"},
    {"peak_drift", "drift [%]", 100, "%.2f"},
    {"residual_drift", "drift at the end [%]", 100, "%.2f"},
    {"peak_in_plane_drift", "in-plane drift [%]", 100, "%.2f"},
    {"crack_extent", "cracks of 1 mm", 1, "%.2f"},
    {"large_crack_extent", "cracks of 5 mm", 1, "%.2f"},
};

/// The member of an object, or null.
Json member(const Json& object, std::string_view name) {
  const auto found = object.find(name);
  return found == object.end() ? Json() : *found;
}

Json wall_of(const Json& summary, const std::string& name) {
  for (const Json& wall : member(summary, "walls")) {
    if (wall["name"] == name) return wall;
  }
  return Json::object();
}

/// Names of the walls of both runs, in the order of the first.
std::vector<std::string> wall_names(const Json& a, const Json& b) {
  std::vector<std::string> names;
  for (const Json* summary : {&a, &b}) {
    for (const Json& wall : member(*summary, "walls")) {
      const auto name = wall["name"].get<std::string>();
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  }
  return names;
}

/// Whether the value is the time of an event that never came.
bool never(std::string_view name, const Json& value) {
  if (name == "end_time" || name.starts_with("settling_")) return false;  // these may be before the shaking
  return name.ends_with("_time") && value.is_number() && value.get<double>() < 0.0;
}

/// B - A, or null where undefined.
Json difference(std::string_view name, const Json& a, const Json& b) {
  if (!a.is_number() || !b.is_number() || never(name, a) || never(name, b)) return {};
  if (a.is_number_integer() && b.is_number_integer()) return b.get<std::int64_t>() - a.get<std::int64_t>();
  return b.get<double>() - a.get<double>();
}

std::string shown_value(const ShownMeasure& s, const Json& value) {
  if (!value.is_number()) return "-";
  if (never(s.name, value)) return "never";
  return geometry::printed(s.format, s.factor * value.get<double>());
}

std::string shown_difference(const ShownMeasure& s, const Json& a, const Json& b) {
  const Json d = difference(s.name, a, b);
  if (!d.is_number()) return "-";
  const double value = s.factor * d.get<double>();
  const std::string text = geometry::printed((std::string("%+") + (s.format + 1)).c_str(), value);
  return value == 0.0 ? "0" : text.find_first_of("123456789") == std::string::npos ? text.substr(1) : text;  // no sign for a displayed zero
}

struct Line {
  std::string label, a, b, difference;
};

void add(std::vector<Line>& lines, const ShownMeasure& s, const std::string& before, const Json& a, const Json& b) {
  const Json p = member(a, s.name), q = member(b, s.name);
  if (!p.is_number() && !q.is_number()) return;
  lines.push_back({before + s.label, shown_value(s, p), shown_value(s, q), shown_difference(s, p, q)});
}

}  // namespace

std::string measures_beside(const std::string& a, const std::string& b) {
  const Json p = Json::parse(a), q = Json::parse(b);
  std::vector<Line> lines;
  for (const ShownMeasure& s : kShown) add(lines, s, "", p, q);
  for (const std::string& name : wall_names(p, q)) {
    for (const ShownMeasure& s : kShownOfWall) {
      add(lines, s, name + ": ", wall_of(p, name), wall_of(q, name));
      if (!lines.empty() && lines.back().label == name + ": " + s.label && lines.back().a == lines.back().b) lines.pop_back();
    }
  }
  std::size_t width = 10;
  for (const Line& line : lines) width = std::max(width, line.label.size());
  const auto row = [width](const Line& line) {
    std::string text = line.label + std::string(width - line.label.size(), ' ');
    for (const std::string* cell : {&line.a, &line.b, &line.difference}) {
      text += "  " + std::string(12 - std::min<std::size_t>(12, cell->size()), ' ') + *cell;
    }
    return text + "\n";
  };
  std::string text = row({"measure", "A", "B", "B - A"});
  for (const Line& line : lines) text += row(line);
  return text;
}

std::string measures_beside_json(const std::string& a, const std::string& b) {
  const Json p = Json::parse(a), q = Json::parse(b);
  Json rows = Json::array();
  const auto add_all = [&](const std::string& before, const Json& of_a, const Json& of_b) {
    std::vector<std::string> names;
    for (const Json* object : {&of_a, &of_b}) {
      for (const auto& [name, value] : object->items()) {
        if (!value.is_array() && (before.empty() || name != "name") && std::find(names.begin(), names.end(), name) == names.end())
          names.push_back(name);
      }
    }
    for (const std::string& name : names) {
      const Json x = member(of_a, name), y = member(of_b, name);
      rows.push_back(Json{{"name", before + name}, {"a", x}, {"b", y}, {"difference", difference(name, x, y)}});
    }
  };
  add_all("", p, q);
  for (const std::string& name : wall_names(p, q)) add_all(name + ": ", wall_of(p, name), wall_of(q, name));
  return rows.dump();
}

}  // namespace voussoir::io
