// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/case_file.h"
#include "io/case_tables.h"

namespace voussoir::io {

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
