// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "io/input/motion/spectra/figures.h"
#include "io/input/motion/synthetic/bam_like.h"
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

struct Peak {
  double got = 0.0, exact = 0.0;  // m
};
/// \param scale  of the record
Peak peak_of(const cases::Case& c, double scale = 1.0) {
  const double height = 0.2,
               frequency = std::sqrt(2.0 * c.materials.at("soft").young / c.materials.at("soft").density) / height / (2 * kPi);
  Run run(c);
  const cases::Accelerogram& record = run.motion().axis[2];
  const double end = record.dt * static_cast<double>(record.acceleration.size() - 1);
  double peak = 0.0;
  run.until(end, {}, [&] { peak = std::max(peak, std::abs(run.displacement(0).z)); });
  return {peak / scale, io::spectral_displacement(refined(record, 10), frequency, 0.05) / scale};
}

void compare(const std::string& what, const cases::Case& c) {
  const Peak peak = peak_of(c);
  expect_near("V9 peak under " + what + " [m]", peak.got, peak.exact, 1e-3);
}

constexpr double kScale =
    0.1;  // of the record: in full the softest block would sink by a third of its height, past what its points can see

/// The oscillator tuned to another frequency [Hz], under a tenth of the record.
cases::Case tuned(double frequency) {
  cases::Case c = load("oscillator").value;
  c.motion->scale = {0.0, 0.0, kScale};
  const double height = 0.2;
  cases::Material& soft = c.materials.at("soft");
  soft.young = 0.5 * soft.density * std::pow(2 * kPi * frequency * height, 2);
  c.damping.frequency = frequency;
  return c;
}

}  // namespace

TEST_CASE("V9: vertical oscillator under bam-like") { compare("bam-like, V", load("oscillator").value); }

TEST_CASE("V9: response spectrum of bam-like, V") {
  Curve curve{
      "v9_spectrum", "V9: response spectrum of bam-like, V, 5 % damping", "frequency [Hz]", "peak relative displacement [m]", true, {}};
  Series got{"computed", "o", {}, {}}, exact{"Nigam-Jennings", "-", {}, {}};
  for (const double frequency : {1.5, 2.5, 4.0, 6.5, 10.0}) {
    const Peak peak = peak_of(tuned(frequency), kScale);
    char what[80];
    std::snprintf(what, sizeof what, "V9 spectrum at %.1f Hz [m]", frequency);
    expect_near(what, peak.got, peak.exact, 1e-3);
    got.x.push_back(frequency), got.y.push_back(peak.got);
  }
  const cases::Accelerogram record = io::bam_like_1()[2];
  for (double f = 1.0; f < 15.0; f *= 1.04) {
    exact.x.push_back(f), exact.y.push_back(io::spectral_displacement(refined(record, 10), f, 0.05));
  }
  curve.series = {got, exact};
  write(curve);
}

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
