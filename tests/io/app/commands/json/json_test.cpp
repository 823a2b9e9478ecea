// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

// What commands print with --format json, where their text has a table.
namespace {

using Json = nlohmann::json;

Json json_of(const std::string& words) {
  const shell::Outcome o = shell::run(shell::kProgram + " " + words + " --format json 2>/dev/null");
  INFO(words << ": " << o.text);
  REQUIRE(o.code == 0);
  REQUIRE(Json::accept(o.text));
  return Json::parse(o.text);
}

}  // namespace

TEST_CASE("format json: cases and motion") {
  const Json cases = json_of("cases");
  CHECK(std::ranges::any_of(cases, [](const Json& c) { return c["name"] == "flat20n" && !c["title"].get<std::string>().empty(); }));
  const Json motion = json_of("motion bam-like");
  REQUIRE(motion.size() == 3);
  CHECK(motion[0]["component"] == "L");
  CHECK(motion[0]["peak_acceleration"].get<double>() > 1.0);
  CHECK(motion[0]["stated_peak"].is_null());
  CHECK(shell::voussoir("motion bam-like --format json --intensity 0.3").code == 2);
}

TEST_CASE("format json: check and modes") {
  const Json check = json_of("check arch -j 1");
  double volume = 0.0;
  std::int64_t count = 0;
  for (const Json& line : check["bill"]) volume += line["volume"].get<double>(), count += line["count"].get<std::int64_t>();
  CHECK(count == check["elements"]);
  CHECK(volume >= check["volume"].get<double>() * (1 - 1e-12));  // that of fixed blocks, too
  CHECK(!check["parts"].empty());
  CHECK(check["run_seconds"].get<double>() > 0.0);
  CHECK(check["faults"].empty());

  const Json modes = json_of("modes arch --count 4 --no-impulse --closed -j 1");
  REQUIRE(modes["modes"].size() == 4);
  CHECK(modes["modes"][0]["frequency"].get<double>() <= modes["modes"][3]["frequency"].get<double>());
  CHECK(modes["modes"][0]["mass_share"].size() == 3);
  CHECK(modes["impulse"].is_null());
  CHECK(modes["main"].is_object());
}
