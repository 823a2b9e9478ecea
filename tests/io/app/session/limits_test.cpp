// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

// Limits on memory, stack and processes: a line that says what is lacking, and a documented exit code; or fewer threads and the same bits.

namespace {

using shell::Outcome;
using shell::voussoir;

constexpr const char* kCase = R"(title = "a block"
[gravity]
settle = false
[time]
duration = 0.01
[materials.stone]
density = 2000.0
young = 1e8
poisson = 0.2
[joints]
default = "dry"
[base]
z = 0.0
[[block]]
name = "a"
material = "stone"
box = [[0, 0, 0], [0.2, 0.2, 0.2]]
)";

struct Place {
  TempFolder folder;
  std::string file = folder.write("case.toml", kCase);
  [[nodiscard]] std::string run(const std::string& words) const {
    return "run " + shell::quoted(file) + " --quiet --overwrite -o " + shell::quoted(folder.path("out")) + " " + words;
  }
};

std::string hash_in(const std::string& text) { return text.substr(std::min(text.find("state hash"), text.size()), 40); }

/// Most memory of the program [bytes].
double most_memory(const std::string& words) {
  const std::string command = "exec " + shell::kProgram + " " + words + " > /dev/null 2>&1";
  const pid_t child = ::fork();
  if (child == 0) {
    ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    ::_exit(127);
  }
  int status = -1;
  rusage use{};
  REQUIRE(::wait4(child, &status, 0, &use) == child);
  CAPTURE(words);
  CHECK(status == 0);
  return 1024.0 * static_cast<double>(use.ru_maxrss);
}

}  // namespace

TEST_CASE("limits: more threads than a limit on memory or processes allows are fewer, with a warning and the same bits") {
  if (shell::kSanitizer) return;
  const Place place;
  const std::string hash = hash_in(voussoir(place.run("-j 1")).text);
  REQUIRE(hash.size() == 40);
  std::string before[] = {"ulimit -v 400000 && ", ""};
  // The superuser has no limit on processes, so somebody else runs the program.
  if (::geteuid() == 0 && shell::code_of("setpriv --reuid=65534 --clear-groups true") == 0 &&
      shell::code_of("setpriv --reuid=65534 --clear-groups test -x " + shell::kProgram) == 0) {
    std::filesystem::permissions(place.folder.path(), std::filesystem::perms::all);
    std::filesystem::remove_all(place.folder.path("out"));
    before[1] = "prlimit --nproc=20 setpriv --reuid=65534 --clear-groups ";
  }
  for (const std::string& limit : before) {
    if (limit.empty()) continue;
    const Outcome o = voussoir(place.run("-j 1024"), limit);
    CAPTURE(o.text);
    CHECK(o.code == 0);
    CHECK(o.text.find("warning: of 1024 threads the system gives ") != std::string::npos);
    CHECK(hash_in(o.text) == hash);
    std::filesystem::remove_all(place.folder.path("out"));
  }
}

TEST_CASE("limits: where memory ends, one line says what was done") {
  if (shell::kSanitizer) return;
  const Place place;
  // Limits from one under which the program does not start to one that it does not notice.
  int lacking = 0, good = 0;
  for (int kilobytes = 44000; kilobytes <= 84000; kilobytes += 500) {
    const Outcome o = voussoir(place.run("-j 1"), "ulimit -v " + std::to_string(kilobytes) + " && ");
    CAPTURE(kilobytes);
    CAPTURE(o.text);
    // Of the system: its libraries do not fit, or one of them (GnuTLS, which HDF5 brings) cannot start.
    if (o.code == 127 || o.text.starts_with("Error in GnuTLS initialization")) continue;
    good += o.code == 0;
    if (o.code == 0) continue;
    CHECK(o.code == 3);
    ++lacking;
    CHECK(o.text.find("voussoir: out of memory while ") != std::string::npos);
    CHECK(o.text.find("MB are in use, ulimit -v allows") != std::string::npos);
  }
  CHECK(lacking > 0);
  CHECK(good > 0);
}

TEST_CASE("limits: a small stack is made larger, or refused before anything is done") {
  if (shell::kSanitizer) return;
  const Place place;
  for (const char* kilobytes : {"64", "256", "1000"}) {
    const Outcome o = voussoir(place.run("-j 2"), std::string("ulimit -s ") + kilobytes + " && ");
    CAPTURE(o.text);
    CHECK(o.code == 3);
    CHECK(o.text == std::string("voussoir: the stack is limited to ") + kilobytes + " kB (ulimit -s); 1024 kB at least are needed\n");
    CHECK(voussoir(place.run("-j 2"), std::string("ulimit -S -s ") + kilobytes + " && ").code == 0);
  }
  CHECK_FALSE(voussoir(place.run("-j 2"), "ulimit -s 1024 && ").code != 0);
}

// A tenth above what was measured (perf/LOG.md, memory of models): 116 and 104 MB, where 14 are those of the program.
TEST_CASE("limits: a row of four houses, 17,052 elements, takes no more memory to check and to run than it did") {
  if (shell::kSanitizer) return;
  const Place place;
  const std::string row = " flat20n -j 1 --set house.copies=[4,1] --set house.spacing=[8.0,6.0] --set gravity.settle=false ";
  CHECK(most_memory("check" + row) < 128e6);
  CHECK(most_memory("run" + row + "--set time.duration=0.005 --quiet --overwrite -o " + shell::quoted(place.folder.path("out"))) < 115e6);
}
