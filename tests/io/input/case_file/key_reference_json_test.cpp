// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "io/input/case_file/case_file.h"

namespace voussoir::io {
namespace {

using Json = nlohmann::json;

const Json& tables() {
  static const Json all = Json::parse(key_reference_json());
  return all;
}

Json key(const std::string& table, const std::string& name) {
  for (const Json& t : tables())
    if (t["table"] == table)
      for (const Json& k : t["keys"])
        if (k["name"] == name) return k;
  FAIL("no key " << table << "." << name);
  return {};
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + what.size())) ++n;
  return n;
}

}  // namespace

TEST_CASE("keys as JSON: the tables and keys of the page") {
  const std::string page = key_reference_markdown();
  std::size_t keys = 0;
  for (const Json& t : tables()) {
    keys += t["keys"].size();
    const std::string path = t["table"];
    const std::string header = t["array"] == true ? "[[" + path + "]]" : "[" + path + "]";
    INFO(header);
    if (!path.empty()) CHECK(page.find("## `" + header + "`") != std::string::npos);
  }
  CHECK(tables().size() == count(page, "\n## "));
  CHECK(keys == count(page, "\n| `"));
}

TEST_CASE("keys as JSON: every key has a type, words, or both") {
  const std::set<std::string> types{"number", "integer", "boolean", "string"};
  for (const Json& t : tables()) {
    for (const Json& k : t["keys"]) {
      INFO(t["table"] << "." << k["name"]);
      CHECK(k["types"].size() + k["words"].size() > 0);
      for (const Json& type : k["types"]) CHECK(types.contains(type["of"].get<std::string>()));
    }
  }
}

TEST_CASE("keys as JSON: types, words, units, defaults") {
  CHECK(key("time", "step")["words"] == Json{"auto"});
  CHECK(key("time", "step")["types"] == Json::parse(R"([{"of": "number", "extents": []}])"));
  CHECK(key("time", "multirate")["words"] == Json{1, 2, 4, 8});
  CHECK(key("damping", "debris")["words"] == Json{"keep", "off"});
  CHECK(key("block", "box")["types"] == Json::parse(R"([{"of": "number", "extents": [2, 3]}])"));
  CHECK(key("block", "faces")["types"] == Json::parse(R"([{"of": "integer", "extents": [-1, -1]}])"));
  CHECK(key("motion", "scale")["types"].size() == 2);
  CHECK(key("analysis", "control")["types"].size() == 2);
  CHECK(key("stones", "supports")["words"] == Json{"ground", "none"});
  CHECK(key("wall", "height")["unit"] == "m");
  CHECK(key("wall", "height")["required"] == true);
  CHECK(key("gravity", "acceleration")["default"].size() == 3);
  CHECK(key("gravity", "settle")["default"] == true);
  for (const Json& t : tables()) CHECK(t["in_place"].size() == (t["table"] == "stones.turn" ? 1 : 0));
}

}  // namespace voussoir::io
