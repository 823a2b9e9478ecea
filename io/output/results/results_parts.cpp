// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/results/results_parts.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <limits>

#include "io/input/files/output_path.h"
#include "io/input/files/sealed_pages.h"
#include "io/input/files/whole_file.h"

namespace voussoir::io {
namespace {

constexpr std::uint64_t kCopyBytes = 1024 * 1024;  // of a column in memory at a time during a merge

Shape shape_of(const ColumnSpec& c, std::uint64_t rows) {
  Shape shape{rows};
  shape.insert(shape.end(), c.row.begin(), c.row.end());
  return shape;
}

void name_values(Hdf5File& file, const ColumnSpec& c) {
  if (!c.names.empty()) file.set_attribute(c.name, "names", c.names);
}

void state_rows(Hdf5File& file, const Part& part) {
  file.set_attribute("/", "format", std::string("voussoir results"));
  file.set_attribute("/", "schema_version", kResultsSchema);
  for (std::size_t t = 0; t < kRowTables; ++t)
    file.set_attribute("/", std::string("rows_") + table_name(static_cast<RowTable>(t)), static_cast<std::int64_t>(part.rows[t]));
  file.set_attribute("/", "time_first", part.first_time);
  file.set_attribute("/", "time_last", part.last_time);
}

Part total(std::span<const Part> parts) {
  Part sum;
  if (parts.empty()) return sum;
  sum.first_time = parts.front().first_time;
  sum.last_time = parts.back().last_time;
  sum.rows = rows_of(parts);
  for (const Part& p : parts) {
    sum.first_time = std::min(sum.first_time, p.first_time);
    sum.last_time = std::max(sum.last_time, p.last_time);
  }
  return sum;
}

/// Appends to a dataset in pieces of moderate size.
class ColumnCopy {
 public:
  ColumnCopy(Hdf5File& to, const ColumnSpec& column) : to_(&to), column_(&column) {}

  void add(const Hdf5File& from, std::uint64_t rows) {
    const std::uint64_t bytes = std::max<std::uint64_t>(1, column_->row_bytes());
    for (std::uint64_t first = 0; first < rows;) {
      const std::uint64_t n = std::min(rows - first, std::max<std::uint64_t>(1, kCopyBytes / bytes));
      buffer_.resize(held_ * bytes + n * bytes);
      from.read_rows(column_->name, column_->type, first, n, buffer_.data() + held_ * bytes);
      held_ += n;
      first += n;
      if (held_ * bytes >= kCopyBytes) write();
    }
  }
  void write() {
    to_->write_rows(column_->name, column_->type, done_, held_, buffer_.data());
    done_ += held_;
    held_ = 0;
  }

