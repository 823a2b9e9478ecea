// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "io/input/case_file/case_file.h"

using namespace voussoir;
using io::read_case;

namespace {

/// The message with which a text is refused; "accepted" if it is not.
std::string refusal(const std::string& text, const std::vector<std::string>& overrides) {
  try {
    read_case({"test.toml", text}, overrides);
  } catch (const io::CaseFileError& e) {
    return e.what();
  }
  return "accepted";
}

const std::string kBlock = "[[block]]\nname = \"a\"\nmaterial = \"m\"\n";

}  // namespace

TEST_CASE("faults: all of a file are told at once, in the order of its lines, each with its remedy") {
  const std::string text = "[time]\nduration = -1\nstp = 1e-4\n[materials.m]\ndensity = \"heavy\"\n" + kBlock +
                           "box = [[0,0,0],[1,1,1]]\n[[block]]\nname = \"b\"\n";
  const std::string message = refusal(text, {"contact.damping=-2"});
  const auto line = [&](std::size_t n) {
    std::istringstream lines(message);
    std::string found;
    for (std::size_t i = 0; i <= n && !std::getline(lines, found).fail(); ++i) continue;
    return found;
  };
  CHECK(std::count(message.begin(), message.end(), '\n') >= 4);
  CHECK(line(0) == "test.toml:2: time.duration = -1 s: must be in [0, 1e+06]");
  CHECK(line(1).starts_with("test.toml:3: time.stp: unknown key; did you mean \"step\"?"));
  CHECK(line(2).starts_with("test.toml:4: materials.m.young is missing"));
  CHECK(message.find("test.toml:5: materials.m.density = \"heavy\": found a string in quotes") != std::string::npos);
  CHECK(message.find("test.toml:10: block[1].material") != std::string::npos);
  CHECK(message.substr(message.rfind('\n') + 1).starts_with("--set contact.damping=-2: "));
}

TEST_CASE("faults: those of tables beside the model are told with those of the model") {
  const std::string text = "[materials.m]\ndensity = 1800.0\nyoung = 1e7\npoisson = 0.2\n" + kBlock +
                           "box = [[0,0,0],[1,1,1]]\n[joints]\ndefault = \"strng\"\n[analysis]\ncontrol = \"a\"\n[time]\nduration = -1\n";
  const std::string message = refusal("title = \"t\"\n" + text, {});
  CAPTURE(message);
  CHECK(message.find("test.toml:11: joints.default") != std::string::npos);
  CHECK(message.find("test.toml:13: analysis.control") != std::string::npos);
  CHECK(message.find("test.toml:15: time.duration = -1 s") != std::string::npos);
  CHECK(std::count(message.begin(), message.end(), '\n') == 2);
  const std::string moved = "[base]\nz = 0.0\n[[base.part]]\nlevel = 0.2\nx = [2, 3]\ny = [2, 3]\nmotion = { to = [0, 0, -0.1] }\n";
  const std::string of_part = refusal("title = \"t\"\n" + text.substr(0, text.find("[analysis]")) + moved, {});
  CAPTURE(of_part);
  CHECK(of_part.find("joints.default") != std::string::npos);
  CHECK(of_part.find("base.part[0].motion.to") != std::string::npos);
  // A fault of the model's own tables leaves values unread, and nothing is built of the rest.
  CHECK(refusal("title = \"t\"\n" + text + "[contact]\nfriction = \"much\"\n", {}).find("joints.default") == std::string::npos);
}

TEST_CASE("faults: those that the model shows are told in the order of lines, too") {
  const io::LoadedCase c = read_case(
      {"test.toml", "title = \"t\"\n[materials.m]\ndensity = 1\nyoung = 1e7\npoisson = 0.2\n" + kBlock + "box = [[0, 0, 0], [1, 1, 1]]\n"});
  const cases::InputErrors two({{"block[0].name", "is second"}, {"materials.m.density", "is first"}});
  CHECK(c.describe(two) == "test.toml:3: materials.m.density = 1 kg/m3 is first\ntest.toml:7: block[0].name = \"a\" is second");
}
