// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace CLI {
class Validator;
}

namespace voussoir::io {

/// Validator for a number from `low` to `high`. Refuses NaN, which CLI::Range accepts.
CLI::Validator number_range(double low, double high);

}  // namespace voussoir::io
