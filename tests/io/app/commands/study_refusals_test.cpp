// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <utility>

#include "tests/io/app/commands/study_table.h"
#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

// What scripts of scripts/study refuse to read as one table, and what a study says where it cannot begin.
namespace {

using shell::text_of;
using study::kStands;
using study::script;
using study::Table;
using study::with;

/// The script ends with code 1, and this message.
void refuses(const TempFolder& folder, const char* name, const std::string& words, const std::string& message) {
  const std::string out = folder.path("refused");
  CHECK(shell::code_of(script(name) + words + " >" + out + " 2>&1") == 1);
  CHECK(text_of(out) == message);
}

}  // namespace

TEST_CASE("outcomes and verdict: runs of two versions are no one table") {
  const TempFolder folder;
  const auto table = [&](const std::string& name, const std::string& version, const std::string& status = "done") {
    Table t;
    t.add("flat20n", "bam-like#1", with(kStands, {{"identity", "0a"}, {"version", version}, {"status", status}}));
    t.add("flat20n", "bam-like#2", {{"version", ""}, {"status", "to be done"}});
    return folder.write(name, t.text());
  };
  const std::string old = table("old.csv", "0.1.0 (physics 12)"), now = table("now.csv", "0.1.0 (physics 13)");
  const std::string message = ": a run of version 0.1.0 (physics 13), and one of " + old +
                              " is of 0.1.0 (physics 12): their results may differ; allowed: runs of one version\n";
  refuses(folder, "outcomes.py", old + " " + now, now + message);
  refuses(folder, "outcomes.py", old + " " + now + " --by options", now + message);
  refuses(folder, "verdict.py", old + " " + now, now + message);
  refuses(folder, "verdict.py", old + " --model " + now, now + message);
  refuses(folder, "verdict.py", old + " --motion " + now, now + message);
  // What is not done is of no version; a table without the column is not asked.
  const std::string failed = table("failed.csv", "0.1.0 (physics 12)", "numerical failure");
  CHECK(shell::code_of(script("outcomes.py") + failed + " " + now + " >/dev/null") == 0);
  Table without;
  without.add("flat40n", "bam-like#1", kStands);
  CHECK(shell::code_of(script("outcomes.py") + now + " " + folder.write("without.csv", without.text()) + " >/dev/null") == 0);
}

TEST_CASE("versions: physics 14 has the results of 13, but for cases with parts of the base or with blocks kept level") {
  const TempFolder folder;
  const auto table = [&](const std::string& name, const std::string& record, const std::string& version) {
    Table t;
    t.add("flat20n", record, with(kStands, {{"identity", record}, {"version", version}}));
    return " " + folder.write(name, t.text());
  };
  const std::string earlier = table("earlier.csv", "bam-like#1", "0.1.0 (physics 13)"),
                    later = table("later.csv", "bam-like#2", "0.1.0 (physics 14)");
  CHECK(shell::code_of(script("outcomes.py") + earlier + later + " >/dev/null") == 0);
  const std::string mine = folder.write("mine.toml", "include = [\"flat20n\", \"stone-house\"]\n"), out = folder.path("differ"),
                    level = folder.write("level.toml", "[analysis]\nkind = \"pushover\"\nlevel = true\n");
  REQUIRE(shell::code_of("/usr/bin/python3 -c 'import sys; sys.path.insert(0, \"" + shell::source("scripts/study") +
                         "\"); import versions; print(*(versions.differs(c, o) for c, o in [(\"stone-house\", []), (\"" + mine +
                         "\", []), (\"" + level + "\", []), (\"flat20n\", []), (\"flat20n\", [\"analysis.level=true\"])]))' >" + out) == 0);
  CHECK(text_of(out) == "True True True False True\n");
}

