// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/document/written_units.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>

#include "cases/names.h"

namespace voussoir::io {
namespace {

struct Written {
  std::string_view name, of;  // `of`: the unit of the keys of a case
  double factor;
};

constexpr double kG = 9.80665, kFoot = 0.3048, kInch = 0.0254, kDegrees = 180.0 / std::numbers::pi;

/// Names in lower case, without spaces and '^'. Of names for one unit the first is the one that the program uses.
constexpr std::array kUnits{Written{"m", "m", 1.0},
                            Written{"metre", "m", 1.0},
                            Written{"meter", "m", 1.0},
                            Written{"cm", "m", 0.01},
                            Written{"centimetre", "m", 0.01},
                            Written{"centimeter", "m", 0.01},
                            Written{"mm", "m", 0.001},
                            Written{"millimetre", "m", 0.001},
                            Written{"millimeter", "m", 0.001},
                            Written{"in", "m", kInch},
                            Written{"inch", "m", kInch},
                            Written{"inche", "m", kInch},
                            Written{"ft", "m", kFoot},
                            Written{"foot", "m", kFoot},
                            Written{"feet", "m", kFoot},
                            Written{"km", "m", 1000.0},
                            Written{"m2", "m2", 1.0},
                            Written{"cm2", "m2", 1e-4},
                            Written{"mm2", "m2", 1e-6},
                            Written{"s", "s", 1.0},
                            Written{"sec", "s", 1.0},
                            Written{"second", "s", 1.0},
                            Written{"ms", "s", 0.001},
                            Written{"min", "s", 60.0},
                            Written{"minute", "s", 60.0},
                            Written{"hz", "Hz", 1.0},
                            Written{"degrees", "degrees", 1.0},
                            Written{"degree", "degrees", 1.0},
                            Written{"deg", "degrees", 1.0},
                            Written{"°", "degrees", 1.0},
                            Written{"rad", "degrees", kDegrees},
                            Written{"radian", "degrees", kDegrees},
                            Written{"m/s2", "m/s2", 1.0},
                            Written{"g", "m/s2", kG},
                            Written{"cm/s2", "m/s2", 0.01},
                            Written{"gal", "m/s2", 0.01},
                            Written{"m/s", "m/s", 1.0},
                            Written{"cm/s", "m/s", 0.01},
                            Written{"mm/s", "m/s", 0.001},
                            Written{"pa", "Pa", 1.0},
                            Written{"kpa", "Pa", 1e3},
                            Written{"mpa", "Pa", 1e6},
                            Written{"gpa", "Pa", 1e9},
                            Written{"n/mm2", "Pa", 1e6},
                            Written{"n/m2", "Pa", 1.0},
                            Written{"kn/m2", "Pa", 1e3},
                            Written{"bar", "Pa", 1e5},
                            Written{"kg/m3", "kg/m3", 1.0},
                            Written{"t/m3", "kg/m3", 1e3},
                            Written{"g/cm3", "kg/m3", 1e3},
                            Written{"kn/m3", "kg/m3", 1e3 / kG},
                            Written{"n", "N", 1.0},
                            Written{"kn", "N", 1e3},
                            Written{"mn", "N", 1e6},
                            Written{"n/m", "N/m", 1.0},
                            Written{"kn/m", "N/m", 1e3},
                            Written{"n/mm", "N/m", 1e3},
                            Written{"pa/m", "Pa/m", 1.0},
                            Written{"n/mm3", "Pa/m", 1e9},
                            Written{"mpa/mm", "Pa/m", 1e9},
                            Written{"j/m2", "J/m2", 1.0},
                            Written{"kg/m2", "kg/m2", 1.0},
                            Written{"kg/m", "kg/m", 1.0}};

void replace_all(std::string& text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) text.replace(at, what.size(), by);
}

const Written* find(std::string_view written) {
  std::string name(written);
  for (const auto& [sign, digit] : {std::pair{"²", "2"}, std::pair{"³", "3"}, std::pair{"^", ""}, std::pair{" ", ""}, std::pair{"**", ""}})
    replace_all(name, sign, digit);
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto known = [&] { return std::ranges::find(kUnits, name, &Written::name); };
  auto it = known();
  if (it == kUnits.end() && name.size() > 2 && name.back() == 's') name.pop_back(), it = known();
  return it == kUnits.end() ? nullptr : &*it;
}

}  // namespace

std::string without_unit(std::string_view text, std::string_view wanted) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return "";
  std::string_view unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
  while (!unit.empty() && unit.front() == ' ') unit.remove_prefix(1);
  const bool word =
      !unit.empty() && (std::isalpha(static_cast<unsigned char>(unit.front())) != 0 || static_cast<unsigned char>(unit.front()) >= 0x80U);
  if (!unit.empty() && !word) return "";
  const std::string plain(text.data(), end);
  if (unit.empty()) return "write " + plain + " without quotes";
  const Written* found = find(unit);
  if (found != nullptr && found->of == wanted)
    return "a number has no unit here: write " + (found->factor == 1.0 ? plain : cases::text(value * found->factor));
  if (!wanted.empty()) return "a number has no unit here: it is in " + std::string(wanted);
  if (found == nullptr) return "a number has no unit here";
  return "a number has no unit here: this is " + cases::text(value * found->factor) + " " + std::string(found->of);
}

std::string unit_name(std::string_view written) {
  const Written* found = find(written);
  if (found == nullptr) return std::string(written);
  const auto same = [&](const Written& u) { return u.of == found->of && u.factor == found->factor; };
  return std::string(std::ranges::find_if(kUnits, same)->name);
}

std::string unit_in_line(std::string_view line, std::size_t column) {
  if (column < 2 || column > line.size()) return "";
  std::size_t begin = column - 1;
  while (begin > 0 && (line[begin - 1] == ' ' || line[begin - 1] == '\t')) --begin;
  const std::size_t end_of_number = begin;
  while (begin > 0 && (std::isalnum(static_cast<unsigned char>(line[begin - 1])) != 0 ||
                       std::string_view("+-._").find(line[begin - 1]) != std::string_view::npos))
    --begin;
  double value = 0.0;
  const char* const end = line.data() + end_of_number;
  if (const auto [at, error] = std::from_chars(line.data() + begin, end, value); error != std::errc() || at != end) return "";
  std::string_view unit = line.substr(column - 1);
  unit = unit.substr(0, unit.find_first_of(" \t\r\n#,]}"));
  return find(unit) == nullptr ? ""
                               : "a number has no unit in a case file: lengths are in m, times in s, angles in degrees, stresses in Pa";
}

}  // namespace voussoir::io
