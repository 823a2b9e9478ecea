// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <sys/stat.h>

#include <random>

#include "tests/faults/bench.h"

// What happens to runs in the world: kills, full disks, damaged files, people in a hurry. A quick selection; the long campaign is the
// script beside this file.

namespace voussoir::testing {
namespace {

// Under a limit on the size of files whatever is built with TSan and libomp ends in a bus error, one parallel loop too.
#ifdef __has_feature
constexpr bool kThreadSanitizer = __has_feature(thread_sanitizer);
#else
constexpr bool kThreadSanitizer = false;
#endif

void truncate(const std::string& path, double share) {
  fs::resize_file(path, static_cast<std::uintmax_t>(static_cast<double>(fs::file_size(path)) * share));
}

void flip_bit(const std::string& path, std::uintmax_t at) {
  std::fstream f(path, std::ios::in | std::ios::out | std::ios::binary);
  f.seekg(static_cast<std::streamoff>(at));
  const char c = static_cast<char>(f.get() ^ 16);
  f.seekp(static_cast<std::streamoff>(at));
  f.put(c);
}

}  // namespace

TEST_CASE("kills at random moments: always resumable, and the end is that of a run that was left alone") {
  Bench bench;
  REQUIRE(bench.run("straight") == 0);
  std::mt19937 random(11);
  int kills = 0;
  {
    Process p(bench.run_words("killed", {"--checkpoint-every", "0.02"}), bench.path("log"));
    bench.wait_for("killed", 1);
    p.signal(SIGKILL);
    CHECK(p.wait() == 1000 + SIGKILL);
    ++kills;
  }
  for (int code = -1; code != 0;) {
    REQUIRE(kills < 60);
    Process p(bench.resume_words("killed", {"--checkpoint-every", "0.02", "-j", std::to_string(1 + kills % 3)}), bench.path("log"));
    if (kills < 12) {
      std::this_thread::sleep_for(std::chrono::milliseconds(std::uniform_int_distribution(30, 200)(random)));
      p.signal(SIGKILL);
    }
    code = p.wait();
    if (code != 0 && code != 1000 + SIGKILL) FAIL("exit code " << code << ": " << p.text());
    kills += code != 0 ? 1 : 0;
  }
  CHECK(kills > 3);
  MESSAGE(kills << " kills");
  bench.check_same("straight", "killed");
}

TEST_CASE("SIGTERM, SIGINT and SIGUSR1 save; input files may be gone; threads may change") {
  Bench bench;
  REQUIRE(bench.run("straight") == 0);
  {
    Process p(bench.run_words("out"), bench.path("log"));
    bench.wait_for("out", 1);
    const std::string first = io::checkpoint_files(bench.path("out")).front();
    p.signal(SIGUSR1);
    bench.wait_for("out", 2);
    CHECK(io::checkpoint_files(bench.path("out")).front() != first);
    p.signal(SIGINT);
    CHECK(p.wait() == 130);
  }
  fs::remove(bench.path("wall.toml"));
  fs::remove(bench.path("y.csv"));
  CHECK(bench.resume("out", {"-j", "3"}) == 0);
  bench.check_same("straight", "out");
  CHECK(bench.resume("out") == 0);
  CHECK(bench.says("is finished"));
}

TEST_CASE("a damaged checkpoint pushes none out that is whole") {
  Bench bench;
  REQUIRE(bench.run("straight") == 0);
  bench.stop_early("out");
  const std::vector<std::string> before = io::checkpoint_files(bench.path("out"));
  REQUIRE(before.size() == 2);
  flip_bit(before[0], fs::file_size(before[0]) / 2);
  {
    Process p(bench.resume_words("out"), bench.path("log"));  // saves at its first look, then not for minutes
    bench.wait_for_another("out", before[0]);                 // and is killed
  }
  const std::string newest = io::checkpoint_files(bench.path("out")).front();
  REQUIRE(newest != before[0]);
  CHECK(fs::exists(before[1]));
  flip_bit(newest, fs::file_size(newest) / 2);
  CHECK(bench.resume("out") == 0);
  bench.check_same("straight", "out");
}

TEST_CASE("a damaged checkpoint gives way to the older one with a warning; two damaged ones to a clear error") {
  Bench bench;
  REQUIRE(bench.run("straight") == 0);
  bench.stop_early("out");
  const std::vector<std::string> files = io::checkpoint_files(bench.path("out"));
  REQUIRE(files.size() == 2);
  SUBCASE("cut off") { truncate(files[0], 0.7); }
  SUBCASE("cut off in its header") { truncate(files[0], 0.0005); }
  SUBCASE("empty") { truncate(files[0], 0.0); }
  SUBCASE("a bit of the header") { flip_bit(files[0], 30); }
  SUBCASE("a bit of the data") { flip_bit(files[0], fs::file_size(files[0]) / 2); }
  SUBCASE("a foreign HDF5 file") { fs::copy_file(bench.path("straight/run.h5"), files[0], fs::copy_options::overwrite_existing); }
  SUBCASE("a text") { std::ofstream(files[0]) << "voussoir checkpoint of my own\n"; }
  CHECK(bench.resume("out") == 0);
  CHECK(bench.says("warning"));
  bench.check_same("straight", "out");
}

TEST_CASE("nothing good to go on from is an error that says why") {
  Bench bench;
  bench.stop_early("out");
  const std::vector<std::string> files = io::checkpoint_files(bench.path("out"));
  SUBCASE("both damaged") {
    for (const std::string& f : files) truncate(f, 0.5);
    CHECK(bench.resume("out") == 3);
    CHECK(bench.says("no checkpoint that is whole"));
  }
  SUBCASE("none") {
    for (const std::string& f : files) fs::remove(f);
    CHECK(bench.resume("out") == 3);
    CHECK(bench.says("no checkpoint"));
  }
  SUBCASE("of another case") {
    bench.stop_early("other", {"--set", "materials.adobe.density=1850"});
    fs::copy_file(io::checkpoint_files(bench.path("other"))[0], files[0], fs::copy_options::overwrite_existing);
    CHECK(bench.resume("out") == 3);
    CHECK(bench.says("density = 1850"));
  }
  SUBCASE("the case beside it was edited") {
    std::ofstream(bench.path("out/case.toml"), std::ios::app) << "\n[motion]\n";
    CHECK(bench.resume("out") == 2);
  }
  SUBCASE("parts of the results are gone") {
    fs::rename(bench.path("out/parts/0000.h5"), bench.path("aside.h5"));
    CHECK((bench.resume("out") == 3 && bench.says("rows of")));
    fs::rename(bench.path("aside.h5"), bench.path("out/parts/0000.h5"));  // nothing else is lost: once it is back, the run goes on
    CHECK(bench.resume("out") == 0);
  }
  SUBCASE("the results are gone") {
    fs::remove(bench.path("out/run.h5"));
    CHECK(bench.resume("out") == 3);
    CHECK(bench.says("is missing"));
  }
  SUBCASE("no folder") { CHECK(bench.resume("nowhere") == 3); }
}

TEST_CASE("a second process on the same folder is refused") {
  Bench bench;
  Process p(bench.run_words("out", {"--duration", "1000"}), bench.path("log1"));
  bench.wait_for("out", 1);
  CHECK(bench.resume("out") == 3);
  CHECK(bench.says("in use by process"));
  CHECK(bench.run("out", {"--overwrite"}) == 3);
  p.signal(SIGTERM);
  CHECK(p.wait() == 143);
}

TEST_CASE("a limit on the size of files, as on a full disk: a clear error, and nothing lost once there is room" *
          doctest::skip(kThreadSanitizer)) {
  Bench bench;
  REQUIRE(bench.run("straight") == 0);
  const auto size = fs::file_size(io::checkpoint_files(bench.path("straight"))[0]);
  SUBCASE("results do not fit") {
    // Checkpoints fit; the part with all frames does not, nor the merged results.
    bench.stop_early("out");
    Process p(bench.resume_words("out", {"--checkpoint-every", "1000"}), bench.path("log"), size + 4096);
    const int code = p.wait();
    CHECK((code == 0 || code == 3));
    if (code == 3) CHECK(p.text().find("File too large") != std::string::npos);
  }
  SUBCASE("checkpoints do not fit") {
    Process p(bench.run_words("out"), bench.path("log"), size / 2);
    CHECK(p.wait() == 3);
    CHECK(p.text().find("File too large") != std::string::npos);
    REQUIRE(bench.run("out", {"--overwrite"}) == 0);
  }
  CHECK(bench.resume("out") == 0);
  bench.check_same("straight", "out");
}

TEST_CASE("a folder that vanishes or may not be written to ends the run with exit code 3") {
  Bench bench;
  SUBCASE("vanishes") {
    Process p(bench.run_words("out", {"--duration", "1000", "--checkpoint-every", "0.05"}), bench.path("log"));
    bench.wait_for("out", 1);
    std::error_code busy;
    while (fs::exists(bench.path("out"))) fs::remove_all(bench.path("out"), busy);
    CHECK(p.wait() == 3);
    CHECK(p.text().find("No such file") != std::string::npos);
  }
  SUBCASE("read-only") {
    ::chmod(bench.path("").c_str(), 0777);
    fs::create_directory(bench.path("out"));
    ::chmod(bench.path("out").c_str(), 0777);
    const uid_t somebody = ::geteuid() == 0 ? 65534 : 0;  // the superuser may write anywhere
    std::ofstream(bench.path("log")).close();
    ::chmod(bench.path("log").c_str(), 0666);
    Process p(bench.run_words("out", {"--duration", "1000", "--checkpoint-every", "0.05"}), bench.path("log"), 0, somebody);
    bench.wait_for("out", 1);
    ::chmod(bench.path("out").c_str(), 0555);
    ::chmod(bench.path("out/parts").c_str(), 0555);
    CHECK(p.wait() == 3);
    CHECK(p.text().find("Permission denied") != std::string::npos);
    ::chmod(bench.path("out").c_str(), 0755);
    ::chmod(bench.path("out/parts").c_str(), 0755);
  }
}

TEST_CASE("a numerical blow-up says which element, when and what to try, and saves its state") {
  Bench bench;
  CHECK(bench.run("out", {"--dt", "0.002"}) == 1);
  CHECK(bench.says("numerical failure"));
  CHECK(bench.says("element "));
  CHECK(bench.says("t = "));
  CHECK(bench.says("try --dt 0.001"));
  CHECK(fs::exists(bench.path("out/checkpoint-failed.h5")));
  CHECK_NOTHROW(io::read_checkpoint(bench.path("out/checkpoint-failed.h5")));
}

TEST_CASE("run --verify finds equal bits, and writes no results") {
  Bench bench;
  CHECK(bench.run("out", {"--verify", "--set", "block[0].fixed=true", "--scale", "0"}) == 0);
  CHECK(bench.says("the same bits"));
  CHECK_FALSE(fs::exists(bench.path("out")));
}

}  // namespace voussoir::testing
