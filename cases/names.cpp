// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/names.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <numeric>

#include "cases/input_error.h"

namespace voussoir::cases {
namespace {

constexpr std::size_t kLongestName = 80;

int edit_distance(std::string_view a, std::string_view b) {
  std::vector<int> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    int diagonal = row[0];
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int next = std::min({row[j] + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)});
      diagonal = row[j];
      row[j] = next;
    }
  }
  return row.back();
}

template <class Named>
std::int32_t find(std::span<const Named> list, const std::string& name, const std::string& key, const char* what) {
  std::string known;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i].name == name) return static_cast<std::int32_t>(i);
    known += (i == 0 ? "" : ", ") + list[i].name;
    names.push_back(list[i].name);
  }
  throw InputError(key, "unknown " + std::string(what) + " " + quoted(name) + "; " + did_you_mean(name, names) +
                            "known: " + (known.empty() ? "none" : known));
}

}  // namespace

std::int32_t find_material(std::span<const NamedMaterial> materials, const std::string& name, const std::string& key) {
  return find(materials, name, key, "material");
}

std::int32_t find_law(std::span<const NamedLaw> laws, const std::string& name, const std::string& key) {
  return find(laws, name, key, "joint law");
}

std::string nearest(std::string_view name, const std::vector<std::string>& names) {
  std::string best;
  int least = std::max(1, static_cast<int>(std::min(name.size(), kLongestName)) / 2);
  if (name.size() > kLongestName) return best;
  for (const std::string& candidate : names) {
    const int distance = edit_distance(name, candidate);
    if (distance < least || (distance == least && best.empty())) best = candidate, least = distance;
  }
  return best;
}

std::string did_you_mean(std::string_view name, const std::vector<std::string>& names) {
  const std::string near = nearest(name, names);
  return near.empty() ? "" : "did you mean " + quoted(near) + "? ";
}

std::string text(double value) {
  std::array<char, 40> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.9g", value);
  return buffer.data();
}

std::string quoted(std::string_view name) { return '"' + std::string(name) + '"'; }

std::string indexed_key(std::string_view list, std::size_t index, std::string_view field) {
  std::string key = std::string(list) + "[" + std::to_string(index) + "]";
  if (!field.empty()) key += "." + std::string(field);
  return key;
}

}  // namespace voussoir::cases
