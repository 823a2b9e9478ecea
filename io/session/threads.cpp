// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/session/threads.h"

#include <omp.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "io/session/idle_processors.h"

namespace voussoir::io {

namespace {

constexpr const char* kQuiet = "10000";  // turns
constexpr const char* kBusy = "100";
constexpr double kAtWork = 0.3;  // of one processor's time, on a quiet machine, whatever it has

}  // namespace

bool room_for(int threads, double idle_processors) { return idle_processors > threads - kAtWork; }

void let_threads_sleep(char** argv, int threads, bool watch) {
  for (const char* name : {"OMP_WAIT_POLICY", "GOMP_SPINCOUNT", "KMP_BLOCKTIME"}) {
    if (std::getenv(name) != nullptr) return;
  }
  setenv("GOMP_SPINCOUNT", watch && room_for(threads > 0 ? threads : omp_get_max_threads(), idle_processors()) ? kQuiet : kBusy, 1);
  setenv("KMP_BLOCKTIME", "0", 1);
  std::error_code none;
  const std::string self = std::filesystem::read_symlink("/proc/self/exe", none).string();
  execv(self.c_str(), argv);  // returns only if it could not
}

void use_threads(int threads) {
  if (threads > 0) omp_set_num_threads(threads);
}

std::string waiting_threads() {
  const char* turns = std::getenv("GOMP_SPINCOUNT");
  if (turns == nullptr) return "as the OpenMP runtime has it";
  const std::string text = "spin " + std::string(turns) + " turns, then sleep";
  return text + (std::string(turns) == kBusy ? std::string(" (GOMP_SPINCOUNT=") + kQuiet + " where each has a processor to itself)" : "");
}

}  // namespace voussoir::io
