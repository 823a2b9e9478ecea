// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/report_plots.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace voussoir::io::page;

TEST_CASE("a long curve of the page keeps its peaks, and its times fit") {
  Values time(90001), value(2 * time.size(), 0.0);
  for (std::size_t i = 0; i < time.size(); ++i) time[i] = 0.001 * static_cast<double>(i);
  value[2 * 40001 + 1] = 7.0;
  value[2 * 77777 + 1] = -3.0;
  const Values t = thinned(time), y = thinned(value, 1, 2, 10);
  CHECK(t.size() <= 20000);
  REQUIRE(y.size() == t.size());
  CHECK(t.back() == 90.0);
  CHECK(std::ranges::is_sorted(t));
  const auto high = std::ranges::max_element(y), low = std::ranges::min_element(y);
  CHECK(*high == 70.0);
  CHECK(*low == -30.0);
  CHECK(std::abs(t[static_cast<std::size_t>(high - y.begin())] - 40.001) < 0.01);
  CHECK(std::abs(t[static_cast<std::size_t>(low - y.begin())] - 77.777) < 0.01);
}

TEST_CASE("a short curve of the page keeps all rows, a long one numbers among what is none") {
  const Values all = thinned({1.23456789, 2.0, 3.0});
  REQUIRE(all.size() == 3);
  CHECK(all[0] == doctest::Approx(1.23457).epsilon(1e-12));
  CHECK(all[2] == doctest::Approx(3.0).epsilon(1e-12));
  Values value(50000, std::numeric_limits<double>::quiet_NaN());
  value[30003] = 5.0;
  const Values y = thinned(value);
  CHECK(std::ranges::count(y, 5.0) == 1);
}
