// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "io/input/case_file/case_file.h"
#include "io/input/case_file/case_keys.h"

// Every key of a building, as cases/KEYS.md lists it, is given values of another type, out of its range, and another name: each message
// says where, which key, what value, and what is allowed.
namespace voussoir {
namespace {

struct ListedKey {
  std::string table, name, allowed;
};

const std::vector<std::string> kTables{"house",
                                       "house.rubble",
                                       "house.leaves",
                                       "house.leaves.through",
                                       "house.wood",
                                       "house.storey",
                                       "house.inner_wall",
                                       "house.pier",
                                       "house.floor",
                                       "house.floor.anchor",
                                       "house.floor.deck",
                                       "house.roof",
                                       "house.roof.tie",
                                       "house.roof.deck",
                                       "house.opening",
                                       "house.opening.lintel",
                                       "house.opening.arch",
                                       "house.reinforcement",
                                       "house.tie",
                                       "house.mesh",
                                       "house.mesh.connectors",
                                       "wall",
                                       "wall.opening",
                                       "wall.opening.lintel",
                                       "wall.opening.arch",
                                       "tie",
                                       "base",
                                       "base.part",
                                       "base.part.motion"};

/// Headers of all tables, as they stand in a file.
using Headers = std::vector<std::string>;

std::vector<ListedKey> listed_keys(Headers& headers) {
  std::ifstream in(std::string(VOUSSOIR_SOURCE_DIR) + "/cases/KEYS.md");
  std::vector<ListedKey> keys;
  std::string table;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("## `[")) {
      const std::string header = line.substr(4, line.size() - 5);
      headers.push_back(header);
      table = header;
      std::erase(table, '['), std::erase(table, ']');
    } else if (line.starts_with("| `") && std::ranges::count(kTables, table) == 1) {
      std::vector<std::string> cells{""};
      for (std::size_t i = 1; i < line.size(); ++i) {
        if (line[i] == '|' && line[i - 1] != '\\')
          cells.emplace_back();
        else if (line[i] != '\\')
          cells.back() += line[i];
      }
      const std::string name = cells.at(0).substr(2, cells[0].size() - 4);
      keys.push_back({table, name, cells.at(3).substr(1, cells[3].size() - 2)});
    }
  }
  return keys;
}

/// The headers that a key of a table stands under, and the path of the table in messages.
std::pair<std::string, std::string> place_of(const std::string& table, const Headers& headers) {
  std::string text, path;
  for (std::size_t end = 0; end < table.size();) {
    end = std::min(table.find('.', end + 1), table.size());
    const std::string part = table.substr(0, end);
    const bool array = std::ranges::count(headers, "[[" + part + "]]") > 0;
    if (array || end == table.size()) text += (array ? "[[" + part + "]]" : "[" + part + "]") + "\n";
    path += part.substr(part.rfind('.') == std::string::npos ? 0 : part.rfind('.')) + (array ? "[0]" : "");
  }
  return {text, path};
}

std::string refusal(const std::string& text) {
  try {
    io::read_case({"test.toml", text}, {});
  } catch (const io::CaseFileError& e) {
    return e.what();
  }
  return "accepted";
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A value of another type.
std::string of_another_type(const std::string& allowed) {
  if (has(allowed, "array") || has(allowed, "number") || has(allowed, "integer")) return "\"x\"";
  return has(allowed, "string") ? "3" : "\"nonsense\"";
}

/// A value out of range; empty: any is in it.
std::string out_of_range(const std::string& allowed) {
  const bool limited = has(allowed, ">") || has(allowed, "in [") || has(allowed, "in (");
  std::string one = limited ? (has(allowed, "integer") ? "-1000" : "-1000.0") : has(allowed, "not empty") ? "\"\"" : "";
  if (one.empty() || !has(allowed, "an array")) return one;
  const std::size_t of = allowed.find("array of ");
  const int count = of == std::string::npos ? 1 : allowed[of + 9] - '0';
  std::string all = "[";
  for (int i = 0; i < count; ++i) all += (i > 0 ? ", " : "") + one;
  all += "]";
  return has(allowed, "each an array") ? "[" + all + "]" : all;
}

/// Whether a line of a message begins so; keys that the table lacks have lines of their own.
bool has_line(const std::string& message, const std::string& begin) { return ("\n" + message).find("\n" + begin) != std::string::npos; }

}  // namespace

