// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/session/threads.h"

#include <omp.h>
#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <system_error>
#include <vector>

#include "io/app/session/idle_processors.h"

namespace voussoir::io {

namespace {

constexpr const char* kQuiet = "10000";  // turns
constexpr const char* kBusy = "100";
constexpr double kAtWork = 0.3;  // of one processor: load of a quiet machine

// With OMP_PROC_BIND, OMP_PLACES or GOMP_CPU_AFFINITY the runtime has bound this thread to one place already. The restarted program would
// inherit that, and find one processor for all its threads.
void unbind() {
  int most = 0;
  std::vector<int> processors;
  for (int place = 0; place < omp_get_num_places(); ++place) {
    std::vector<int> here(static_cast<std::size_t>(omp_get_place_num_procs(place)));
    omp_get_place_proc_ids(place, here.data());
    for (const int id : here) processors.push_back(id), most = std::max(most, id);
  }
  if (processors.empty()) return;
  const std::size_t count = static_cast<std::size_t>(most) + 1, size = CPU_ALLOC_SIZE(count);
  const std::unique_ptr<cpu_set_t, void (*)(cpu_set_t*)> set(CPU_ALLOC(count), [](cpu_set_t* s) { CPU_FREE(s); });
  CPU_ZERO_S(size, set.get());
  for (const int id : processors) CPU_SET_S(static_cast<std::size_t>(id), size, set.get());
  sched_setaffinity(0, size, set.get());
}

}  // namespace

bool room_for(int threads, double idle_processors) { return idle_processors > threads - kAtWork; }

void let_threads_sleep(char** argv, int threads, bool watch) {
  for (const char* name : {"OMP_WAIT_POLICY", "GOMP_SPINCOUNT", "KMP_BLOCKTIME"}) {
    if (std::getenv(name) != nullptr) return;
  }
  unbind();
  setenv("GOMP_SPINCOUNT", watch && room_for(threads > 0 ? threads : omp_get_max_threads(), idle_processors()) ? kQuiet : kBusy, 1);
  setenv("KMP_BLOCKTIME", "0", 1);
  std::error_code none;
  const std::string self = std::filesystem::read_symlink("/proc/self/exe", none).string();
  execv(self.c_str(), argv);  // returns only on failure
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
