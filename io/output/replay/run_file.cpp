// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/replay/run_file.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "io/input/files/errors.h"
#include "io/input/files/sealed_pages.h"
#include "io/input/messages/messages.h"
#include "io/output/replay/values/run_values.h"

namespace voussoir::io {

Hdf5File open_run(const std::string& path) {
  std::error_code error;
  Hdf5File run = Hdf5File::open(std::filesystem::is_directory(path, error) ? path + "/run.h5" : path);
  if (!run.has_attribute("/", "schema_version")) throw FileError(run.path(), "holds no results of voussoir");
  const std::int64_t version = run.attribute_int("/", "schema_version");
  if (version > kResultsSchema)
    throw FileError(run.path(), "has schema_version " + std::to_string(version) + "; this program reads up to " +
                                    std::to_string(kResultsSchema) + ": a later program wrote it");
  if (version < kOldestSchema)
    throw FileError(run.path(), "has schema_version " + std::to_string(version) + "; this program reads from " +
                                    std::to_string(kOldestSchema) + " on: a program of before 28 November 2026 wrote it");
  if (!run.sealed() && version >= kSealedSchema) throw FileError(run.path(), "is damaged: it has lost its seal");
  if (!run.sealed())
    say_note(run.path() + ": not sealed (schema " + std::to_string(version) + "): damage to it may stay unnoticed");
  check_shapes(run);
  run.inspect(check_values);
  return run;
}

std::vector<std::string> missing_parts(const Hdf5File& run) {
  const std::filesystem::path folder = std::filesystem::path(run.path()).parent_path();
  std::vector<std::string> missing;
  for (const NamedPart& part : run.named_parts())
    if (std::error_code error; !std::filesystem::exists(folder / part.file, error)) missing.push_back(part.file);
  return missing;
}

namespace {

constexpr std::uint64_t kPieceBytes = 1U << 20U;  // of a dataset in memory at a time

void read_whole(const Hdf5File& run, const std::string& name) {
  if (run.is_text(name)) return static_cast<void>(run.read_strings(name));
  static_cast<void>(run.count_of(name));
  const Shape shape = run.shape(name);
  const Hdf5Type type = run.type(name);
  std::uint64_t row = size_of(type), rows = shape.empty() ? 1 : shape[0];
  for (std::size_t i = 1; i < shape.size(); ++i) row *= shape[i];
  const std::uint64_t piece = std::max<std::uint64_t>(1, kPieceBytes / std::max<std::uint64_t>(1, row));
  std::vector<std::byte> values;
  for (std::uint64_t first = 0; first < rows; first += piece) {
    const std::uint64_t n = std::min(piece, rows - first);
    values.resize(n * row);
    run.read_rows(name, type, first, n, values.data());
  }
}

}  // namespace

std::size_t check_run(const std::string& path) {
  const Hdf5File run = open_run(path);
  const std::filesystem::path folder = std::filesystem::path(run.path()).parent_path();
  PagedFile(run.path()).check_all();
  std::size_t files = 1;
  for (const std::string& name : run.datasets()) read_whole(run, name);
  for (const std::string& part : run.sources()) {
    PagedFile((folder / part).string()).check_all();
    ++files;
  }
  return files;
}

}  // namespace voussoir::io