TEST_CASE("faults: every key of a building says what is wrong with it") {
  Headers headers;
  const std::vector<ListedKey> keys = listed_keys(headers);
  int ranges = 0;
  for (const ListedKey& key : keys) {
    const auto [header, path] = place_of(key.table, headers);
    const auto line = static_cast<int>(std::ranges::count(header, '\n')) + 1;
    const std::string at = "test.toml:" + std::to_string(line) + ": " + path + "." + key.name;
    const auto check = [&, &of = header](const std::string& value, const std::string& says) {
      const std::string got = refusal(of + key.name + " = " + value + "\n");
      CAPTURE(at);
      CAPTURE(value);
      CAPTURE(got);
      CHECK(has_line(got, at));
      CHECK(has(got, says));
    };
    const std::string wrong = of_another_type(key.allowed);
    check(wrong, " = " + wrong + ": ");
    if (const std::string beyond = out_of_range(key.allowed); !beyond.empty()) check(beyond, "must "), ++ranges;
    const std::string got = refusal(header + key.name + "x = 1\n");
    CAPTURE(got);
    CHECK(has_line(got, at + "x"));
    CHECK(has(got, key.name));
  }
  CHECK(keys.size() > 150);
  CHECK(ranges > 100);
  for (const std::string& table : kTables) {
    CAPTURE(table);
    CHECK(std::ranges::any_of(keys, [&](const ListedKey& k) { return k.table == table; }));
  }
}

TEST_CASE("faults: parts of the base, arches and rubble say which keys go together") {
  const auto faulty = [](const std::string& text, const std::string& key, const std::string& says) {
    const std::string got = refusal(text);
    CAPTURE(got);
    CHECK(has(got, key));
    CHECK(has(got, says));
  };
  const std::string part = "[[base.part]]\nlevel = 0.5\n", square = part + "x = [0.0, 1.0]\ny = [1.0, 2.0]\n",
                    front = part + "wall = \"front\"\n";
  faulty("[[base.part]]\nwall = \"front\"\n", "base.part[0].level", "is missing");
  faulty(part, "base.part[0]", "has no place; give x and y, or wall");
  faulty(part + "x = [0.0, 1.0]\n", "base.part[0].x", "is not enough; a rectangle needs x and y");
  faulty(part + "x = [0.0, 1.0]\ny = [2.0, 1.0]\n", "base.part[0].y", "must be [from, to] with from below to");
  faulty(square + "wall = \"front\"\n", "base.part[0].wall", "does not go with x and y");
  faulty(square + "from = 1.0\n", "base.part[0].from", "needs wall");
  faulty(front + "from = 2.0\nto = 1.0\n", "base.part[0].to", "must be above base.part.from");
  faulty(front + "motion = {}\n", "base.part[0].motion", "says nothing; give one of: velocity (m/s); file; to (m), turn (degrees) or both");
  faulty("[house]\nrubble = { seed = 2 }\n", "house.rubble", "needs bond = \"rubble\"");
  faulty("[house]\nbond = \"rubble\"\nhalves = true\n", "house.halves", "does not go with bond = \"rubble\"");
  faulty("[house]\nbond = \"rubble\"\ncells = [2, 1, 1]\n", "house.cells", "does not go with bond = \"rubble\", whose stones stay whole");
  faulty("[house]\nhalves = true\ncells = [2, 1, 1]\n", "house.cells", "does not go with halves = true");
  faulty("[house]\ncells = [2, 0, 1]\n", "house.cells[1] = 0", "must be in [1, 16]");
  faulty("[house]\ncells = [2, 1]\n", "house.cells = [2, 1]", "has 2 values, wanted an array of 3, each an integer");
  const std::string block = "[[block]]\nname = \"a\"\nmaterial = \"adobe\"\nbox = [[0, 0, 0], [1, 1, 1]]\n";
  faulty(block + "cells = [17, 1, 1]\n", "block[0].cells[0] = 17", "must be in [1, 16]");
  faulty(block + "cells = [2, 1, 1]\nhalves = true\n", "block[0].cells", "does not go with halves = true");
  faulty(block + "cells = [2, 1, 1]\nfixed = true\n", "block[0].cells", "does not go with fixed = true");
  const std::string opening = "[[house.opening]]\nwall = \"rear\"\nfrom = 1.0\nwidth = 1.0\nheight = 1.0\n";
  faulty(opening + "arch = { rise = 0.1 }\n", "house.opening[0].arch.thickness", "is missing");
}
}  // namespace voussoir
