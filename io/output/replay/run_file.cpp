// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/replay/run_file.h"

#include <cstdio>
#include <filesystem>

#include "io/input/files/errors.h"
#include "io/input/files/sealed_pages.h"

namespace voussoir::io {

Hdf5File open_run(const std::string& path) {
  std::error_code error;
  Hdf5File run = Hdf5File::open(std::filesystem::is_directory(path, error) ? path + "/run.h5" : path);
  if (!run.has_attribute("/", "schema_version")) throw FileError(run.path(), "holds no results of voussoir");
  const std::int64_t version = run.attribute_int("/", "schema_version");
  if (version > kResultsSchema)
    throw FileError(run.path(), "has schema_version " + std::to_string(version) + "; this program reads up to " +
                                    std::to_string(kResultsSchema) + ": a later program wrote it");
  if (!run.sealed() && version >= kSealedSchema) throw FileError(run.path(), "is damaged: it has lost its seal");
  if (!run.sealed())
    std::fprintf(stderr, "voussoir: note: %s: not sealed (schema %lld): damage to it may stay unnoticed\n", run.path().c_str(),
                 static_cast<long long>(version));
  return run;
}

std::size_t check_run(const std::string& path) {
  const Hdf5File run = open_run(path);
  const std::filesystem::path folder = std::filesystem::path(run.path()).parent_path();
  PagedFile(run.path()).check_all();
  std::size_t files = 1;
  for (const std::string& name : run.datasets()) static_cast<void>(run.count_of(name));
  for (const std::string& part : run.sources()) {
    PagedFile((folder / part).string()).check_all();
    ++files;
  }
  return files;
}

}  // namespace voussoir::io
