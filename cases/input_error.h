// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

/// How a fault of the input is reported.
namespace voussoir::cases {

/// An error in the user's input. `key` is the path in the case file ("house.opening[1].width", indices from 0; empty: the whole file); the
/// message says what is wrong, the value, and what is allowed. io adds file and line.
class InputError : public std::runtime_error {
 public:
  InputError(std::string key, const std::string& problem)
      : std::runtime_error(key.empty() ? problem : key + ": " + problem), key_(std::move(key)), problem_(problem) {}
  [[nodiscard]] const std::string& key() const noexcept { return key_; }
  [[nodiscard]] const std::string& problem() const noexcept { return problem_; }

 private:
  std::string key_, problem_;
};

}  // namespace voussoir::cases
