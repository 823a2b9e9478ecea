// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/case_file/inherited_values.h"

#include <array>
#include <utility>
#include <vector>

#include "io/input/document/case_values.h"

namespace voussoir::io {
namespace {

constexpr std::array kSizes{"house.inner_size", "house.height", "house.bearing_wall", "house.nonbearing_wall",
                            "house.walls",      "house.turn",   "house.origin"};

bool is_included(const LoadedCase& c, const std::string& key) {
  const auto it = c.keys.find(key);
  return it != c.keys.end() && it->second.included;
}

/// A key with a number of entries: "house.opening (2)".
std::string counted(const char* key, std::size_t n) { return std::string(key) + " (" + std::to_string(n) + ")"; }

std::vector<std::string> of_another_house(const LoadedCase& c) {
  std::vector<std::string> found;
  const cases::House& house = *c.value.house;
  if (is_included(c, "house.opening[0]")) found.push_back(counted("house.opening", house.openings.size()));
  for (const auto& [key, n] : {std::pair("house.inner_wall", house.inner_walls.size()), std::pair("house.pier", house.piers.size())})
    if (is_included(c, std::string(key) + "[0]")) found.push_back(counted(key, n));
  for (const char* key : {"house.reinforcement.bearing", "house.reinforcement.nonbearing"})
    if (is_included(c, key)) found.emplace_back(key);
  if (is_included(c, "house.roof.surcharge") && house.roof.surcharge > 0.0)
    found.push_back("house.roof.surcharge = " + c.keys.at("house.roof.surcharge").value);
  if (is_included(c, "output.history[0]")) found.push_back(counted("output.history", c.value.output.history.size()));
  if (is_included(c, "damping.frequency") && c.value.damping.frequency)
    found.push_back("damping.frequency = " + c.keys.at("damping.frequency").value);
  return found;
}

}  // namespace

std::string inherited_values(const LoadedCase& c) {
  if (!c.value.house) return "";
  std::string own;
  for (const char* key : kSizes) {
    const auto it = c.keys.find(key);
    if (own.empty() && it != c.keys.end() && !it->second.included) own = it->second.where + " gives " + key;
  }
  if (own.empty()) return "";
  const std::vector<std::string> found = of_another_house(c);
  if (found.empty()) return "";
  return own + ", but these are still of the house that is included: " + joined(found) +
         "; give your own, or take them away (opening = [])";
}

}  // namespace voussoir::io
