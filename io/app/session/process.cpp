// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/session/process.h"

#include <sys/resource.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <new>

#include "io/app/session/exit_code.h"

namespace voussoir::io {
namespace {

/// Raises the limit of open files: the rows of a long unfinished run are in many files, and a virtual dataset holds each of them open.
void open_many_files() {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  setrlimit(RLIMIT_NOFILE, &limit);
}

std::terminate_handler handler_before = nullptr;

[[noreturn]] void end_by_terminate() {
  try {
    if (std::current_exception()) std::rethrow_exception(std::current_exception());
  } catch (const std::bad_alloc& e) {
    std::_Exit(end_unexpectedly(e));
  } catch (...) {  // a fault of the program: end as without this handler, with a core dump
  }
  handler_before();
  std::abort();
}

}  // namespace

void prepare_process() {
  handler_before = std::set_terminate(end_by_terminate);
  std::signal(SIGXFSZ, SIG_IGN);
  open_many_files();
}

int code_after_output(int code) {
  std::cout.flush();
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good()) return code;
  std::fprintf(stderr, "voussoir: standard output cannot be written\n");
  return code == kDone ? kFileFault : code;
}

int end_unexpectedly(const std::exception& e) {
  const bool memory = dynamic_cast<const std::bad_alloc*>(&e) != nullptr;
  std::fprintf(stderr, "voussoir: %s\n", memory ? "out of memory" : e.what());
  return kFileFault;
}

}  // namespace voussoir::io
