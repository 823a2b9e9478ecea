// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/session/threads.h"

#include <doctest/doctest.h>
#include <omp.h>

#include <set>
#include <sstream>

#include "io/app/session/idle_processors.h"
#include "tests/io/shell.h"

using namespace voussoir;

namespace {

// Between the two, processor 0 was at work (10 ticks of user), 1 waited for a disk, 2 was idle, and the host took 3 away for half of the
// time.
constexpr const char* kBefore = R"(cpu  1000 0 100 4000 20 0 0 7 0 0
cpu0 250 0 25 1000 5 0 0 1 0 0
cpu1 250 0 25 1000 5 0 0 2 0 0
cpu2 250 0 25 1000 5 0 0 2 0 0
cpu3 250 0 25 1000 5 0 0 2 0 0
intr 12345 0 0
ctxt 678
)";
constexpr const char* kAfter = R"(cpu  1010 0 100 4015 30 0 0 12 0 0
cpu0 260 0 25 1000 5 0 0 1 0 0
cpu1 250 0 25 1000 15 0 0 2 0 0
cpu2 250 0 25 1010 5 0 0 2 0 0
cpu3 250 0 25 1005 5 0 0 7 0 0
intr 12399 0 0
ctxt 699
)";

double idle(const std::function<bool(int)>& counts) {
  std::istringstream before(kBefore), after(kAfter);
  return io::idle_between(io::read_processor_times(before, counts), io::read_processor_times(after, counts));
}

}  // namespace

TEST_CASE("idle processors are those that nobody used, among those that count") {
  CHECK(idle([](int) { return true; }) == doctest::Approx(2.5));
  CHECK(idle([](int n) { return n < 2; }) == doctest::Approx(1.0));
  CHECK(idle([](int n) { return n == 0; }) == 0.0);
  CHECK(idle([](int) { return false; }) == 0.0);
}

TEST_CASE("no time between two readings, or a system that does not say: none is idle") {
  std::istringstream once(kBefore), again(kBefore), nothing("");
  const auto all = [](int) { return true; };
  CHECK(io::idle_between(io::read_processor_times(once, all), io::read_processor_times(again, all)) == 0.0);
  CHECK(io::read_processor_times(nothing, all).processors == 0);
}

TEST_CASE("threads have room where each has an idle processor, however busy the others are") {
  CHECK(io::room_for(8, 15.0));  // another program on one of sixteen processors
  CHECK_FALSE(io::room_for(16, 15.0));
  CHECK(io::room_for(16, 15.8));  // what goes on at any time
  CHECK(io::room_for(2, 1.9));
  CHECK_FALSE(io::room_for(2, 1.5));
  CHECK_FALSE(io::room_for(4, 2.0));  // more threads than processors
}

TEST_CASE("threads that OpenMP is told to bind have a processor each") {
  if (omp_get_num_procs() < 2) return;
  for (const char* bound : {"OMP_PROC_BIND=close", "OMP_PLACES=cores", ""}) {
    CAPTURE(bound);
    const std::string told = std::string("env ") + bound + " OMP_DISPLAY_AFFINITY=TRUE OMP_AFFINITY_FORMAT='threads on %A' ";
    std::istringstream said(shell::run(told + shell::kProgram + " bench flat20n -j 2 --steps 1 --batches 1 2>&1").text);
    std::multiset<std::string> processors;
    for (std::string line; std::getline(said, line);) {
      if (line.starts_with("threads on ")) processors.insert(line);
    }
    REQUIRE(processors.size() >= 2);
    const bool apart = std::set(processors.begin(), processors.end()).size() >= 2;
    CHECK(apart == (*bound != '\0'));  // unbound ones may each use all
  }
}
