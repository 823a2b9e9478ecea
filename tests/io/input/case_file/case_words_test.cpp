// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "io/input/case_file/case_file.h"

// Every key whose value is one of some words, or a word in place of a number: a mistyped word gets the one that was meant.

using namespace voussoir;

namespace {

struct WordKey {
  std::string table, name;
  std::vector<std::string> words;
};

struct Reference {
  std::vector<WordKey> keys;
  std::set<std::string> arrays;  // tables that may stand several times
};

/// The keys with words among their allowed values, from the reference of all keys.
Reference reference() {
  Reference all;
  std::istringstream lines(io::key_reference_markdown());
  const std::regex header(R"(^## `\[(\[?)([^\]]*)\].*)"), row(R"(^\| `(\w+)` \| .*? \| .*? \| (("\w[^|]*?" \\\| )+"[^"]+"|"auto" or ).*)"),
      word(R"re("([^"]+)")re");
  std::string table;
  std::smatch found;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_match(line, found, header)) {
      table = found[2];
      if (found[1] == "[") all.arrays.insert(table);
    } else if (std::regex_match(line, found, row)) {
      WordKey& key = all.keys.emplace_back(WordKey{table, found[1], {}});
      const std::string allowed = found[2];
      for (std::sregex_iterator at(allowed.begin(), allowed.end(), word), end; at != end; ++at) key.words.push_back((*at)[1]);
    }
  }
  return all;
}

/// The headers of a table and of the arrays that it is in.
std::string headers(const std::string& table, const std::set<std::string>& arrays) {
  std::string out, so_far;
  std::istringstream parts(table);
  for (std::string part; std::getline(parts, part, '.');) {
    so_far += (so_far.empty() ? "" : ".") + part;
    if (arrays.contains(so_far)) out += "[[" + so_far + "]]\n";
  }
  if (!arrays.contains(table)) out += "[" + std::regex_replace(table, std::regex("<name>"), "it") + "]\n";
  return out;
}

std::string refusal(const std::string& text) {
  try {
    io::read_case({"test.toml", text});
  } catch (const io::CaseFileError& e) {
    return e.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("words: each word of each key, mistyped by a letter, gets the word that was meant") {
  const Reference all = reference();
  std::set<std::string> names;
  std::size_t words = 0;
  for (const WordKey& key : all.keys) {
    names.insert(key.table + "." + key.name);
    for (const std::string& word : key.words) {
      ++words;
      std::vector<std::string> typos{word + "q"};
      if (word.size() > 3) typos.push_back(word.substr(0, word.size() / 2) + word.substr(word.size() / 2 + 1));
      for (const std::string& typo : typos) {
        const std::string text = headers(key.table, all.arrays) + key.name + " = \"" + typo + "\"\n", said = refusal(text);
        INFO(text << said);
        CHECK(said.find(key.name + " = \"" + typo + "\": must be ") != std::string::npos);
        CHECK(said.find("did you mean \"" + word + "\"?") != std::string::npos);
      }
    }
  }
  for (const char* name : {"damping.frequency", "time.step", "output.frame_interval", "stones.supports", "house.roof.kind", "analysis.kind",
                           "motion.intensity.components", "house.floor.anchorage", "joint_laws.<name>.softening"})
    CHECK_MESSAGE(names.contains(name), name);
  CHECK(names.size() >= 30);
  CHECK(words > 80);
}
