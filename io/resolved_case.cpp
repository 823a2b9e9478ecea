// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include "io/case_file.h"
#include "io/case_tables.h"

namespace voussoir::io {

cases::Case anchored(cases::Case value) {
  namespace fs = std::filesystem;
  const auto anchor = [&](std::string& path) { path = fs::absolute(fs::path(value.folder) / path).lexically_normal().string(); };
  if (value.motion) {
    for (auto* files : {&value.motion->xyz, &value.motion->ltv}) {
      for (std::optional<std::string>& file : *files) {
        if (file) anchor(*file);
      }
    }
    std::error_code none;
    std::optional<std::string>& record = value.motion->record;
    if (record && fs::exists(fs::path(value.folder) / *record, none)) anchor(*record);  // else one of the program's
  }
  for (cases::BlockSpec& block : value.blocks) {
    if (block.motion && block.motion->file) anchor(*block.motion->file);
  }
  return value;
}

std::string resolved_toml(const cases::Case& value) {
  Lines lines;
  lines.out = "# All keys of the case with their values, as used. \"none\": the key has no value.\n\n";
  write_table(case_table(), value, lines, "");
  return std::move(lines.out);
}

std::string key_reference() {
  Lines lines;
  lines.out =
      "Keys of a case file: name, default, unit, allowed values. [[...]] may stand several times.\n\n"
      "include                          a ready case or a .toml file, or an array of them: read first; this case lies over them, key by "
      "key\n\n";
  list_table(case_table(), lines, {});
  return std::move(lines.out);
}

std::string key_reference_markdown() {
  Lines lines;
  lines.markdown = true;
  lines.out =
      "# Keys of a case file\n\n"
      "Made by `voussoir keys --markdown` from the option table that reads the files; do not edit. `[[...]]` may stand several times, "
      "`<name>`\n"
      "is the user's own. `none`: without a value. SI units, z up, degrees. Beside these keys, `include` at the top names a ready case or "
      "a\n"
      "`.toml` file, or an array of them: read first; the case lies over them, key by key.\n\n";
  list_table(case_table(), lines, {});
  return std::move(lines.out);
}

}  // namespace voussoir::io
