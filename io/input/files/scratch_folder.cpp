// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/files/scratch_folder.h"

#include <stdlib.h>

#include <filesystem>
#include <system_error>

#include "io/input/files/errors.h"

namespace voussoir::io {
namespace fs = std::filesystem;

ScratchFolder::ScratchFolder() {
  std::error_code fault;
  const fs::path above = fs::temp_directory_path(fault);
  if (fault) throw FileError("TMPDIR", "names no folder: " + fault.message());
  path_ = (above / "voussoir-XXXXXX").string();
  if (::mkdtemp(path_.data()) == nullptr) throw FileError(path_, "cannot make the folder");
}

ScratchFolder::~ScratchFolder() {
  std::error_code left;  // ignored: a file left in the system's temporary folder does no harm
  fs::remove_all(path_, left);
}

}  // namespace voussoir::io
