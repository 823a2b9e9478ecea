// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "io/app/session/progress.h"
#include "io/input/messages/messages.h"

namespace voussoir::io {
namespace {

/// Messages are JSON during its lifetime.
struct AsJson {
  AsJson() { say_as_json(true); }
  AsJson(const AsJson&) = delete;
  AsJson& operator=(const AsJson&) = delete;
  ~AsJson() { say_as_json(false); }
};

}  // namespace

TEST_CASE("progress as JSON: an object a line, figure by figure") {
  const AsJson json;
  CHECK(Progress::mode_for(2, true) == Progress::Mode::quiet);
  REQUIRE(Progress::mode_for(2, false) == Progress::Mode::json);
  std::ostringstream out;
  Progress progress(out, Progress::Mode::json);
  for (int i = 0; i <= 10; ++i) progress.update({.time = 0.1 * i, .end_time = 10, .step = 1000 * i, .broken = 7, .residual = 1e-6}, i);
  progress.finish();
  std::istringstream lines(out.str());
  int count = 0;
  nlohmann::json last;
  for (std::string line; std::getline(lines, line); ++count) last = nlohmann::json::parse(line);
  CHECK(count == 10);  // one is due each time but the first; none is left for the end
  CHECK(last["kind"] == "progress");
  CHECK(last["time"].get<double>() == doctest::Approx(1.0));
  CHECK(last["end"] == 10.0);
  CHECK(last["settling"] == false);
  CHECK(last["steps_per_second"].get<double>() == doctest::Approx(1000.0));
  CHECK(last["seconds_left"].get<double>() == doctest::Approx(90.0));
  CHECK(last["broken"] == 7);
  CHECK(last["residual"] == 1e-6);
  CHECK(last["states"].is_null());
  CHECK(last["text"].get<std::string>().starts_with("1.000 of 10 s  1,000 steps/s"));
}

TEST_CASE("progress as JSON: what is not known is null") {
  const auto told = [](const ProgressState& s) { return nlohmann::json::parse(progress_json(s, 0.0, std::nullopt)); };
  const nlohmann::json settling = told({.time = -0.5, .end_time = 10, .settling = true});
  CHECK(settling["end"].is_null());
  CHECK(settling["seconds_left"].is_null());
  const nlohmann::json resting = told({.time = 3.0, .end_time = 10, .states = 12, .factor = 0.2, .unbalanced = 3e-4});
  CHECK(resting["states"] == 12);
  CHECK(resting["factor"] == 0.2);
  CHECK(resting["end"].is_null());
}

}  // namespace voussoir::io
