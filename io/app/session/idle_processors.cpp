// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/session/idle_processors.h"

#include <sched.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>

namespace voussoir::io {

namespace {

constexpr auto kLook = std::chrono::milliseconds{100};  // the system's clock ticks are hundredths of a second

/// Predicate for the processors on which this thread may run. All count if the system does not tell, as with more than 1,024 processors.
std::function<bool(int)> usable_processors() {
  cpu_set_t set;
  CPU_ZERO(&set);
  if (sched_getaffinity(0, sizeof set, &set) != 0) return [](int) { return true; };
  return [set](int processor) { return processor < CPU_SETSIZE && CPU_ISSET(processor, &set); };
}

}  // namespace

ProcessorTimes read_processor_times(std::istream& stat, const std::function<bool(int)>& counts) {
  constexpr int kFields = 8, kIdleField = 3, kWaitingField = 4;  // user nice system idle iowait irq softirq steal
  ProcessorTimes t;
  for (std::string line; std::getline(stat, line);) {
    std::istringstream words(line);
    std::string name;
    words >> name;
    constexpr std::size_t kName = 3;  // a line "cpu" without a number is the sum of all
    if (!name.starts_with("cpu") || name.size() == kName || !counts(std::atoi(name.c_str() + kName))) continue;
    ++t.processors;
    double ticks = 0.0;
    for (int i = 0; i < kFields && words >> ticks; ++i) {
      t.all += ticks;
      if (i == kIdleField || i == kWaitingField) t.idle += ticks;
    }
  }
  return t;
}

double idle_between(const ProcessorTimes& before, const ProcessorTimes& after) {
  const double all = after.all - before.all;
  return all > 0.0 ? (after.idle - before.idle) / all * after.processors : 0.0;
}

double idle_processors() {
  const std::function<bool(int)> counts = usable_processors();
  const auto now = [&] {
    std::ifstream file("/proc/stat");
    return read_processor_times(file, counts);
  };
  // Measured, since the system's load average would include an earlier run.
  const ProcessorTimes before = now();
  std::this_thread::sleep_for(kLook);
  return idle_between(before, now());
}

}  // namespace voussoir::io
