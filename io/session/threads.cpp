// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/session/threads.h"

#include <omp.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <thread>

namespace voussoir::io {

namespace {

constexpr const char* kQuiet = "10000";  // turns
constexpr const char* kBusy = "100";
constexpr double kAtWork = 0.3;                         // of one processor's time, on a quiet machine, whatever it has
constexpr auto kLook = std::chrono::milliseconds{100};  // the system counts in hundredths of a second

/// Since the machine was started, of all processors together.
struct ProcessorTimes {
  double idle = 0.0, all = 0.0;  // ticks
};
ProcessorTimes processor_times() {
  std::ifstream file("/proc/stat");
  std::string cpu;
  file >> cpu;
  ProcessorTimes t;
  constexpr int kFields = 8, kIdleField = 3, kWaitingField = 4;  // user nice system idle iowait irq softirq steal
  for (int i = 0; i < kFields; ++i) {
    double ticks = 0.0;
    file >> ticks;
    t.all += ticks;
    if (i == kIdleField || i == kWaitingField) t.idle += ticks;
  }
  return t;
}

// Not by the load of the last minute: the run before this one would count.
bool machine_is_quiet() {
  const ProcessorTimes before = processor_times();
  std::this_thread::sleep_for(kLook);
  const ProcessorTimes after = processor_times();
  const double all = after.all - before.all, idle = after.idle - before.idle;
  return all > 0.0 && (all - idle) * static_cast<double>(sysconf(_SC_NPROCESSORS_ONLN)) < kAtWork * all;
}

}  // namespace

void let_threads_sleep(char** argv, bool watch) {
  for (const char* name : {"OMP_WAIT_POLICY", "GOMP_SPINCOUNT", "KMP_BLOCKTIME"}) {
    if (std::getenv(name) != nullptr) return;
  }
  setenv("GOMP_SPINCOUNT", watch && machine_is_quiet() ? kQuiet : kBusy, 1);
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
  return text + (std::string(turns) == kBusy ? std::string(" (GOMP_SPINCOUNT=") + kQuiet + " on a quiet machine)" : "");
}

}  // namespace voussoir::io
