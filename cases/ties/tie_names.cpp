// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/ties/tie_names.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>

#include "cases/case.h"
#include "cases/input_error.h"
#include "cases/names.h"

namespace voussoir::cases {
namespace {

/// The key that gives a tie its name: of several the last.
std::string naming_key(const Case& c, const std::string& name) {
  const auto last = [](const auto& list, const char* key, const auto& names) -> std::optional<std::string> {
    const auto found = std::ranges::find_if(list.rbegin(), list.rend(), names);
    return found == list.rend() ? std::nullopt : std::optional(indexed_key(key, static_cast<std::size_t>(list.rend() - found) - 1, "name"));
  };
  const auto own = last(c.ties, "tie", [&](const Tie& t) { return t.name == name; });
  const auto numbers = [&](const HouseTie& t) { return t.bar.name == name || name.starts_with(t.bar.name + " "); };
  return own ? *own : last(c.wall_ties, "wall_tie", numbers).value_or("house");
}

}  // namespace

void check_tie_names(const Case& c, const Model& model) {
  std::set<std::string> names;
  for (const TieBar& bar : model.ties) {
    if (!names.insert(bar.name).second) throw InputError(naming_key(c, bar.name), quoted(bar.name) + " is the name of another tie, too");
  }
}

}  // namespace voussoir::cases
