// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/results/comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <set>
#include <vector>

#include "cases/input_error.h"
#include "io/input/case_file/case_file.h"
#include "io/input/files/errors.h"
#include "io/input/files/hdf5_file.h"
#include "io/output/replay/run_file.h"

namespace voussoir::io {

namespace {

constexpr std::uint64_t kComparedBytes = 4U << 20;  // of a dataset in memory at a time
constexpr double kSameTime = 1e-9;                  // s: below any step; times of runs with different steps differ by round-off

/// The paths of all datasets, except provenance.
std::set<std::string> datasets_of(const Hdf5File& file) {
  std::set<std::string> all;
  for (const std::string& path : file.datasets())
    if (!path.starts_with("/provenance/")) all.insert(path);
  return all;
}

std::uint64_t row_bytes(const Shape& shape, Hdf5Type type) {
  std::uint64_t bytes = size_of(type);
  for (std::size_t i = 1; i < shape.size(); ++i) bytes *= shape[i];
  return bytes;
}

/// Corresponding rows of two tables: (row of the first, row of the second), ascending in both.
struct RowPairs {
  std::vector<std::array<std::uint64_t, 2>> rows;
  bool same_times = true;  // the shorter table's times equal the first times of the longer one

  /// Pairs rows by number, as far as both tables have them.
  static RowPairs in_order(std::uint64_t n) {
    RowPairs p;
    for (std::uint64_t i = 0; i < n; ++i) p.rows.push_back({i, i});
    return p;
  }
  /// Pairs rows of equal time. \param a,  b times, ascending [s]
  static RowPairs at_times(const std::vector<double>& a, const std::vector<double>& b) {
    RowPairs p;
    for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
      if (std::abs(a[i] - b[j]) <= kSameTime) {
        p.same_times = p.same_times && i == j;
        p.rows.push_back({i++, j++});
      } else {
        p.same_times = false;
        a[i] < b[j] ? ++i : ++j;
      }
    }
    return p;
  }
};

/// The first pair of rows that differ in two datasets of equal type and width.
std::optional<std::array<std::uint64_t, 2>> first_pair(const Hdf5File& a, const Hdf5File& b, const std::string& name,
                                                       const RowPairs& pairs) {
  const Hdf5Type type = a.type(name);
  const std::uint64_t bytes = std::max<std::uint64_t>(1, row_bytes(a.shape(name), type));
  const std::uint64_t piece = std::max<std::uint64_t>(1, kComparedBytes / bytes);
  std::vector<std::byte> p, q;
  for (std::size_t first = 0, end = 0; first < pairs.rows.size(); first = end) {
    const auto [i, j] = pairs.rows[first];
    while (end < pairs.rows.size() && pairs.rows[end][0] - i < piece && pairs.rows[end][1] - j < piece) ++end;
    const std::uint64_t m = pairs.rows[end - 1][0] - i + 1, n = pairs.rows[end - 1][1] - j + 1;
    p.assign(m * bytes, std::byte{}), q.assign(n * bytes, std::byte{});
    a.read_rows(name, type, i, m, p.data());
    b.read_rows(name, type, j, n, q.data());
    for (std::size_t k = first; k < end; ++k)
      if (std::memcmp(p.data() + (pairs.rows[k][0] - i) * bytes, q.data() + (pairs.rows[k][1] - j) * bytes, bytes) != 0)
        return pairs.rows[k];
  }
  return std::nullopt;
}

/// The dataset of times for a dataset of a row table: `time` of the top-level group. Empty: none, as in /model.
std::string times_of(const Hdf5File& file, const std::string& dataset) {
  const std::size_t top = dataset.find('/', 1);
  if (top == std::string::npos) return "";
  const std::string time = dataset.substr(0, top) + "/time";
  return file.exists(time) && file.shape(time).size() == 1 ? time : "";
}

/// The time of a row.
std::optional<double> time_of(const Hdf5File& file, const std::string& dataset, std::uint64_t row) {
  const std::string time = times_of(file, dataset);
  if (time.empty() || row >= file.shape(time)[0]) return std::nullopt;
  double value = 0.0;
  file.read_rows(time, Hdf5Type::f64, row, 1, &value);
  return value;
}

/// The case of a run, without folders of its files.
std::string meaning_of_case(const Hdf5File& run) {
  const std::string text = run.attribute_text("/case", "toml");
  try {
    return resolved_toml(without_folders(read_case({run.path(), text}).value));
  } catch (const cases::InputError&) {
    return text;  // from another version
  }
}

class Comparer {
 public:
  Comparer(const Hdf5File& a, const Hdf5File& b) : a_(a), b_(b) {}

  Comparison all() {
    const std::set<std::string> in_a = datasets_of(a_), in_b = datasets_of(b_);
    std::set<std::string> names;
    std::ranges::set_union(in_a, in_b, std::inserter(names, names.end()));
    for (const std::string& name : names) {
      ++result_.datasets;
      if (!in_a.contains(name) || !in_b.contains(name)) {
        note({name, in_a.contains(name) ? "only in the first" : "only in the second", std::nullopt});
      } else {
        compare(name);
      }
    }
    for (const char* group : {"/", "/case", "/summary"}) compare_attributes(group);
    return result_;
  }

