// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cases/case.h"
#include "cases/solids/origin.h"
#include "io/input/case_file/case_file.h"
#include "io/input/case_file/case_paths.h"
#include "io/input/case_file/case_tables.h"
#include "io/input/document/case_tree.h"
#include "io/input/files/run_folder.h"

namespace voussoir::io {

namespace fs = std::filesystem;

cases::Case anchored(cases::Case value) {
  for_each_path(value, [&](std::string& path) {
    std::error_code error;  // weakly_canonical follows links, and keeps a last part that does not exist, as in FILE#COMPONENT
    const std::string whole = fs::weakly_canonical(fs::absolute(fs::path(value.folder) / path), error).string();
    if (!error && is_utf8(whole)) path = whole;
  });
  return value;
}

cases::Case without_folders(cases::Case value) {
  for_each_path(value, [](std::string& path) { path = fs::path(path).filename().string(); });
  return value;
}

std::string resolved_toml(const cases::Case& value) {
  Lines lines;
  lines.out = std::string(kResolvedHead) + " \"none\": the key has no value.\n\n";
  write_table(case_table(), cases::as_in_file(value), lines, "");
  return std::move(lines.out);
}

std::string key_reference() {
  Lines lines;
  lines.out =
      "Keys of a case file: name, default, unit, allowed values. [[...]] may stand several times.\n\n"
      "include                          a ready case or a .toml file, or an array of them: read first; this case lies over them, key by "
      "key; KEY = [] takes away what they brought\n\n";
  list_table(case_table(), lines, {});
  return std::move(lines.out);
}

std::string key_reference_markdown() {
  Lines lines;
  lines.markdown = true;
  lines.out =
      "# Keys of a case file\n\n"
      "Made by `voussoir keys --markdown` from the option table that reads the files; do not edit. *Eq. n* is an equation of the method's "
      "paper ([THEORY](../kernels/THEORY.md)). `[[...]]` may stand several times, "
      "`<name>`\n"
      "is the user's own. `none`: without a value. SI units, z up, degrees. Beside these keys, `include` at the top names a ready case or "
      "a\n"
      "`.toml` file, or an array of them: read first; the case lies over them, key by key. Arrays of tables (`[[...]]`) are replaced as a\n"
      "whole. `KEY = []` takes away what they brought: all openings (`opening = []` in `[house]`), all followed points (`history = []` in\n"
      "`[output]`), a table (`reinforcement = []`), or a single value, which has its default again; `--set KEY=` does so on the command "
      "line.\n*Eq. n* is an equation of the method's paper, told in [THEORY](../kernels/THEORY.md).\n\n";
  list_table(case_table(), lines, {});
  return std::move(lines.out);
}

namespace {

using Json = nlohmann::ordered_json;

Json types_json(const std::vector<ValueType>& types) {
  Json out = Json::array();
  for (const ValueType& t : types) out.push_back({{"of", t.of}, {"extents", t.extents}});
  return out;
}

/// The value that a TOML text has.
Json value_of(const Node& node) {
  if (const auto* v = node.as<bool>()) return *v;
  if (const auto* v = node.as<std::int64_t>()) return *v;
  if (const auto* v = node.as<double>()) return *v;
  if (const auto* v = node.as<std::string>()) return *v;
  Json out = nullptr;
  if (const auto* array = node.as<Node::Array>()) {
    out = Json::array();
    for (const Node& n : *array) out.push_back(value_of(n));
  }
  return out;
}

Json words_json(const std::vector<std::string>& words) {
  Json out = Json::array();
  for (const std::string& w : words) out.push_back(value_of(parse_value(w)));
  return out;
}

Json key_json(const ListedTable::Row& row) {
  const KeyInfo& i = row.info;
  return {{"name", i.name},
          {"required", i.required},
          {"default", row.default_text.empty() || i.required ? Json(nullptr) : value_of(parse_value(row.default_text))},
          {"unit", i.unit},
          {"types", types_json(i.types)},
          {"words", words_json(i.words)},
          {"limits", i.limits.full_text()},
          {"meaning", i.sentence}};
}

}  // namespace

std::string key_reference_json() {
  std::vector<ListedTable> tables;
  Lines lines;
  lines.tables = &tables;
  list_table(case_table(), lines, {});
  Json out = Json::array();
  for (const ListedTable& t : tables) {
    Json table{{"table", t.at.path}, {"array", t.at.array}, {"meaning", t.sentence}, {"in_place", types_json(t.in_place)}, {"keys", Json::array()}};
    for (const ListedTable::Row& row : t.keys) table["keys"].push_back(key_json(row));
    out.push_back(std::move(table));
  }
  return out.dump(1) + "\n";
}

}  // namespace voussoir::io
