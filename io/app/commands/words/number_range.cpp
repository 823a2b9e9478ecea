// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/commands/words/number_range.h"

#include <CLI/CLI.hpp>
#include <string>

#include "cases/names.h"

namespace voussoir::io {

CLI::Validator number_range(double low, double high) {
  const std::string allowed = "from " + cases::text(low) + " to " + cases::text(high);
  return {[low, high, allowed](const std::string& word) {
            double value = 0.0;
            const bool is_number = CLI::detail::lexical_cast(word, value);
            return is_number && value >= low && value <= high ? std::string() : word + " is out of range; allowed: a number " + allowed;
          },
          "", ""};
}

}  // namespace voussoir::io
