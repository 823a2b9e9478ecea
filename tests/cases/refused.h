// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>

#include <functional>
#include <string>

#include "cases/case.h"
#include "cases/model.h"

namespace voussoir::testing {

/// A good case, changed: it must be refused at this key, with words that say so.
inline void check_refused(cases::Case c, const std::function<void(cases::Case&)>& change, const std::string& key, const std::string& says) {
  CAPTURE(key);
  CAPTURE(says);
  change(c);
  std::string got, problem = "nothing was refused";
  try {
    cases::build_model(c);
  } catch (const cases::InputError& e) {
    got = e.key(), problem = e.problem();
  }
  CHECK(got == key);
  CAPTURE(problem);
  CHECK(problem.find(says) != std::string::npos);
}

/// The same of its house.
inline void check_refused(const cases::Case& c, const std::function<void(cases::House&)>& change, const std::string& key,
                          const std::string& says) {
  check_refused(c, std::function<void(cases::Case&)>([&](cases::Case& whole) { change(*whole.house); }), key, says);
}

}  // namespace voussoir::testing
