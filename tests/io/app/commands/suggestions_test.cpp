// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

// A mistyped option, value or name of a part gets the one that was probably meant.
namespace {

using shell::Outcome;
using shell::voussoir;
using Typos = std::vector<std::pair<std::string, std::string>>;  // what is written, what is meant

}  // namespace

TEST_CASE("suggestions: every kind of name that a case refers to") {
  const std::string block = "[[block]]\nname = \"slider\"\nmaterial = \"adobe\"\nbox = [[9, 9, 0], [9.2, 9.2, 0.2]]\n";
  const std::string tie = "[[house.tie]]\nname = \"rod\"\nkind = \"along\"\nheights = [1.0]\narea = 1e-4\n";
  const std::string mesh = "[[house.mesh]]\nname = \"net\"\nstiffness = 1e6\n", opening = "from = 1.0\nwidth = 1.0\nheight = 1.0\n";
  const std::string part = "[[base.part]]\nlevel = 0.2\nfrom = 0.0\nto = 1.0\n";
  const Typos typos{{"[house]\nwalls = [\"front\", \"reer\"]\n", "\"rear\""},
                    {tie + "walls = [\"frnt\"]\n", "\"front\""},
                    {mesh + "walls = [\"rigth\"]\n", "\"right\""},
                    {"[house.leaves]\nwalls = [\"lefd\"]\n", "\"left\""},
                    {"[house.leaves]\njoint = \"norml\"\n", "\"normal\""},
                    {"[[house.opening]]\nwall = \"frnt\"\n" + opening, "\"front\""},
                    {part + "wall = \"rea\"\n", "\"rear\""},
                    {"[house]\nmaterial = \"adob\"\n", "\"adobe\""},
                    {"[house]\njoint = \"norml\"\n", "\"normal\""},
                    {"[house.wood]\nmaterial = \"wod\"\n", "\"wood\""},
                    {"[house]\nbond = \"runing\"\n", "\"running\""},
                    {"[[joints.between]]\nmaterials = [\"adobe\", \"wod\"]\nlaw = \"normal\"\n", "\"wood\""},
                    {"[[joints.between]]\nmaterials = [\"adobe\", \"wood\"]\nlaw = \"norml\"\n", "\"normal\""},
                    {"[[contact.between]]\nmaterials = [\"adobe\", \"wod\"]\nfriction = 30.0\n", "\"wood\""},
                    {"[materials.adobe]\ninside = \"norml\"\n", "\"normal\""},
                    {block + "[[load]]\nblock = \"slder\"\nforce = [1.0, 0.0, 0.0]\n", "\"slider\""},
                    {"[motion]\nrecord = \"bam-lik\"\n", "\"bam-like\""},
                    {"[motion]\nunit = \"m/s3\"\n", "\"m/s2\""},
                    {"[motion]\ndirection = \"LTW\"\n", "\"LTV\""}};
  TempFolder folder;
  for (const auto& [text, meant] : typos) {
    const Outcome o = voussoir("check " + shell::quoted(folder.write("typo.toml", "include = \"flat20n\"\n" + text)));
    INFO(text << o.text);
    CHECK(o.code == 2);
    CHECK(o.text.find("did you mean " + meant) != std::string::npos);
  }
  const std::string part_file = folder.write("part.toml", "include = [\"flat20n\", \"parts/wal-rods\"]\n");
  CHECK(voussoir("check " + shell::quoted(part_file)).text.find("did you mean \"parts/wall-rods\"") != std::string::npos);
  const std::string own = folder.write("own.toml", "include = \"./prt.toml\"\n");
  CHECK(voussoir("check " + shell::quoted(own)).text.find("did you mean \"./part.toml\"") != std::string::npos);
}

TEST_CASE("suggestions: commands, options, and words of options") {
  for (const auto& [words, meant] : Typos{{"sumary x", "\"summary\""},
                                          {"check flat20n --formt json", "did you mean --format?"},
                                          {"check flat20n --format jsn", "did you mean json?"},
                                          {"check flat20n -format json", "-format: did you mean --format?"},
                                          {"check flat20n --drw a.svg b", "not expected: --drw a.svg b"},
                                          {"--mesages json check", "--mesages: did you mean --messages?"},
                                          {"new hous", "did you mean house?"},
                                          {"completion bsh", "did you mean bash?"},
                                          {"report x --view frnt --stills 1", "did you mean front?"},
                                          {"check flat20m", "did you mean \"flat20n\"?"}}) {
    const Outcome o = voussoir(words);
    INFO(words << ": " << o.text);
    CHECK(o.code == 2);
    CHECK(o.text.find(meant) != std::string::npos);
  }
}
