// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/motion/spectra/demand_spectrum.h"

#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <system_error>

#include "cases/input_error.h"
#include "io/input/motion/formats/read_motion.h"
#include "io/input/motion/spectra/figures.h"
#include "io/input/motion/spectra/target_file.h"

namespace voussoir::io {
namespace {

constexpr const char* kRecord = "record:";
constexpr double kLeastSteps = 3.0;        // of a record in a period: below, its samples do not show the oscillator's peak
constexpr double kLongestOfRecord = 50.0;  // s, of a record's spectrum

double squared(double x) { return x * x; }

}  // namespace

std::optional<double> acceleration_at(const DemandSpectrum& d, double period, double damping) {
  if (!(period >= 0.0)) return {};
  if (d.record) {
    if (!(period >= kLeastSteps * d.record->dt && period <= kLongestOfRecord)) return {};
    return squared(2.0 * std::numbers::pi / period) * spectral_displacement(*d.record, 1.0 / period, damping);
  }
  const std::optional<double> value = value_at(d.target, period, damping);
  if (!value || d.target.code) return value;
  return *value * damping_factor(damping) / damping_factor(d.damping);
}

std::optional<double> displacement_at(const DemandSpectrum& d, double period, double damping) {
  const std::optional<double> a = acceleration_at(d, period, damping);
  if (!a) return {};
  return *a * squared(period / (2.0 * std::numbers::pi));
}

std::string demand_file(const std::string& words) {
  const std::string start(kRecord);
  if (is_eurocode8(words)) return {};
  if (!words.starts_with(start)) return words;
  std::error_code error;
  const std::string path = words.substr(start.size());
  return std::filesystem::exists(path, error) ? path : path.substr(0, path.rfind('#'));
}

DemandSpectrum read_demand(const std::string& words, double damping, std::optional<double> corner, const std::optional<std::string>& unit,
                           const std::string& option) {
  DemandSpectrum d;
  d.damping = damping;
  const std::string start(kRecord);
  if (words.starts_with(start)) {
    const std::string path = words.substr(start.size());
    d.record = read_accelerogram(path, {unit});
    d.name = start + std::filesystem::path(path).filename().string();
  } else {
    d.target = read_target(words, unit, option);
    d.name = d.target.name;
  }
  if (d.target.code && corner)
    throw cases::InputError("--corner-period", "does not go with a spectrum of EN 1998-1, which states it; leave it out");
  d.corner = d.target.code ? eurocode8_corner(*d.target.code) : corner.value_or(std::numeric_limits<double>::quiet_NaN());
  return d;
}

}  // namespace voussoir::io