 private:
  void compare(const std::string& name) {
    if (a_.is_text(name) != b_.is_text(name)) return note({name, "other types", std::nullopt});
    if (a_.is_text(name)) {
      const auto p = a_.read_strings(name), q = b_.read_strings(name);
      if (p != q) note({name, "row " + std::to_string(std::ranges::mismatch(p, q).in1 - p.begin()), std::nullopt});
      return;
    }
    if (a_.type(name) != b_.type(name)) return note({name, "other types", std::nullopt});
    const Shape p = a_.shape(name), q = b_.shape(name);
    const bool rows = p.size() == q.size() && !p.empty() && std::equal(p.begin() + 1, p.end(), q.begin() + 1);
    if (p != q && !rows) return note({name, "other shapes", std::nullopt});
    const std::uint64_t m = p.empty() ? 1 : p[0], n = q.empty() ? 1 : q[0];
    const RowPairs& pairs = pairs_of(name, std::min(m, n));
    if (name == times_of(a_, name) && !pairs.same_times) return note_times(name, pairs.rows.size());
    if (const auto at = first_pair(a_, b_, name, pairs)) return note_rows(name, *at);
    if (m != n && pairs.same_times)
      note({name, std::to_string(m) + " rows and " + std::to_string(n), time_of(m > n ? a_ : b_, name, std::min(m, n))});
  }

  /// Pairs rows by time in tables with one row per time; in all others, as cracks, by number.
  const RowPairs& pairs_of(const std::string& name, std::uint64_t rows) {
    const std::string time = times_of(a_, name);
    // A group may also contain other data: /motion/factors are three numbers.
    const auto has_row_a_time = [&](const Hdf5File& file) { return file.shape(name).at(0) == file.shape(time).at(0); };
    const bool by_time =
        !time.empty() && time == times_of(b_, name) && !time.starts_with("/cracks/") && has_row_a_time(a_) && has_row_a_time(b_);
    const std::string key = by_time ? time : std::to_string(rows);
    const auto known = pairs_.find(key);
    if (known != pairs_.end()) return known->second;
    return pairs_.emplace(key, by_time ? RowPairs::at_times(a_.read<double>(time), b_.read<double>(time)) : RowPairs::in_order(rows))
        .first->second;
  }

  /// Reports different times of two runs once for the group; its other datasets are compared at common times.
  void note_times(const std::string& name, std::size_t common) {
    note({name, "other times; " + std::to_string(common) + " in common, at which the others of its group are compared", std::nullopt});
  }

  void note_rows(const std::string& name, const std::array<std::uint64_t, 2>& rows) {
    const std::string what = "row " + std::to_string(rows[0]) + (rows[0] == rows[1] ? "" : " and row " + std::to_string(rows[1]));
    const std::optional<double> in_a = time_of(a_, name, rows[0]), in_b = time_of(b_, name, rows[1]);
    note({name, what, in_a && in_b ? std::min(*in_a, *in_b) : in_a});
  }

  void compare_attributes(const std::string& group) {
    if (!a_.exists(group) || !b_.exists(group)) return;
    const auto p = a_.attributes(group), q = b_.attributes(group);
    for (const auto& [name, value] : p) {
      if (group == "/" && (name == "parts" || name == "part_seals")) continue;  // the layout of rows, not their contents
      const auto other = q.find(name);
      if (group == "/case" && name == "toml" && other != q.end() && meaning_of_case(a_) == meaning_of_case(b_)) continue;
      if (other == q.end() || other->second != value) note_attribute(group, name);
    }
    for (const auto& [name, value] : q) {
      if (!p.contains(name)) note_attribute(group, name);
    }
  }

  void note_attribute(const std::string& group, const std::string& name) {
    ++result_.differing_attributes;
    keep_first({group, "attribute " + name, std::nullopt});
  }

  void note(Difference d) {
    ++result_.differing_datasets;
    keep_first(std::move(d));
  }

  void keep_first(Difference d) {
    ++result_.differing;
    const bool is_input = d.dataset == "/case" || d.dataset.starts_with("/model/");
    if (is_input && !result_.input) result_.input = d;
    const bool earlier = !result_.first || (d.time && (!result_.first->time || *d.time < *result_.first->time));
    if (earlier) result_.first = std::move(d);
  }

  const Hdf5File &a_, &b_;
  std::map<std::string, RowPairs> pairs_;  // by dataset of times, else by number of rows
  Comparison result_;
};

}  // namespace

Comparison compare_files(const std::string& a, const std::string& b) {
  const Hdf5File p = open_run(a), q = open_run(b);
  return Comparer(p, q).all();
}

}  // namespace voussoir::io
