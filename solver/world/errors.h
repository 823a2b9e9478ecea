// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

namespace voussoir::solver {

/// A numerical failure: NaN, a speed that no house reaches, a ledger that does not close. The state is left as found.
class NumericalError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A saved state that does not belong to the model, or is invalid.
class StateError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace voussoir::solver
