// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/manual/manual_commands.h"

#include <cstdio>
#include <filesystem>

#include "io/files/errors.h"
#include "io/files/text_file.h"
#include "io/manual/completion.h"
#include "io/manual/man_page.h"
#include "io/results/provenance.h"

namespace voussoir::io {

int man_command(const OptionTable& table, const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw FileError(folder, "cannot be made: " + error.message());
  for (const ManPage& page : man_pages(table, program_version()))
    write_text_file((std::filesystem::path(folder) / page.file).string(), page.text, true);
  return 0;
}

int completion_command(const OptionTable& table, const std::string& shell) {
  const std::string text = shell == "bash" ? bash_completion(table) : shell == "zsh" ? zsh_completion(table) : fish_completion(table);
  std::fputs(text.c_str(), stdout);
  return 0;
}

}  // namespace voussoir::io
