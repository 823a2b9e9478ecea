// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/commands/compare_command.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "io/case_file/case_file.h"
#include "io/commands/compared_measures.h"
#include "io/commands/summary_command.h"
#include "io/files/errors.h"
#include "io/files/hdf5_file.h"

namespace voussoir::io {

namespace {

constexpr std::uint64_t kPieceBytes = 4U << 20;  // of a dataset in memory at a time

/// Paths of all datasets below a group, provenance apart.
void list_datasets(const Hdf5File& file, const std::string& group, std::set<std::string>& all) {
  for (const std::string& name : file.children(group.empty() ? "/" : group)) {
    const std::string path = group + "/" + name;
    if (path == "/provenance") continue;
    if (file.is_group(path)) {
      list_datasets(file, path, all);
    } else {
      all.insert(path);
    }
  }
}

std::uint64_t row_bytes(const Shape& shape, Hdf5Type type) {
  std::uint64_t bytes = size_of(type);
  for (std::size_t i = 1; i < shape.size(); ++i) bytes *= shape[i];
  return bytes;
}

/// The first row in which two datasets of one shape and type differ.
std::optional<std::uint64_t> first_row(const Hdf5File& a, const Hdf5File& b, const std::string& name) {
  const Shape shape = a.shape(name);
  const Hdf5Type type = a.type(name);
  const std::uint64_t rows = shape.empty() ? 1 : shape[0], bytes = std::max<std::uint64_t>(1, row_bytes(shape, type));
  const std::uint64_t piece = std::max<std::uint64_t>(1, kPieceBytes / bytes);
  std::vector<std::byte> p, q;
  for (std::uint64_t first = 0; first < rows; first += piece) {
    const std::uint64_t n = std::min(piece, rows - first);
    p.assign(n * bytes, std::byte{}), q.assign(n * bytes, std::byte{});
    a.read_rows(name, type, first, n, p.data());
    b.read_rows(name, type, first, n, q.data());
    const auto [at, other] = std::ranges::mismatch(p, q);
    if (at != p.end()) return first + static_cast<std::uint64_t>(at - p.begin()) / bytes;
  }
  return std::nullopt;
}

/// The time of a row: that of the dataset `time` beside it, or beside the group it is in.
std::optional<double> time_of(const Hdf5File& file, const std::string& dataset, std::uint64_t row) {
  const std::size_t top = dataset.find('/', 1);
  if (top == std::string::npos) return std::nullopt;
  const std::string time = dataset.substr(0, top) + "/time";
  if (!file.exists(time)) return std::nullopt;
  const Shape shape = file.shape(time);
  if (shape.size() != 1 || row >= shape[0]) return std::nullopt;
  double value = 0.0;
  file.read_rows(time, Hdf5Type::f64, row, 1, &value);
  return value;
}

/// The case of a run, wherever the files that it names lie.
std::string meaning_of_case(const Hdf5File& run) {
  const std::string text = run.attribute_text("/case", "toml");
  try {
    return resolved_toml(without_folders(read_case({run.path(), text}).value));
  } catch (const cases::InputError&) {
    return text;  // of another version
  }
}

class Comparer {
 public:
  Comparer(const Hdf5File& a, const Hdf5File& b) : a_(a), b_(b) {}

  Comparison all() {
    std::set<std::string> in_a, in_b, names;
    list_datasets(a_, "", in_a);
    list_datasets(b_, "", in_b);
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
    const bool only_rows = p.size() == q.size() && !p.empty() && std::equal(p.begin() + 1, p.end(), q.begin() + 1);
    if (p != q && only_rows) {
      const std::string what = std::to_string(p[0]) + " rows and " + std::to_string(q[0]);
      return note({name, what, time_of(p[0] > q[0] ? a_ : b_, name, std::min(p[0], q[0]))});
    }
    if (p != q) return note({name, "other shapes", std::nullopt});
    if (const auto row = first_row(a_, b_, name)) note({name, "row " + std::to_string(*row), time_of(a_, name, *row)});
  }

  void compare_attributes(const std::string& group) {
    if (!a_.exists(group) || !b_.exists(group)) return;
    const auto p = a_.attributes(group), q = b_.attributes(group);
    for (const auto& [name, value] : p) {
      if (group == "/" && name == "parts") continue;  // how the rows are kept, not what they are
      const auto other = q.find(name);
      if (group == "/case" && name == "toml" && other != q.end() && meaning_of_case(a_) == meaning_of_case(b_)) continue;
      if (other == q.end() || other->second != value) note({group, "attribute " + name, std::nullopt});
    }
    for (const auto& [name, value] : q) {
      if (!p.contains(name)) note({group, "attribute " + name, std::nullopt});
    }
  }

  void note(Difference d) {
    ++result_.differing;
    const bool earlier = !result_.first || (d.time && (!result_.first->time || *d.time < *result_.first->time));
    if (earlier) result_.first = std::move(d);
  }

  const Hdf5File &a_, &b_;
  Comparison result_;
};

std::string results_of(const std::string& path) { return std::filesystem::is_directory(path) ? path + "/run.h5" : path; }

std::string summary_of(const std::string& path) { return summary_json(Hdf5File::open(path)); }

std::string as_json(const Comparison& c, const std::string& a, const std::string& b) {
  using Json = nlohmann::ordered_json;
  Json out{
      {"identical", c.differing == 0}, {"datasets", c.datasets}, {"differing", c.differing}, {"first", nullptr}, {"measures", nullptr}};
  if (c.first) {
    out["first"] = Json{{"dataset", c.first->dataset}, {"what", c.first->what}, {"time", nullptr}};
    if (c.first->time) out["first"]["time"] = *c.first->time;
  }
  try {
    out["measures"] = Json::parse(measures_beside_json(summary_of(a), summary_of(b)));
  } catch (const FileError&) {  // no runs: null
  }
  return out.dump(1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

Comparison compare_files(const std::string& a, const std::string& b) {
  const Hdf5File p = Hdf5File::open(a), q = Hdf5File::open(b);
  return Comparer(p, q).all();
}

int compare_command(const std::string& a, const std::string& b, bool json) {
  const Comparison c = compare_files(results_of(a), results_of(b));
  const bool same = c.differing == 0;
  if (json) {
    std::printf("%s\n", as_json(c, results_of(a), results_of(b)).c_str());
    return same ? 0 : 1;
  }
  if (same) {
    std::printf("identical: %zu datasets\n", c.datasets);
    return 0;
  }
  std::printf("different: %zu of %zu datasets and attributes\n", c.differing, c.datasets);
  std::printf("first: %s, %s", c.first->dataset.c_str(), c.first->what.c_str());
  if (c.first->time) std::printf(", at %.6f s", *c.first->time);
  std::printf("\n");
  try {
    std::printf("\n%s", measures_beside(summary_of(results_of(a)), summary_of(results_of(b))).c_str());
  } catch (const FileError& e) {
    std::printf("\nno measures: %s\n", e.what());  // files that are no runs can be compared, too
  }
  return 1;
}

}  // namespace voussoir::io
