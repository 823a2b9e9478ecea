// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/faults/bench.h"

// Runs that are resumed to a later end, or although they have ended.

namespace voussoir::testing {
namespace {

TEST_CASE("--until goes on to where a longer run would have come") {
  Bench bench;
  REQUIRE(bench.run("long", {"--duration", "0.45"}) == 0);
  REQUIRE(bench.run("short", {"--duration", "0.2037"}) == 0);
  CHECK(bench.resume("short", {"--until", "0.1"}) == 2);
  CHECK(bench.says("--until"));
  for (const char* never : {"inf", "nan", "1e300"}) CHECK(bench.resume("short", {"--until", never}) == 2);
  CHECK(bench.resume("short", {"--until", "0.45"}) == 0);
  bench.check_same("long", "short");
}

TEST_CASE("a resume sent further and killed before its first checkpoint is gone on with to the later end") {
  Bench bench;
  REQUIRE(bench.run("long", {"--duration", "0.45"}) == 0);
  REQUIRE(bench.run("short", {"--duration", "0.2037"}) == 0);
  const std::string saved = io::checkpoint_files(bench.path("short")).front(), kept = bench.path("kept.h5");
  fs::copy_file(saved, kept);
  {
    Process p(bench.resume_words("short", {"--until", "0.45"}), bench.path("log"));
    bench.wait_for_another("short", saved);  // and is killed
  }
  for (const std::string& path : io::checkpoint_files(bench.path("short"))) fs::remove(path);
  fs::rename(kept, saved);
  CHECK(bench.resume("short") == 0);
  bench.check_same("long", "short");
}

TEST_CASE("parts that a kill at the very end has left beside the results of a finished run are removed by resume") {
  Bench bench;
  REQUIRE(bench.run("done") == 0);
  fs::create_directory(bench.path("done/parts"));
  fs::copy_file(bench.path("done/run.h5"), bench.path("done/parts/0011.h5"));
  CHECK(bench.resume("done") == 0);
  CHECK(bench.says("done is finished, to 1."));
  CHECK_FALSE(fs::exists(bench.path("done/parts")));
}

TEST_CASE("a run that its collapse has ended is finished, and --until goes on to where it would have come without") {
  Bench bench;
  REQUIRE(bench.run("whole") == 0);
  bench.stop_early("stopped", {"--set", "time.after_collapse=0.05"});
  CHECK(bench.resume("stopped", {"--until", "1.0"}) == 2);  // nothing has collapsed yet: its end is its duration
  CHECK(bench.says("allowed: more than 1.4"));
  REQUIRE(bench.run("cut", {"--set", "time.after_collapse=0.05"}) == 0);
  CHECK(bench.resume("cut") == 0);
  CHECK(bench.says("cut is finished, to 0."));
  CHECK(bench.resume("cut", {"--until", "0.3"}) == 2);
  CHECK(bench.says("allowed: more than 0."));
  CHECK(bench.resume("cut", {"--until", "1.4"}) == 0);
  bench.check_same("whole", "cut");
}

}  // namespace
}  // namespace voussoir::testing
