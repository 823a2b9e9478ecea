// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace CLI {
class Validator;
}

namespace voussoir::io {

/// For an option that is a number from `low` to `high`. CLI::Range lets NaN pass.
CLI::Validator number_range(double low, double high);

}  // namespace voussoir::io
