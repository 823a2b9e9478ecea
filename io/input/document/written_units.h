// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

/// Units that people write where a case has a plain number, for remedies in messages. Values of a case have no unit: KEYS.md says in which
/// they are.
namespace voussoir::io {

/// What to write for a number with a unit, such as "0.25 g" where m/s2 are wanted: "a number has no unit here: write 2.4516625". Empty if
/// the text is no number with a word after it. Of a unit that is not known, or of another kind, the remedy names the unit that is wanted.
std::string without_unit(std::string_view text, std::string_view wanted);

/// The name that the program has for a unit, such as "mm" for "millimetres" and "m/s2" for "m/s^2"; as it stands if it is not known.
std::string unit_name(std::string_view written);

/// The same remedy for a line of a file that cannot be parsed at `column` (from 1) since a unit follows a number; empty otherwise.
std::string unit_in_line(std::string_view line, std::size_t column);

}  // namespace voussoir::io
