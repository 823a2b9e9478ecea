// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/results/provenance.h"

#include <array>
#include <ctime>
#include <fstream>
#include <sstream>
#include <thread>

#include "io/input/files/hdf5_file.h"
#include "solver/state/saved_state.h"

#if !defined(VOUSSOIR_VERSION) || !defined(VOUSSOIR_FLAGS)
#error "io/output/CMakeLists.txt defines these for this source"
#endif

namespace voussoir::io {
namespace {

std::string compiler() {
#ifdef __clang__
  return std::string("clang ") + __clang_version__;
#else
  return std::string("gcc ") + __VERSION__;
#endif
}

std::string cpu_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (!line.starts_with("model name")) continue;
    const std::size_t from = line.find_first_not_of(" \t", line.find(':') + 1);
    if (from != std::string::npos) return line.substr(from);
  }
  return "unknown";
}

}  // namespace

std::string without_paths(const std::string& flags) {
  std::istringstream words(flags);
  std::string kept;
  for (std::string word; words >> word;)
    if (word.find('/') == std::string::npos) kept += (kept.empty() ? "" : " ") + word;
  return kept;
}

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  std::array<char, 32> text{};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts)};
}

std::string program_version() { return VOUSSOIR_VERSION " (physics " + std::to_string(solver::kPhysicsVersion) + ")"; }

Provenance provenance(int threads) {
  Provenance p;
  p.version = program_version();
  p.compiler = without_paths(compiler());
  p.flags = without_paths(VOUSSOIR_FLAGS);
  p.cpu = cpu_name();
  p.cores = static_cast<int>(std::thread::hardware_concurrency());
  p.threads = threads;
  p.started = utc_now();
  return p;
}

void write_provenance(Hdf5File& file, const Provenance& p, double wall_clock) {
  const std::string at = "/provenance";
  file.make_group(at);
  file.set_attribute(at, "version", p.version);
  file.set_attribute(at, "compiler", p.compiler);
  file.set_attribute(at, "flags", p.flags);
  file.set_attribute(at, "cpu", p.cpu);
  file.set_attribute(at, "cores", std::int64_t{p.cores});
  file.set_attribute(at, "threads", std::int64_t{p.threads});
  file.set_attribute(at, "started", p.started);
  file.set_attribute(at, "ended", p.ended);
  file.set_attribute(at, "written", utc_now());
  file.set_attribute(at, "wall_clock", wall_clock);
  file.set_attribute(at, "units", std::string("wall_clock: s, of this process until this file was written; dates: UTC"));
}

}  // namespace voussoir::io
