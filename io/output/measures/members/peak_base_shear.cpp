// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/members/peak_base_shear.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "io/input/files/errors.h"
#include "io/input/files/hdf5_file.h"

namespace voussoir::io {

PeakBaseShear peak_base_shear(const Hdf5File& run) {
  const auto time = run.read<double>("/forces/time"), shear = run.read<double>("/forces/base_shear");
  if (shear.size() != 3 * time.size()) throw FileError(run.path(), "/forces does not fit together");
  PeakBaseShear peak;
  for (std::size_t i = 0; i < time.size(); ++i) {
    const double now = std::hypot(shear[3 * i], shear[3 * i + 1]);
    if (now > peak.value) peak = {now, time[i]};
  }
  if (run.has_attribute("/summary", "peak_base_shear"))
    peak.value = std::max(peak.value, run.attribute_double("/summary", "peak_base_shear"));
  return peak;
}

double PeakBaseShear::over(double weight) const noexcept { return weight > 0 ? value / weight : std::numeric_limits<double>::quiet_NaN(); }

double weight_of(const Hdf5File& run, double gravity) {
  const auto mass = run.read<double>("/model/element/mass");
  const auto fixed = run.read<std::uint8_t>("/model/element/fixed");
  if (fixed.size() != mass.size()) throw FileError(run.path(), "/model/element does not fit together");
  double sum = 0.0;
  for (std::size_t e = 0; e < mass.size(); ++e)
    if (fixed[e] == 0) sum += mass[e];
  return sum * gravity;
}

}  // namespace voussoir::io
