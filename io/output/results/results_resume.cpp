// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <limits>

#include "io/input/files/errors.h"
#include "io/output/replay/values/run_values.h"
#include "io/output/replay/values/value_rules.h"
#include "io/output/results/results_parts.h"

/// Resuming with the results of an earlier run: which parts are kept, and up to which row.
namespace voussoir::io {
namespace {

constexpr std::int64_t kUnsealed = kSealedSchema - 1;  // the same layout without seals
constexpr const char* kCutFrom = "cut_from";           // attribute of a part: the seal of the one whose first rows it has
constexpr std::uint64_t kPieceBytes = 1024 * 1024;     // of a column in memory at a time during a check

std::string time_column(std::size_t table) { return std::string("/") + table_name(static_cast<RowTable>(table)) + "/time"; }

void check_columns(const Hdf5File& file, const TableSpec& columns, std::uint64_t rows) {
  for (const ColumnSpec& c : columns) {
    Shape expected{rows};
    expected.insert(expected.end(), c.row.begin(), c.row.end());
    if (!file.exists(c.name)) throw FileError(file.path(), c.name + " is missing: the run had other histories");
    if (file.shape(c.name) != expected || file.type(c.name) != c.type)
      throw FileError(file.path(), c.name + " has another shape: the run had another model");
  }
}

/// Whether times rise and rotations are ones; not the other rows, which may be those of a run that was lost.
void inspect(const Hdf5File& part, const std::string& dataset, Hdf5Type type, std::uint64_t first, std::uint64_t rows, const void* data) {
  const ValueRule* rule = rule_of(dataset);
  if (rule != nullptr && rule->values != Values::row) io::check_values(part, dataset, type, first, rows, data);
}

/// Reads all values, which checks their checksums now instead of at the end of a long run.
void read_values(const Hdf5File& file, const TableSpec& columns, std::uint64_t rows) {
  std::vector<std::byte> buffer;
  for (const ColumnSpec& c : columns) {
    const std::uint64_t piece = std::max<std::uint64_t>(1, kPieceBytes / std::max<std::uint64_t>(1, c.row_bytes()));
    for (std::uint64_t first = 0; first < rows; first += piece) {
      const std::uint64_t n = std::min(piece, rows - first);
      buffer.resize(n * c.row_bytes());
      file.read_rows(c.name, c.type, first, n, buffer.data());
    }
  }
}

/// Parts that run.h5 names, with their seals; none if it holds all rows, is of an earlier version or not there.
std::vector<NamedPart> named_parts(const std::string& folder) {
  const std::string run = folder + "/run.h5";
  return std::filesystem::exists(run) ? Hdf5File::open(run).named_parts() : std::vector<NamedPart>();
}

/// Refuses a part that is not the one that run.h5 names; it may be what an earlier resume has left of that one, before it was killed.
void check_seal(const Hdf5File& part, const std::string& named) {
  if (named.empty() || part.seal() == named) return;
  if (part.has_attribute("/", kCutFrom) && part.attribute_text("/", kCutFrom) == named) return;
  throw FileError(part.path(), "is not the part that run.h5 was written with: it is of another run, or of another time of this one");
}

Part read_part(const std::string& folder, const std::string& name, const std::string& seal, const RowSchema& schema) {
  Hdf5File file = Hdf5File::open(folder + "/" + name);
  file.inspect(inspect);
  if (!file.has_attribute("/", "schema_version")) throw FileError(file.path(), "holds no results of voussoir");
  if (const std::int64_t version = file.attribute_int("/", "schema_version"); version != kResultsSchema && version != kUnsealed)
    throw FileError(file.path(), "has version " + std::to_string(version) + " of the results' layout; this program goes on with version " +
                                     std::to_string(kUnsealed) + " and " + std::to_string(kResultsSchema) + " only");
  if (file.attribute_int("/", "schema_version") >= kSealedSchema && !file.sealed())
    throw FileError(file.path(), "is damaged: it has lost its seal");
  check_seal(file, seal);
  Part part;
  part.file = name;
  part.seal = file.seal();
  part.first_time = file.attribute_double("/", "time_first");
  part.last_time = file.attribute_double("/", "time_last");
  for (std::size_t t = 0; t < kRowTables; ++t) {
    part.rows[t] = static_cast<std::uint64_t>(file.attribute_int("/", std::string("rows_") + table_name(static_cast<RowTable>(t))));
    if (part.rows[t] == 0) continue;
    check_columns(file, schema[t], part.rows[t]);
    read_values(file, schema[t], part.rows[t]);
  }
  return part;
}

/// Writes a part anew, sealed, with the rows that are kept of it. \param named  seal of it in run.h5, empty: none
void write_again(const std::string& folder, const RowSchema& schema, const std::string& named, Part& part) {
  part.seal = write_file(folder + "/" + part.file, [&](Hdf5File& out) {
    if (!named.empty()) out.set_attribute("/", kCutFrom, named);
    copy_rows(out, folder, schema, {&part, 1});
  });
}

/// The part without rows later than `until`.
Part part_until(const std::string& folder, Part part, double until) {
  part.last_time = part.first_time;
  const Hdf5File file = Hdf5File::open(folder + "/" + part.file);
  for (std::size_t t = 0; t < kRowTables; ++t) {
    if (part.rows[t] == 0) continue;
    const std::vector<double> time = file.read<double>(time_column(t));
    part.rows[t] = static_cast<std::uint64_t>(std::ranges::upper_bound(time, until) - time.begin());
    if (part.rows[t] > 0) part.last_time = std::max(part.last_time, time[part.rows[t] - 1]);
  }
  return part;
}

/// Checks that all required rows exist. Nothing has been rewritten or removed yet, so a missing part can still be restored by the user.
void check_counts(const std::string& folder, const RowCounts& there, const RowCounts& wanted) {
  for (std::size_t t = 0; t < kRowTables; ++t) {
    if (there[t] == wanted[t]) continue;
    throw FileError(folder + "/run.h5", "has " + std::to_string(there[t]) + " rows of " + table_name(static_cast<RowTable>(t)) +
                                            " up to the checkpoint, which was written after " + std::to_string(wanted[t]) +
                                            ": parts of the results are gone");
  }
}

// Makes the merged run.h5 of a finished run the first part. Parts that a kill left beside it contain the same rows and are removed.
void take_merged(const std::string& folder) {
  namespace fs = std::filesystem;
  const std::string run = folder + "/run.h5";
  if (!fs::exists(run)) return;
  const Hdf5File file = Hdf5File::open(run);
  if (!file.has_attribute("/", "parts") || file.attribute_int("/", "parts") != 0) return;
  remove_parts(folder, {});
  fs::create_directory(folder + "/parts");
  // A hard link instead of a rename: after a kill before the new run.h5 exists, the old one is still there.
  std::error_code error;
  const std::string part = folder + "/" + part_name(0);
  fs::create_hard_link(run, part, error);
  if (error) fs::copy_file(run, part, error);  // some file systems have no hard links
  if (error) throw FileError(run, "cannot become the first part: " + error.message());
}

}  // namespace

std::vector<Part> keep_parts(const std::string& folder, const RowSchema& schema, const EarlierRows& earlier) {
  take_merged(folder);
  const std::vector<NamedPart> named = named_parts(folder);
  const auto seal_of = [&](std::size_t i) { return named.empty() ? "" : named[i].seal; };
  const auto file_of = [&](std::size_t i) { return named.empty() ? part_name(i) : named[i].file; };
  // Where run.h5 names parts, others may be there that it does not name yet, or no more: the same rows as in parts that have become one.
  const std::size_t most = named.empty() ? std::numeric_limits<std::size_t>::max() : named.size();
  std::vector<Part> parts;
  bool cut = false;
  for (std::size_t i = 0; i < most && std::filesystem::exists(folder + "/" + file_of(i)); ++i) {
    Part part = read_part(folder, file_of(i), seal_of(i), schema);
    if (part.first_time > earlier.until) break;
    cut = part.last_time > earlier.until;
    parts.push_back(cut ? part_until(folder, std::move(part), earlier.until) : std::move(part));
    if (cut) break;
  }
  if (earlier.rows) check_counts(folder, rows_of(parts), *earlier.rows);
  for (Part& p : parts) {
    const bool last = &p == &parts.back();
    if (p.seal.empty() || (cut && last)) write_again(folder, schema, cut && last ? seal_of(parts.size() - 1) : "", p);
  }
  return parts;
}

}  // namespace voussoir::io