 private:
  Hdf5File* to_;
  const ColumnSpec* column_;
  std::vector<std::byte> buffer_;
  std::uint64_t held_ = 0, done_ = 0;
};

}  // namespace

std::string part_name(std::size_t number) {
  std::string name(32, '\0');
  name.resize(static_cast<std::size_t>(std::snprintf(name.data(), name.size(), "parts/%04zu.h5", number)));
  return name;
}

std::uint64_t row_bytes(const RowSchema& schema, const Part& part) noexcept {
  std::uint64_t bytes = 0;
  for (std::size_t t = 0; t < kRowTables; ++t)
    for (const ColumnSpec& c : schema[t]) bytes += part.rows[t] * c.row_bytes();
  return bytes;
}

RowCounts rows_of(std::span<const Part> parts) noexcept {
  RowCounts sum{};
  for (const Part& p : parts)
    for (std::size_t t = 0; t < kRowTables; ++t) sum[t] += p.rows[t];
  return sum;
}

std::string write_file(const std::string& path, const std::function<void(Hdf5File&)>& fill, std::string temporary) {
  if (temporary.empty()) temporary = cleared(path + ".tmp");
  std::string seal;
  try {
    Hdf5File file = Hdf5File::create(temporary, kSealBytes);
    fill(file);
    file.close();
    seal = seal_text(seal_pages(temporary));
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
  replace_file(temporary, path);
  return seal;
}

Part write_part(const std::string& folder, const std::string& file, const RowSchema& schema,
                std::span<const RowBuffer, kRowTables> buffers) {
  Part part;
  part.file = file;
  part.first_time = std::numeric_limits<double>::infinity();
  part.last_time = -part.first_time;
  for (std::size_t t = 0; t < kRowTables; ++t) {
    part.rows[t] = buffers[t].rows();
    if (part.rows[t] == 0) continue;
    part.first_time = std::min(part.first_time, buffers[t].first_time());
    part.last_time = std::max(part.last_time, buffers[t].last_time());
  }
  part.seal = write_file(folder + "/" + file, [&](Hdf5File& out) {
    state_rows(out, part);
    for (std::size_t t = 0; t < kRowTables; ++t)
      for (std::size_t i = 0; part.rows[t] > 0 && i < schema[t].size(); ++i) {
        const ColumnSpec& c = schema[t][i];
        out.write_dataset(c.name, c.type, shape_of(c, part.rows[t]), buffers[t].column(i), checked_layout(c.row_bytes()));
      }
  });
  return part;
}

void link_rows(Hdf5File& file, const RowSchema& schema, std::span<const Part> parts) {
  state_rows(file, total(parts));
  std::vector<NamedPart> named;
  for (const Part& p : parts) named.push_back({p.file, p.seal});
  file.name_parts(named);
  std::vector<VirtualSource> sources;
  for (std::size_t t = 0; t < kRowTables; ++t)
    for (const ColumnSpec& c : schema[t]) {
      sources.clear();
      for (const Part& p : parts)
        if (p.rows[t] > 0) sources.push_back({p.file, c.name, p.rows[t], p.rows[t]});
      file.create_virtual(c.name, c.type, c.row, sources, c.note);
      name_values(file, c);
    }
}

void copy_rows(Hdf5File& file, const std::string& folder, const RowSchema& schema, std::span<const Part> parts) {
  const Part sum = total(parts);
  state_rows(file, sum);
  std::array<std::vector<ColumnCopy>, kRowTables> copies;
  for (std::size_t t = 0; t < kRowTables; ++t)
    for (const ColumnSpec& c : schema[t]) {
      file.create_dataset(c.name, c.type, shape_of(c, sum.rows[t]), checked_layout(c.row_bytes()), c.note);
      name_values(file, c);
      copies[t].emplace_back(file, c);
    }
  for (const Part& p : parts) {
    const Hdf5File from = Hdf5File::open(folder + "/" + p.file);
    if (from.seal() != p.seal)
      throw FileError(from.path(), "has been replaced since it was written: its seal is " + from.seal() + ", not " + p.seal);
    for (std::size_t t = 0; t < kRowTables; ++t)
      for (ColumnCopy& c : copies[t]) c.add(from, p.rows[t]);
  }
  for (auto& table : copies)
    for (ColumnCopy& c : table) c.write();
}

std::optional<PartRange> parts_to_merge(const RowSchema& schema, std::span<const Part> parts, std::uint64_t limit) {
  std::optional<PartRange> best;
  double least = 0;
  for (std::size_t first = 0; first < parts.size(); ++first) {
    std::uint64_t bytes = row_bytes(schema, parts[first]);
    for (std::size_t end = first + 1; end < parts.size(); ++end) {
      bytes += row_bytes(schema, parts[end]);
      if (bytes > limit) break;
      const auto gone = static_cast<double>(end - first);
      const double cost = static_cast<double>(bytes) / (gone * gone);
      if (best && cost >= least) continue;
      best = PartRange{first, end - first + 1};
      least = cost;
    }
  }
  return best;
}

Part merge_parts(const std::string& folder, const std::string& file, const RowSchema& schema, std::span<const Part> parts) {
  Part merged = total(parts);
  merged.file = file;
  merged.seal = write_file(folder + "/" + file, [&](Hdf5File& out) { copy_rows(out, folder, schema, parts); });
  return merged;
}

double last_time(const std::string& folder, RowTable table, std::span<const Part> parts) {
  const auto t = static_cast<std::size_t>(table);
  double time = -std::numeric_limits<double>::infinity();
  for (auto p = parts.rbegin(); p != parts.rend(); ++p) {
    if (p->rows[t] == 0) continue;
    Hdf5File::open(folder + "/" + p->file)
        .read_rows(std::string("/") + table_name(table) + "/time", Hdf5Type::f64, p->rows[t] - 1, 1, &time);
    break;
  }
  return time;
}

std::optional<std::size_t> part_number(const std::string& file) {
  std::size_t number = 0;
  const auto [end, fault] = std::from_chars(file.data(), file.data() + file.size(), number);
  if (fault != std::errc{} || std::string_view(end, file.data() + file.size()) != ".h5") return {};
  return number;
}

void remove_parts(const std::string& folder, std::span<const Part> kept) noexcept {
  namespace fs = std::filesystem;
  constexpr std::string_view kTemporary = ".tmp";
  std::error_code ignored;
  std::vector<fs::path> gone;
  fs::directory_iterator entry(folder + "/parts", ignored);
  for (; !ignored && entry != fs::directory_iterator(); entry.increment(ignored)) {
    std::string name = entry->path().filename().string();
    const bool temporary = name.ends_with(kTemporary);
    if (temporary) name.resize(name.size() - kTemporary.size());
    const bool named = std::ranges::any_of(kept, [&](const Part& p) { return p.file == "parts/" + name; });
    if (part_number(name) && (temporary || !named)) gone.push_back(entry->path());
  }
  for (const fs::path& path : gone) fs::remove(path, ignored);
  fs::remove(folder + "/parts", ignored);
}

}  // namespace voussoir::io