TEST_CASE("a study refuses overrides that it would undo itself") {
  const TempFolder folder;
  const std::string log = folder.path("log");
  const auto said = [&](const std::string& keys) {
    const std::string file = folder.write("study.toml", "cases = [\"flat20n\"]\n" + keys);
    CHECK(shell::code_of("VOUSSOIR=/nowhere/voussoir " + script("run") + file + " --check -o " + folder.path("study") + " >" + log +
                         " 2>&1") == 2);
    return text_of(log);
  };
  const std::string record = "records = [{ name = \"mine\", x = \"a.csv\" }]\n";
  for (const auto& [keys, words] :
       {std::pair<std::string, std::string>{"scales = [0.5]\n[options]\na = [\"motion.scale=5\"]\n",
                                            "options.a: \"motion.scale=5\" has no effect beside `scales`"},
        {"duration = 2.0\nset = [\"time.duration = 5\"]\n", "set: \"time.duration = 5\" has no effect beside `duration`"},
        {record + "set = [\"motion.y=b.csv\"]\n", "set: \"motion.y=b.csv\" has no effect beside `records`"}}) {
    CHECK_MESSAGE(said(keys).find(words + "; allowed: one of the two\n") != std::string::npos, text_of(log));
  }
  CHECK(said("duration = 2.0\nset = [\"motion.scale=5\"]\n").find("No such file") != std::string::npos);
}

TEST_CASE("a study without a program says what to do") {
  const TempFolder folder;
  const std::string file = folder.write("study.toml", "cases = [\"flat20n\"]\n"), log = folder.path("log");
  CHECK(shell::code_of("VOUSSOIR=/nowhere/voussoir " + script("run") + file + " --check -o " + folder.path("study") + " >" + log +
                       " 2>&1") == 2);
  CHECK(text_of(log) == "study: /nowhere/voussoir: No such file or directory; build it, or name the program by VOUSSOIR=...\n");
  const std::string other = folder.path("study.toml");  // is there, and is no program
  CHECK(shell::code_of("VOUSSOIR=" + other + " " + script("run") + file + " --check -o " + folder.path("study") + " >" + log + " 2>&1") ==
        2);
  CHECK(text_of(log) == "study: " + other + ": Permission denied; build it, or name the program by VOUSSOIR=...\n");
}

TEST_CASE("a program that was copied without the scripts of studies says what to do") {
  const TempFolder folder;
  const std::string copy = folder.path("voussoir"), log = folder.path("log");
  std::filesystem::copy_file(VOUSSOIR_PROGRAM, copy);
  CHECK(shell::code_of(shell::quoted(copy) + " study " + folder.write("study.toml", "cases = [\"flat20n\"]\n") + " >" + log + " 2>&1") ==
        3);
  const std::string said = text_of(log);
  CAPTURE(said);
  CHECK(said.find("is neither in the checkout of " + copy +
                  " nor installed beside it; use the program in build/release/io of a checkout, or ") != std::string::npos);
  CHECK(said.find("VOUSSOIR=" + copy + " CHECKOUT/scripts/study/run STUDY.toml\n") != std::string::npos);
}

TEST_CASE("effort: two runs of one house, direction, motion and scale are refused; one that is in two tables counts once") {
  const TempFolder folder;
  const std::string file = folder.write("study.toml", "cases = [\"bare.toml\"]\n");
  const auto table = [&](const std::string& name, const std::string& run, const std::string& more) {
    return " " +
           folder.write(name, "run,case,direction,record,scale,options,seed,identity,version,status,damage_grade,fallen_mass_fraction\n" +
                                  run + ",bare,TLV,bam-like,0.5," + more + ",done,2,0.1\n");
  };
  const std::string first = table("first.csv", "a", ",1,0a,0.1.0"),
                    clash = "b: the same house, direction, motion and strength as a; they differ in ";
  refuses(folder, "effort.py", file + first + table("other.csv", "b", ",2,0b,0.1.0"), clash + "seed (1, 2); allowed: one run of each\n");
  refuses(folder, "effort.py", file + first + table("other.csv", "b", "stiff,1,0b,0.1.0"),
          clash + "options (, stiff); allowed: one run of each\n");
  refuses(folder, "effort.py", file + first + table("other.csv", "a", ",1,0a,0.2.0"),
          folder.path("other.csv") + ": a run of version 0.2.0, and one of " + folder.path("first.csv") +
              " is of 0.1.0: their results may differ; allowed: runs of one version\n");
  // The bill of the house is there already.
  folder.write("bills/bare.txt", "bill of blocks\nadobe brick 10 1.0\n");
  const std::string out = folder.path("table.md");
  CHECK(shell::code_of(script("effort.py") + file + first + table("other.csv", "c", ",1,0a,0.1.0") + " --bills " + folder.path("bills") +
                       " >" + out) == 0);
  CHECK(text_of(out).find("| bare | none | G2 10.0 | – |\n") != std::string::npos);
}
