// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>

#include "tests/verification/fixture.h"

// V9: one block on its joint with the base is an oscillator; its peak under a record is known exactly.
namespace voussoir::testing {
namespace {

/// The same piecewise linear record with `parts` samples for one, so that its peak response is caught between the samples.
cases::Accelerogram refined(const cases::Accelerogram& a, int parts) {
  cases::Accelerogram fine{a.name, a.dt / parts, {}};
  const auto n = (a.acceleration.size() - 1) * static_cast<std::size_t>(parts) + 1;
  for (std::size_t i = 0; i < n; ++i) fine.acceleration.push_back(cases::acceleration_at(a, static_cast<double>(i) * fine.dt));
  return fine;
}

void compare(const std::string& what, const cases::Case& c) {
  const double height = 0.2,
               frequency = std::sqrt(2.0 * c.materials.at("soft").young / c.materials.at("soft").density) / height / (2 * kPi);
  Run run(c);
  const cases::Accelerogram& record = run.motion().axis[2];
  const double end = record.dt * static_cast<double>(record.acceleration.size() - 1);
  double peak = 0.0;
  run.until(end, {}, [&] { peak = std::max(peak, std::abs(run.displacement(0).z)); });
  expect_near("V9 peak under " + what + " [m]", peak, cases::spectral_displacement(refined(record, 10), frequency, 0.05), 1e-3);
}

}  // namespace

TEST_CASE("V9: vertical oscillator under bam-like") { compare("bam-like, V", load("oscillator").value); }

TEST_CASE("V9: vertical oscillator under a real record") {
  const std::string folder = std::string(VOUSSOIR_SOURCE_DIR) + "/../shared/records/northridge1994_rinaldi/";
  if (!std::filesystem::exists(folder)) {
    MESSAGE("skipped: no real records in ", folder);
    return;
  }
  cases::Case c = load("oscillator").value;
  for (const char* component : {"RSN1063_NORTHR_RRS-UP.AT2", "RSN1063_NORTHR_RRS228.AT2"}) {
    c.motion.emplace().xyz[2] = folder + component;
    compare(component, c);
  }
}

}  // namespace voussoir::testing
