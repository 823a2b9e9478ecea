// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "cases/case.h"
#include "io/input/case_file/case_file.h"
#include "io/input/case_file/case_tables.h"

namespace voussoir::io {
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
