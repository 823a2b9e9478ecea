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
/// unit, else `unit` applies. \throw cases::InputError at "--target"; FileError with the line.
TargetSpectrum read_target(const std::string& name, const std::optional<std::string>& unit);

}  // namespace voussoir::io
