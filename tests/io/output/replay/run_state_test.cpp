// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/replay/run_state.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <atomic>
#include <thread>

#include "io/input/files/run_folder.h"
#include "io/output/replay/run_file.h"
#include "tests/io/results_fixture.h"

namespace voussoir::io {

using namespace test;

TEST_CASE("a run says whether it goes on, was left, or is a copy") {
  const TempFolder dir, copy;
  const auto state = [&] { return run_state(open_run(dir.path())); };
  {
    const RunFolder folder = RunFolder::create(dir.path(), false);
    ResultsWriter w(dir.path(), two_cubes(), kCase, kNames, provenance(1), by_hand());
    record(w, 0);
    w.flush();
    CHECK(state().end == RunEnd::goes_on);
    CHECK(state().words.find("rows written until 20") == 0);
    CHECK(state().words.find("the run goes on (process " + std::to_string(::getpid()) + ")") != std::string::npos);
    std::filesystem::copy_file(dir.file("run.h5"), copy.file("run.h5"));
  }
  CHECK(state().end == RunEnd::left);
  CHECK(state().words.find("stopped or killed") != std::string::npos);
  CHECK(run_state(open_run(copy.path())).end == RunEnd::unknown);
  {
    ResultsOptions options = by_hand();
    options.earlier = EarlierRows{1e9, {}};
    ResultsWriter w(dir.path(), two_cubes(), kCase, kNames, provenance(1), options);
    w.failure("too fast");
    w.flush();
    CHECK(state().end == RunEnd::lost);
    w.finish();
  }
  CHECK(state().end == RunEnd::finished);
  CHECK(state().words.empty());
}

TEST_CASE("readers that look at the lock keep no run from starting") {
  const TempFolder dir;
  { const RunFolder folder = RunFolder::create(dir.path(), false); }
  std::atomic<bool> ends = false;
  std::thread reader([&] {
    while (!ends) static_cast<void>(holder_of(dir.path()));
  });
  for (int i = 0; i < 2000; ++i) CHECK_NOTHROW(RunFolder::open(dir.path()));
  ends = true;
  reader.join();
}

}  // namespace voussoir::io
