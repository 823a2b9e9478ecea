// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/results/provenance.h"

#include <array>
#include <ctime>
#include <fstream>
#include <sstream>
#include <thread>

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

}  // namespace voussoir::io
