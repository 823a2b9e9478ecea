// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/members/tie_measures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "io/input/files/errors.h"
#include "io/input/files/hdf5_file.h"

namespace voussoir::io {
namespace {

/// Rows of the ties, or of the decks and meshes, of a run.
class TieRows {
 public:
  /// \param group  "/ties/" or "/meshes/" \param columns  number of them
  TieRows(const Hdf5File& run, std::string group, std::size_t columns)
      : run_(run), group_(std::move(group)), columns_(columns), time_(run.read<double>("/history/time")) {}

  [[nodiscard]] bool empty() const noexcept { return time_.empty(); }
  [[nodiscard]] const std::vector<double>& time() const noexcept { return time_; }

  template <class T>
  [[nodiscard]] std::vector<T> read(const std::string& name) const {
    std::vector<T> values = run_.read<T>(group_ + name);
    if (values.size() != columns_ * time_.size()) throw FileError(run_.path(), group_ + name + " does not fit together");
    return values;
  }
  /// Row of the value of largest magnitude in a column, the first of equals.
  [[nodiscard]] std::size_t peak(std::span<const double> values, std::size_t column) const {
    std::size_t row = 0;
    for (std::size_t i = 1; i < time_.size(); ++i)
      if (std::abs(values[i * columns_ + column]) > std::abs(values[row * columns_ + column])) row = i;
    return row;
  }
  template <class T>
  [[nodiscard]] double last(const std::vector<T>& values, std::size_t column) const {
    return static_cast<double>(values[(time_.size() - 1) * columns_ + column]);
  }
  [[nodiscard]] double at(std::span<const double> values, std::size_t row, std::size_t column) const {
    return values[row * columns_ + column];
  }

 private:
  const Hdf5File& run_;
  std::string group_;
  std::size_t columns_;
  std::vector<double> time_;
};

void put_peaks(const TieRows& rows, const std::vector<double>& force, const std::vector<double>& elongation, std::size_t column,
               TieMeasures& to) {
  const std::size_t row = rows.peak(force, column);
  to.peak_force = rows.at(force, row, column), to.peak_time = rows.time()[row];
  to.peak_elongation = rows.at(elongation, rows.peak(elongation, column), column);
}

void add_ties(const Hdf5File& run, std::vector<TieMeasures>& out) {
  const std::vector<std::string> names = run.read_strings("/model/tie");
  const TieRows rows(run, "/ties/", names.size());
  if (rows.empty()) return;
  const auto force = rows.read<double>("force"), elongation = rows.read<double>("elongation"), plastic = rows.read<double>("plastic");
  const auto broken = rows.read<std::uint8_t>("broken");
  std::vector<double> strength(names.size(), TieMeasures::kNone);
  if (run.exists("/model/tie_strength")) strength = run.read<double>("/model/tie_strength");
  if (strength.size() != names.size()) throw FileError(run.path(), "/model/tie_strength does not fit together");
  for (std::size_t k = 0; k < names.size(); ++k) {
    TieMeasures& m = out.emplace_back();
    m.name = names[k];
    put_peaks(rows, force, elongation, k, m);
    m.plastic = rows.last(plastic, k), m.broken = rows.last(broken, k);
    m.yielded = m.broken == 0 && m.plastic != 0 ? 1 : 0;
    m.utilisation = std::abs(m.peak_force) / strength[k];
  }
}

void add_groups(const Hdf5File& run, std::vector<TieMeasures>& out) {
  const std::vector<std::string> names = run.read_strings("/model/mesh");
  const TieRows rows(run, "/meshes/", names.size());
  if (rows.empty()) return;
  const auto force = rows.read<double>("force"), elongation = rows.read<double>("elongation"), used = rows.read<double>("utilisation");
  const auto bars = run.read<std::int64_t>("/model/mesh_bars");
  if (bars.size() != names.size()) throw FileError(run.path(), "/model/mesh_bars does not fit together");
  const auto yielded = rows.read<std::int64_t>("yielded"), broken = rows.read<std::int64_t>("broken");
  for (std::size_t k = 0; k < names.size(); ++k) {
    TieMeasures& m = out.emplace_back();
    m.name = names[k], m.bars = static_cast<double>(bars.at(k));
    put_peaks(rows, force, elongation, k, m);
    m.utilisation = rows.at(used, rows.peak(used, k), k);
    m.yielded = rows.last(yielded, k), m.broken = rows.last(broken, k);
  }
}

}  // namespace

std::vector<TieMeasures> tie_measures(const Hdf5File& run) {
  std::vector<TieMeasures> out;
  if (run.exists("/ties/force")) add_ties(run, out);
  if (run.exists("/meshes/force")) add_groups(run, out);
  return out;
}

}  // namespace voussoir::io
