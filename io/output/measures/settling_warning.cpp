// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/settling_warning.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "cases/model.h"
#include "io/output/measures/building/building.h"

namespace voussoir::io {
namespace {

constexpr std::size_t kNamed = 4;  // parts named in a message; the rest are "others"

/// Broken bonds by part of the building, and their range of heights.
struct Broken {
  std::map<std::string, std::int64_t> by_part;
  std::int64_t all = 0;                                               // a bond counts for both of its elements
  double low = std::numeric_limits<double>::infinity(), high = -low;  // m
};

Broken broken_bonds(const solver::World& w) {
  Broken found;
  for (std::size_t e = 0; e < w.model.blocks.size(); ++e) {
    const std::int64_t lost = std::int64_t{w.elements.bonds_at_start[e]} - std::int64_t{w.elements.bonds[e]};
    if (lost <= 0) continue;
    const cases::Block& block = w.model.blocks[e];
    found.by_part[block.tag.empty() ? "block \"" + block.name + "\"" : part_of(block.tag)] += lost;
    found.all += lost;
    const auto [low, high] = geometry::bounds(block.shape);
    found.low = std::min(found.low, low.z), found.high = std::max(found.high, high.z);
  }
  return found;
}

std::string percent(std::int64_t part, std::int64_t all) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%.0f %%", 100.0 * static_cast<double>(part) / static_cast<double>(all));
  return text.data();
}

/// Shares in words: "front wall 60 %, roof beam 30 %, others 10 %".
std::string shares(const Broken& b) {
  std::vector<std::pair<std::int64_t, std::string>> parts;
  for (const auto& [name, lost] : b.by_part) parts.emplace_back(lost, name);
  std::ranges::stable_sort(parts, [](const auto& x, const auto& y) { return x.first > y.first; });
  std::string text;
  std::int64_t others = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i >= kNamed) {
      others += parts[i].first;
    } else {
      text += (text.empty() ? "" : ", ") + parts[i].second + " " + percent(parts[i].first, b.all);
    }
  }
  return text + (others > 0 ? ", others " + percent(others, b.all) : "");
}

}  // namespace

std::string settling_warning(const solver::World& world, const solver::RunState& state) {
  const solver::Damage& d = state.settling;
  const std::int64_t opened = d.tension + d.shear + d.compression;
  if (opened == 0) return "";
  const Broken b = broken_bonds(world);
  std::array<char, 80> where{};
  std::snprintf(where.data(), where.size(), "; between z = %.2f and %.2f m", b.low, b.high);
  return std::to_string(opened) + " of " + std::to_string(opened + d.bonded) +
         " contact points of joints broke under the building's own weight, while it settled (" + std::to_string(d.tension) +
         " in tension, " + std::to_string(d.shear) + " in shear, " + std::to_string(d.compression) +
         " in compression). Where: " + shares(b) + where.data();
}

}  // namespace voussoir::io
