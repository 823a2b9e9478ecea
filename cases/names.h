// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cases/model.h"

/// Look-up of names in the input, and numbers for messages.
namespace voussoir::cases {

/// Index of the material `name`. \throw InputError at `key` that lists the known names.
std::int32_t find_material(std::span<const NamedMaterial> materials, const std::string& name, const std::string& key);

/// Index of the joint law `name`; "dry" is 0. \throw InputError at `key` that lists the known names.
std::int32_t find_law(std::span<const NamedLaw> laws, const std::string& name, const std::string& key);

/// The name most similar to a misspelt one, or empty if none is similar.
std::string nearest(std::string_view name, const std::vector<std::string>& names);

/// The end of a message about an unknown name: "did you mean "front"? ", or nothing if none is similar.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& names);

/// A number as text: at most nine digits, no trailing zeros.
std::string text(double value);

/// `name` in double quotes.
std::string quoted(std::string_view name);

/// "house.opening[1].width" from ("house.opening", 1, "width"); an empty `field` gives the entry itself.
std::string indexed_key(std::string_view list, std::size_t index, std::string_view field);

}  // namespace voussoir::cases
