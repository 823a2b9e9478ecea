// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <chrono>
#include <sstream>
#include <thread>

#include "io/output/results/checkpoints.h"
#include "io/output/results/comparison.h"
#include "tests/io/temp_folder.h"

/// The program as users run it: in a process of its own, on a folder that holds a small case.
namespace voussoir::testing {

namespace fs = std::filesystem;

/// The program in a process of its own.
class Process {
 public:
  /// \param file_limit  bytes that a file may have, 0: no limit \param user  to become, 0: oneself
  Process(const std::vector<std::string>& words, const std::string& log, rlim_t file_limit = 0, uid_t user = 0) : log_(log) {
    pid_ = ::fork();
    REQUIRE(pid_ >= 0);
    if (pid_ > 0) return;
    // Not by stdio, which would write what the tests have said so far a second time.
    const int file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    ::dup2(file, 1);
    ::dup2(file, 2);
    const rlimit limit{file_limit, file_limit};
    if (file_limit > 0) ::setrlimit(RLIMIT_FSIZE, &limit);
    if (user > 0 && ::setuid(user) != 0) ::_exit(99);
    std::vector<char*> argv{const_cast<char*>(VOUSSOIR_PROGRAM)};
    for (const std::string& w : words) argv.push_back(const_cast<char*>(w.c_str()));
    argv.push_back(nullptr);
    ::execv(argv[0], argv.data());
    ::_exit(98);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process() {
    if (pid_ > 0) signal(SIGKILL), wait();
  }

  void signal(int number) const { ::kill(pid_, number); }
  /// Exit code; 1000 and the signal that ended it.
  int wait() {
    int status = 0;
    ::waitpid(pid_, &status, 0);
    pid_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
  }
  [[nodiscard]] std::string text() const {
    std::ostringstream t;
    t << std::ifstream(log_).rdbuf();
    return t.str();
  }

 private:
  std::string log_;
  pid_t pid_ = -1;
};

/// A folder with the case, and what is done in it.
struct Bench {
  TempFolder folder;
  Bench() {
    for (const char* name : {"wall.toml", "y.csv"})
      fs::copy_file(VOUSSOIR_SOURCE_DIR "/tests/faults/data/" + std::string(name), path(name));
  }

  [[nodiscard]] std::string path(const std::string& name) const { return folder.path(name); }
  [[nodiscard]] std::vector<std::string> run_words(const std::string& out, std::vector<std::string> more = {}) const {
    std::vector<std::string> w{"run", path("wall.toml"), "--quiet", "-j", "1", "-o", path(out)};
    w.insert(w.end(), more.begin(), more.end());
    return w;
  }
  [[nodiscard]] std::vector<std::string> resume_words(const std::string& out, std::vector<std::string> more = {}) const {
    std::vector<std::string> w{"resume", path(out), "--quiet"};
    w.insert(w.end(), more.begin(), more.end());
    return w;
  }
  int run(const std::string& out, std::vector<std::string> more = {}) { return finish(run_words(out, std::move(more))); }
  int resume(const std::string& out, std::vector<std::string> more = {}) { return finish(resume_words(out, std::move(more))); }
  int finish(const std::vector<std::string>& words) {
    Process p(words, path("log"));
    const int code = p.wait();
    text = p.text();
    return code;
  }
  /// Runs, and stops with a signal once it shakes.
  void stop_early(const std::string& out, std::vector<std::string> more = {}) {
    more.insert(more.end(), {"--checkpoint-simulated", "0.1"});
    Process p(run_words(out, std::move(more)), path("log"));
    wait_for(out, 2);
    p.signal(SIGTERM);
    CHECK(p.wait() == 143);
  }
  /// Until a run has that many checkpoints, or ten seconds.
  void wait_for(const std::string& out, std::size_t checkpoints) const {
    for (int i = 0; i < 1000; ++i) {
      if (fs::is_directory(path(out)) && io::checkpoint_files(path(out)).size() >= checkpoints) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }
  /// Until a newer checkpoint than that, or ten seconds.
  void wait_for_another(const std::string& out, const std::string& newest) const {
    for (int i = 0; i < 2000 && io::checkpoint_files(path(out)).front() == newest; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  [[nodiscard]] bool says(const std::string& part) const {
    if (text.find(part) != std::string::npos) return true;
    MESSAGE("missing '" << part << "' in: " << text);
    return false;
  }
  void check_same(const std::string& a, const std::string& b) const {
    const io::Comparison c = io::compare_files(path(a + "/run.h5"), path(b + "/run.h5"));
    if (c.first) MESSAGE("first difference: " << c.first->dataset << " " << c.first->what);
    CHECK(c.datasets > 60);
    CHECK(c.differing == 0);
  }

  std::string text;  // of the last process
};

}  // namespace voussoir::testing
