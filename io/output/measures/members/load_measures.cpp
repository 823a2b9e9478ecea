// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/members/load_measures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>

#include "geometry/message.h"
#include "geometry/nth.h"
#include "geometry/vec3.h"
#include "io/input/files/errors.h"
#include "io/input/files/hdf5_file.h"
#include "io/output/replay/frame_reader.h"
#include "io/output/replay/run_file.h"

namespace voussoir::io {
namespace {

/// The first row that is the largest but for round-off: a force that turns with its block has nearly the same size in every row.
std::size_t first_largest(const std::vector<double>& force) {
  const double least = (1.0 - 1e-9) * *std::ranges::max_element(force);
  return static_cast<std::size_t>(std::ranges::find_if(force, [&](double f) { return f >= least; }) - force.begin());
}

/// Where each load acts, from /loads: "on NAME, at (x, y, z) m", or at how many places.
class Places {
 public:
  explicit Places(const Hdf5File& run) : origin_(origin_of_run(run)) {
    if (!run.exists("/loads/load")) return;
    load_ = run.read<std::int32_t>("/loads/load"), element_ = run.read<std::int32_t>("/loads/element");
    point_ = run.read<double>("/loads/point"), tags_ = run.read_strings("/model/element/tag");
    if (element_.size() != load_.size() || point_.size() != 3 * load_.size()) throw FileError(run.path(), "/loads does not fit together");
  }
  [[nodiscard]] std::string of(std::int32_t load) const {
    std::vector<std::size_t> rows;
    std::set<std::string> names;
    for (std::size_t i = 0; i < load_.size(); ++i)
      if (load_[i] == load) rows.push_back(i), names.insert(nth(tags_, element_[i]));
    if (rows.empty()) return {};
    std::string text = "on " + (names.size() == 1 ? *names.begin() : std::to_string(names.size()) + " parts");
    if (rows.size() > 1) return text + ", at " + std::to_string(rows.size()) + " places";
    const double* p = point_.data() + 3 * rows.front();
    const auto rounded = [](double v) { return std::round(100.0 * v) / 100.0 + 0.0; };  // no sign for a shown zero
    return text +
           geometry::printed(", at (%.2f, %.2f, %.2f) m", rounded(p[0] + origin_.x), rounded(p[1] + origin_.y), rounded(p[2] + origin_.z));
  }

 private:
  Vec3 origin_;
  std::vector<std::int32_t> load_, element_;
  std::vector<double> point_;
  std::vector<std::string> tags_;
};

LoadMeasures measures_of(const LoadCurve& c) {
  LoadMeasures m{.name = c.name, .place = c.place};
  const std::size_t most = first_largest(c.force);
  m.peak_force = c.force[most], m.peak_force_time = c.time[most], m.displacement_at_peak = c.displacement[most];
  for (std::size_t i = 0; i < c.time.size(); ++i) {
    if (std::isnan(c.displacement[i]) || std::abs(c.displacement[i]) <= std::abs(m.peak_displacement))
      continue;  // NaN: none so far, so not skipped
    m.peak_displacement = c.displacement[i], m.peak_displacement_time = c.time[i], m.force_at_peak_displacement = c.force[i];
  }
  m.end_force = c.force.back(), m.end_displacement = c.displacement.back();
  return m;
}

}  // namespace

std::vector<LoadCurve> load_curves(const Hdf5File& run) {
  if (!run.exists("/loaded/force")) return {};
  const auto time = run.read<double>("/history/time"), force = run.read<double>("/loaded/force"),
             moved = run.read<double>("/loaded/displacement");
  if (time.empty()) return {};
  const std::size_t loads = force.size() / (3 * time.size());
  if (force.size() != 3 * loads * time.size() || moved.size() != force.size()) throw FileError(run.path(), "/loaded does not fit together");
  const Places places(run);
  std::vector<LoadCurve> curves;
  for (std::size_t k = 0; k < loads; ++k) {
    const auto at = [&](const std::vector<double>& v, std::size_t row) {
      const double* p = v.data() + 3 * (row * loads + k);
      return Vec3{p[0], p[1], p[2]};
    };
    std::vector<double> size;
    for (std::size_t i = 0; i < time.size(); ++i) size.push_back(norm(at(force, i)));
    const Vec3 most = at(force, first_largest(size));
    if (!(norm(most) > 0.0)) continue;
    LoadCurve& c = curves.emplace_back();
    c.name = "load " + std::to_string(k + 1), c.place = places.of(static_cast<std::int32_t>(k)), c.time = time;
    const Vec3 along = (1.0 / norm(most)) * most;
    for (std::size_t i = 0; i < time.size(); ++i)
      c.force.push_back(dot(at(force, i), along)), c.displacement.push_back(dot(at(moved, i), along));
  }
  return curves;
}

std::vector<LoadMeasures> load_measures(const Hdf5File& run) {
  std::vector<LoadMeasures> out;
  for (const LoadCurve& c : load_curves(run)) out.push_back(measures_of(c));
  return out;
}

}  // namespace voussoir::io
