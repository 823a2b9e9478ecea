// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "io/input/motion/spectra/spectra.h"

/// Target spectra as users name them.
namespace voussoir::io {

/// "ec8:TYPE:GROUND:AG", as "ec8:1:B:0.3g" (AG in g, or in m/s2 as a plain number), else a file of two columns, period [s] and spectral
/// acceleration, divided by commas, semicolons or blanks, periods rising; '#' begins a comment; a header line "T [s], Sa [g]" may state the
/// unit, else `unit` holds. \throw cases::InputError at "--target"; FileError with the line.
TargetSpectrum read_target(const std::string& name, const std::optional<std::string>& unit);

}  // namespace voussoir::io
