// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// How a fault of the input is reported.
namespace voussoir::cases {

/// An error in the user's input. `key` is the path in the case file ("house.opening[1].width", indices from 0; empty: the whole file); the
/// message says what is wrong, the value, and what is allowed. io adds file and line.
class InputError : public std::runtime_error {
 public:
  InputError(std::string key, const std::string& problem);
  InputError(const InputError&);
  InputError& operator=(const InputError&);
  ~InputError() override;
  [[nodiscard]] const std::string& key() const noexcept { return key_; }
  [[nodiscard]] const std::string& problem() const noexcept { return problem_; }

 private:
  std::string key_, problem_;
};

/// Several errors that were found in one go, in the order of finding. As an InputError it is the first of them.
class InputErrors : public InputError {
 public:
  /// \param all  one or more
  explicit InputErrors(std::vector<InputError> all) : InputError(all.front()), all_(std::move(all)) {}
  [[nodiscard]] const std::vector<InputError>& all() const noexcept { return all_; }

 private:
  std::vector<InputError> all_;
};

/// Collects errors of parts that can be judged each by itself, so that a user hears of all at once.
class Faults {
 public:
  /// Does a part of the work. \return whether it was done; false: its errors are kept
  template <class Part>
  bool attempt(const Part& part) {
    try {
      part();
      return true;
    } catch (const InputErrors& several) {
      for (const InputError& e : several.all()) add(e);
    } catch (const InputError& e) {
      add(e);
    }
    return false;
  }
  /// Keeps an error, unless it is there already.
  void add(const InputError& e);
  [[nodiscard]] bool any() const noexcept { return !all_.empty(); }
  [[nodiscard]] std::size_t count() const noexcept { return all_.size(); }
  /// \throw InputError the only one, InputErrors several
  void raise() const;

 private:
  std::vector<InputError> all_;
};

}  // namespace voussoir::cases
