// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/verification/manual.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>

namespace voussoir::testing {
namespace {

using Json = nlohmann::ordered_json;

/// The running test case.
struct Running {
  std::string test;
  std::vector<std::string> cases;
  std::clock_t since = 0;  // processor time: the machine may be shared
};
Running& running() {
  static Running r;
  return r;
}

void append(const Json& line) {
  const char* path = std::getenv("VOUSSOIR_MANUAL");
  if (path == nullptr) return;
  std::ofstream(path, std::ios::app) << line.dump() << '\n';
}

/// Knows which test case runs, and how long it took.
struct Clock final : doctest::IReporter {
  explicit Clock(const doctest::ContextOptions&) {}
  void report_query(const doctest::QueryData&) override {}
  void test_run_start() override {}
  void test_run_end(const doctest::TestRunStats&) override {}
  void test_case_start(const doctest::TestCaseData& t) override { running() = {t.m_name, {}, std::clock()}; }
  void test_case_reenter(const doctest::TestCaseData&) override {}
  void test_case_end(const doctest::CurrentTestCaseStats& s) override {
    const double took = static_cast<double>(std::clock() - running().since) / CLOCKS_PER_SEC;
    append({{"test", running().test}, {"cases", running().cases}, {"seconds", took}, {"passed", s.testCaseSuccess}});
  }
  void test_case_exception(const doctest::TestCaseException&) override {}
  void subcase_start(const doctest::SubcaseSignature&) override {}
  void subcase_end() override {}
  void log_assert(const doctest::AssertData&) override {}
  void log_message(const doctest::MessageData&) override {}
  void test_case_skipped(const doctest::TestCaseData&) override {}
};
REGISTER_LISTENER("manual", 1, Clock);

}  // namespace

void write(const ManualRow& r) {
  append({{"test", running().test},
          {"row", r.what},
          {"kind", r.kind},
          {"expected", r.expected},
          {"got", r.got},
          {"error", r.error},
          {"limit", r.limit}});
}

void write(const Curve& c) {
  Json series = Json::array();
  for (const Series& s : c.series) series.push_back({{"name", s.name}, {"style", s.style}, {"x", s.x}, {"y", s.y}});
  append({{"test", running().test},
          {"curve", c.file},
          {"title", c.title},
          {"x", c.x},
          {"y", c.y},
          {"logarithmic", c.logarithmic},
          {"series", series}});
}

void note_case(const std::string& name) {
  std::vector<std::string>& cases = running().cases;
  if (std::find(cases.begin(), cases.end(), name) == cases.end()) cases.push_back(name);
}

}  // namespace voussoir::testing
