// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

// Every numeric key of the table with numbers that no building has, in small cases that use the key: refused with the key and what is
// allowed, or a run that makes steps and ends. Never a crash, an endless run, or success without a step.

namespace {

using shell::Outcome;
using shell::quoted;

struct NumericKey {
  std::string table, name, allowed;
};

struct Reference {
  std::vector<NumericKey> keys;
  std::set<std::string> arrays;  // tables that may stand several times
};

/// The keys that `voussoir keys` tells of as numbers.
Reference reference() {
  Reference all;
  std::istringstream lines(shell::voussoir("keys").text);
  const std::regex header(R"(^\[\[?([^\]]*)\].*)"), key(R"(^  (\S+) .*)"), number(R"(.*(a number|an integer|\[x, y, z\]).*)");
  std::string table;
  std::smatch found;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_match(line, found, header)) {
      table = found[1];
      if (line.starts_with("[[")) all.arrays.insert(table);
    } else if (std::regex_match(line, found, key) && std::regex_match(line, number)) {
      all.keys.push_back({table, found[1], line});
    }
  }
  return all;
}

/// Cases of data/every_number that use the keys of a table; others are used by blocks.toml.
std::vector<std::string> cases_of(const std::string& table) {
  static const std::map<std::string, std::vector<std::string>> kCases{{"analysis", {"pushed", "cyclic"}},
                                                                      {"motion", {"shaken"}},
                                                                      {"motion.intensity", {"shaken"}},
                                                                      {"stones", {"stones"}},
                                                                      {"stones.turn", {"stones"}},
                                                                      {"segments", {"house"}},
                                                                      {"wall", {"walls"}},
                                                                      {"wall.opening", {"walls"}},
                                                                      {"wall.opening.lintel", {"walls"}},
                                                                      {"wall.opening.arch", {"walls"}},
                                                                      {"floor", {"spans"}},
                                                                      {"floor.anchor", {"spans"}},
                                                                      {"floor.deck", {"spans"}},
                                                                      {"roof", {"spans"}},
                                                                      {"roof.tie", {"spans"}},
                                                                      {"roof.deck", {"spans"}},
                                                                      {"wall_tie", {"spans"}},
                                                                      {"house", {"house"}},
                                                                      {"house.rubble", {"rubble"}},
                                                                      {"house.leaves", {"leaves"}},
                                                                      {"house.leaves.through", {"leaves"}},
                                                                      {"house.storey", {"storeys"}},
                                                                      {"house.inner_wall", {"storeys"}},
                                                                      {"house.floor", {"storeys"}},
                                                                      {"house.floor.anchor", {"storeys"}},
                                                                      {"house.floor.deck", {"storeys"}},
                                                                      {"house.pier", {"storeys"}},
                                                                      {"house.roof", {"house", "vault", "pitched"}},
                                                                      {"house.roof.tie", {"pitched"}},
                                                                      {"house.roof.deck", {"pitched"}},
                                                                      {"house.opening", {"house"}},
                                                                      {"house.opening.lintel", {"house"}},
                                                                      {"house.opening.arch", {"arch"}},
                                                                      {"house.reinforcement", {"members"}},
                                                                      {"house.tie", {"members"}},
                                                                      {"house.mesh", {"members"}},
                                                                      {"house.mesh.connectors", {"members"}}};
  const auto at = kCases.find(table);
  if (at != kCases.end()) return at->second;
  CHECK_MESSAGE(!table.starts_with("house"), table);  // a new table of houses needs a case here
  return {"blocks"};
}

/// "house.tie[0].area". The first block is fixed and has a motion, the second is free.
std::string path_of(const NumericKey& key, const std::set<std::string>& arrays) {
  std::string path, table;
  std::istringstream parts(key.table);
  for (std::string part; std::getline(parts, part, '.');) {
    table += (table.empty() ? "" : ".") + part;
    if (part == "<name>") part = table.starts_with("materials") ? "stone" : "normal";
    path += (path.empty() ? "" : ".") + part;
    if (arrays.contains(table)) path += table == "block" && key.table != "block.motion" ? "[1]" : "[0]";
  }
  return path + "." + key.name;
}

/// The number in the shape that the key wants.
std::string shaped(const std::string& allowed, const std::string& v) {
  const auto wants = [&](const char* text) { return allowed.find(text) != std::string::npos; };
  const std::string three = "[" + v + "," + v + "," + v + "]", two = "[" + v + "," + v + "]";
  if (wants("an array, each an array, each an integer")) return "[" + three + "]";
  if (wants("an array, each an array of 2, each a number")) return "[" + two + ",[1,0],[0,1]]";
  if (wants("an array of 2, each an array [x, y, z]")) return "[" + three + ",[0.2,0.2,0.4]]";
  if (wants("an array, each an array [x, y, z]")) return "[" + three + ",[1,0,0],[1,1,0],[0,1,0],[0,0,1],[1,0,1],[1,1,1],[0,1,1]]";
  if (wants("an array of 2, each a number") || wants("an array of 2, each an integer")) return two;
  if (wants("an array of 3, each") || wants("an array [x, y, z]")) return three;
  if (wants("an array, each a number") || wants("an array, each an integer")) return "[" + v + "]";
  return v;
}

