// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/session/stop_words.h"

#include <csignal>
#include <nlohmann/json.hpp>

#include "io/output/measures/place_in_run.h"

namespace voussoir::io {
namespace {

std::string name_of_signal(int signal) {
  return signal == SIGINT ? "SIGINT (Ctrl-C)" : signal == SIGTERM ? "SIGTERM" : "signal " + std::to_string(signal);
}

}  // namespace

std::string stop_lines(const cases::Case& c, double time, int signal, const std::string& folder) {
  return "stopped              " + place_in_run(c, time) + ", by " + name_of_signal(signal) +
         "\n                     what follows is how far it has come, not what comes out\nto go on             voussoir resume " + folder +
         "\n";
}

std::string stop_json(const cases::Case& c, double time, int signal, const std::string& folder) {
  return nlohmann::ordered_json{{"kind", "stopped"},
                                {"folder", folder},
                                {"time", time},
                                {"stage", stage_at(c, time)},
                                {"signal", signal},
                                {"text", place_in_run(c, time)}}
      .dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace voussoir::io
