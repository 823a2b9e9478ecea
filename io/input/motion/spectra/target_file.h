// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "io/input/motion/spectra/spectra.h"

/// Target spectra from names and files.
namespace voussoir::io {

/// "ec8:TYPE:GROUND:AG", as "ec8:1:B:0.3g" (AG in g, or in m/s2 without a unit), else a file of two columns, period [s], ascending, and
/// spectral acceleration, separated by commas, semicolons or blanks; '#' begins a comment; a header line "T [s], Sa [g]" may state the
/// unit, else `unit` applies. \param option  that names it, for faults \throw cases::InputError at the option; FileError with the line.
TargetSpectrum read_target(const std::string& name, const std::optional<std::string>& unit, const std::string& option = "--target");

/// Whether the words begin as those of an EN 1998-1 spectrum, "ec8:".
bool is_eurocode8(const std::string& words);
/// What is wrong with "ec8:TYPE:GROUND:AG", and what is allowed; empty: nothing.
std::string eurocode8_fault(const std::string& words);
/// The spectrum of these words. \pre eurocode8_fault is empty
Eurocode8 eurocode8_of(const std::string& words);

}  // namespace voussoir::io
