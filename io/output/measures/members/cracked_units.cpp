// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/members/cracked_units.h"

#include <algorithm>
#include <set>
#include <vector>

#include "geometry/nth.h"
#include "io/input/files/errors.h"
#include "io/input/files/hdf5_file.h"

namespace voussoir::io {
namespace {

constexpr double kAll = 1.0 - 1e-6;  // share of a joint's area that counts as all of it

}  // namespace

CrackedUnits cracked_units(const Hdf5File& run) {
  CrackedUnits out;
  if (!run.exists("/model/element/unit")) return out;
  const auto unit = run.read<std::int32_t>("/model/element/unit");
  const auto a = run.read<std::int32_t>("/model/joint/element_a"), b = run.read<std::int32_t>("/model/joint/element_b");
  const auto area = run.read<double>("/model/joint/area"), broken = run.read<double>("/cracks/area");
  const auto joint = run.read<std::int32_t>("/cracks/joint");
  const auto bad = [&](std::int32_t j) { return j < 0 || static_cast<std::size_t>(j) >= a.size(); };
  const auto wild = [&](std::int32_t e) { return e < -1 || e >= static_cast<std::int32_t>(unit.size()); };
  if (b.size() != a.size() || area.size() != a.size() || broken.size() != joint.size() || std::ranges::any_of(joint, bad) ||
      std::ranges::any_of(a, wild) || std::ranges::any_of(b, wild))
    throw FileError(run.path(), "/cracks and /model/joint do not fit together");
  out.units = 1 + std::max(-1, *std::ranges::max_element(unit));
  out.cells = std::ranges::count_if(unit, [](std::int32_t u) { return u >= 0; });
  const auto unit_of = [&](std::int32_t j) {
    return nth(a, j) < 0 || nth(b, j) < 0 || nth(unit, nth(a, j)) != nth(unit, nth(b, j)) ? -1 : nth(unit, nth(a, j));
  };
  std::vector<double> lost(a.size(), 0.0);
  std::set<std::int32_t> cracked, through;
  for (std::size_t i = 0; i < joint.size(); ++i) {
    const std::int32_t u = unit_of(joint[i]);
    if (u < 0) continue;
    cracked.insert(u);
    double& gone = nth(lost, joint[i]);
    gone += broken[i];
    if (gone >= kAll * nth(area, joint[i])) through.insert(u);
  }
  out.cracked = static_cast<std::int64_t>(cracked.size()), out.through = static_cast<std::int64_t>(through.size());
  return out;
}

}  // namespace voussoir::io
