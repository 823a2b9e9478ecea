// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/files/output_path.h"

#include <filesystem>

#include "io/input/files/errors.h"

namespace voussoir::io {
namespace fs = std::filesystem;

void refuse_to_replace(const std::string& path, bool overwrite) {
  std::error_code none;
  if (!overwrite && fs::exists(path, none)) throw FileError(path, "exists; --overwrite replaces it");
}

void check_output(const std::string& path, bool overwrite) {
  if (path.empty()) return;
  refuse_to_replace(path, overwrite);
  const fs::path folder = fs::path(path).parent_path();
  std::error_code none;
  if (!folder.empty() && !fs::is_directory(folder, none)) throw FileError(path, "cannot be written: there is no folder " + folder.string());
}

}  // namespace voussoir::io