struct Place {
  TempFolder folder;
  Place() { std::filesystem::copy(VOUSSOIR_SOURCE_DIR "/tests/io/input/case_file/data/every_number", folder.path("cases")); }
  [[nodiscard]] Outcome said(const std::string& command, const std::string& name, const std::string& set) const {
    const std::string out = command == "run" ? " --quiet --overwrite -o out" : "";
    return shell::voussoir(
        command + " " + name + ".toml -j 1 --set " + quoted(set) + out,
        "cd " + quoted(folder.path("cases")) + (shell::kSanitizer ? "" : " && ulimit -v 4000000") + " && timeout -s KILL 20 ");
  }
};

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// The last line, which is the refusal.
std::string last_line(std::string text) {
  while (text.ends_with('\n')) text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

}  // namespace

TEST_CASE("numbers: each numeric key with numbers that no building has is refused, or its run makes steps and ends") {
  if (shell::kSanitizer) return;  // the limit on memory would be too small
  const Place place;
  for (const char* name : {"blocks", "shaken", "pushed", "cyclic", "stones", "house", "members", "storeys", "vault", "pitched", "rubble",
                           "leaves", "arch", "walls"})
    REQUIRE_MESSAGE(place.said("run", name, "source=x").code == 0, name);
  const Reference all = reference();
  REQUIRE(all.keys.size() > 150);
  int refused = 0, done = 0;
  // Thousands of runs: the first, third, ... number for one key, the second, fourth, ... for the next. VOUSSOIR_ALL_NUMBERS: all for each.
  const bool thorough = std::getenv("VOUSSOIR_ALL_NUMBERS") != nullptr;
  const std::vector<std::string> numbers{"1e-300", "1e-30", "-1", "0", "1e30", "1e300", "nan", "inf"};
  for (std::size_t k = 0; k < all.keys.size(); ++k) {
    const NumericKey& key = all.keys[k];
    const std::string path = path_of(key, all.arrays);
    std::vector<std::string> tried;
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (thorough || i % 2 == k % 2) tried.push_back(numbers[i]);
    if (has(key.allowed, "an integer")) tried.emplace_back("2147483647");
    for (const std::string& name : cases_of(key.table))
      for (const std::string& number : tried) {
        const std::string set = path + "=" + shaped(key.allowed, number);
        const Outcome o = place.said("run", name, set);
        if (o.code == 2 && has(last_line(o.text), "voussoir: ") && !has(o.text, "out of memory")) {
          ++refused;
          continue;
        }
        CAPTURE(name);
        CAPTURE(set);
        CAPTURE(o.text);
        CHECK(o.code == 0);
        CHECK(has(o.text, "time by stage"));
        ++done;
      }
  }
  MESSAGE(all.keys.size() << " keys, " << refused << " values refused, " << done << " runs");
  CHECK(refused > 3 * done);
}

TEST_CASE("numbers: what makes no step, or no end, is refused alike by check and run, with key, value and what is allowed") {
  const Place place;
  const auto refused = [&](const std::string& name, const std::string& set, const std::vector<std::string>& parts) {
    for (const char* command : {"check", "run"}) {
      const Outcome o = place.said(command, name, set);
      CAPTURE(o.text);
      CHECK(o.code == 2);
      const std::string line = last_line(o.text);
      for (const std::string& part : parts) CHECK_MESSAGE(has(line, part), part);
      CHECK_FALSE(std::filesystem::exists(place.folder.path("cases/out")));
    }
  };
  refused("blocks", "output.history_interval=1e-30", {"output.history_interval = 1e-30 s is impossible; allowed: 1e-9 to 10000 s"});
  refused("blocks", "output.history_interval=1e-12", {"output.history_interval = 1e-12 s is impossible"});
  refused("blocks", "materials.stone.young=1e60", {"materials.stone.young = 1e+60 Pa is impossible; allowed: 1 to 1e14 Pa"});
  refused("blocks", "materials.stone.density=1e-60", {"materials.stone.density = 1e-60 kg/m3 is impossible; allowed: 0.1 to 1e5 kg/m3"});
  refused("blocks", "output.frame_interval=1e-18", {"output.frame_interval = 1e-18 s is impossible"});
  refused("blocks", "output.ledger_interval=1e-18", {"output.ledger_interval = 1e-18 s is impossible"});
  refused("long", "time.duration=1e6", {"time.duration", "1000000 s", "steps; allowed: at most 1e10, of at least 1e-9 s"});
  refused("long", "output.history_interval=1e-9", {"output.history_interval", "is the step that divides it", "allowed: at most 1e10"});
  refused("long", "time.step=1e-9", {"time.step = 1e-09 s", "steps; allowed: at most 1e10"});
  refused("waits", "gravity.settle_limit=9e5", {"gravity.settle_limit", "steps; allowed: at most 1e10"});
  refused("waits", "gravity.ramp=9e5", {"gravity.ramp", "steps; allowed: at most 1e10"});
  refused("tiny", "materials.stone.density=1", {"materials.stone.young", "block \"b\"", "makes a step of", "the largest stable one"});
  refused("long", "output.history_interval=2e-6", {"output.history_interval", "rows; allowed: at most 1e9"});
  refused("shaken", "time.duration=100000",
          {"output.history_interval", "100000000 rows of the base's motion in 100000 s; allowed: at most 5e6, with 0.02 s or more"});
  refused("frames", "output.frame_interval=1e-6", {"output.frame_interval", "rows; allowed: at most 1e9"});
}
