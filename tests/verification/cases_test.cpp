// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/verification/fixture.h"

// A problem of the manual is a case that a user can run.
namespace voussoir::testing {

TEST_CASE("every case of cases/verification builds and steps") {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(VOUSSOIR_SOURCE_DIR) + "/cases/verification")) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem());
  }
  std::sort(names.begin(), names.end());
  CHECK(names.size() > 20);
  for (const std::string& name : names) {
    CAPTURE(name);
    Run run(name);
    CHECK(!run.description().title.empty());
    CHECK(!run.description().source.empty());
    CHECK(!run.description().output.history.empty());
    for (int i = 0; i < 10; ++i) run.cycle({});
    CHECK(std::isfinite(norm(run.displacement(0))));
  }
}

}  // namespace voussoir::testing
