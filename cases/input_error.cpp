// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/input_error.h"

namespace voussoir::cases {

InputError::InputError(std::string key, const std::string& problem)
    : std::runtime_error(key.empty() ? problem : key + ": " + problem), key_(std::move(key)), problem_(problem) {}
InputError::InputError(const InputError&) = default;
InputError& InputError::operator=(const InputError&) = default;
InputError::~InputError() = default;

void Faults::add(const InputError& e) {
  for (const InputError& known : all_) {
    if (known.key() == e.key() && known.problem() == e.problem()) return;
  }
  all_.push_back(e);
}

void Faults::raise() const {
  if (all_.size() == 1) throw all_.front();
  if (!all_.empty()) throw InputErrors(all_);
}

}  // namespace voussoir::cases
