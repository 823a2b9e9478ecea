// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/session/process.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

using namespace voussoir;

namespace {

/// How a process ends of which a second thread throws, and what it says.
template <class Throw>
std::pair<int, std::string> end_of(Throw thrown) {
  const TempFolder folder;
  const std::string said = folder.path("said");
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(::open(said.c_str(), O_WRONLY | O_CREAT, 0600), STDERR_FILENO);
    std::signal(SIGABRT, SIG_DFL);  // doctest has a handler of its own
    io::prepare_process();
    std::thread(thrown).join();
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return {status, shell::text_of(said)};
}

}  // namespace

TEST_CASE("process: out of memory in a thread ends it with a message and the code of a file error") {
  io::now_doing("building the model");
  const auto [status, said] = end_of([] { throw std::bad_alloc(); });
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 3);
  CHECK(said.starts_with("voussoir: out of memory while building the model; "));
  CHECK(said.ends_with(" MB are in use\n"));
}

TEST_CASE("process: a fault of the program in a thread aborts, with what it says") {
  const auto [status, said] = end_of([] { throw std::logic_error("a fault"); });
  CHECK(WIFSIGNALED(status));
  CHECK(WTERMSIG(status) == SIGABRT);
  CHECK(said.find("a fault") != std::string::npos);
}
