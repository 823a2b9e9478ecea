// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/names.h"

#include <array>
#include <cstdio>

#include "cases/input_error.h"

namespace voussoir::cases {
namespace {

template <class Named>
std::int32_t find(std::span<const Named> list, const std::string& name, const std::string& key, const char* what) {
  std::string known;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i].name == name) return static_cast<std::int32_t>(i);
    known += (i == 0 ? "" : ", ") + list[i].name;
  }
  throw InputError(key, "unknown " + std::string(what) + " " + quoted(name) + "; known: " + (known.empty() ? "none" : known));
}

}  // namespace

std::int32_t find_material(std::span<const NamedMaterial> materials, const std::string& name, const std::string& key) {
  return find(materials, name, key, "material");
}

std::int32_t find_law(std::span<const NamedLaw> laws, const std::string& name, const std::string& key) {
  return find(laws, name, key, "joint law");
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
