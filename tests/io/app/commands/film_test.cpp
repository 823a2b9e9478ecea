// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

// Films with the real Chromium and the real ffmpeg, where both are installed, and mode shapes in the page.

namespace {

using shell::voussoir;

/// A brick upon a brick, bonded, for a hundredth of a second; the folder of its results.
std::string run_of_two_bricks(const TempFolder& folder) {
  std::ofstream(folder.path("case.toml")) << R"(title = "two bricks"
[gravity]
settle = false
[time]
duration = 0.01
[materials.stone]
density = 2000.0
young = 1e8
poisson = 0.2
[joint_laws.mortar]
tension = 1e5
cohesion = 1e5
friction = 30.0
compression = 1e6
cap = 9.0
thickness = 0.01
young = 1e8
poisson = 0.2
[joints]
default = "mortar"
[base]
z = 0.0
[[block]]
name = "lower"
material = "stone"
box = [[0, 0, 0], [0.2, 0.1, 0.1]]
[[block]]
name = "upper"
material = "stone"
box = [[0, 0, 0.1], [0.2, 0.1, 0.2]]
)";
  std::string out = folder.path("out");
  REQUIRE(voussoir("run " + folder.path("case.toml") + " --quiet -j 1 --frames 0.005 -o " + out).code == 0);
  return out;
}

bool installed(const std::string& programs) {
  return shell::code_of("for p in " + programs + "; do command -v $p && exit; done >/dev/null; exit 1") == 0;
}

}  // namespace

TEST_CASE("a film is an MP4, a WebM or a GIF by the ending of its name") {
  if (!installed("ffmpeg") || !installed("chromium chromium-browser google-chrome")) {
    MESSAGE("not tested: Chromium or ffmpeg is not installed");
    return;
  }
  const TempFolder folder;
  const std::string out = run_of_two_bricks(folder);
  const auto film = [&](const std::string& name) {
    const shell::Outcome o = voussoir("report " + out + " --speed 0.05 --film " + folder.path(name));
    CHECK_MESSAGE(o.code == 0, o.text);
    CHECK(o.text.find("6 pictures") != std::string::npos);  // 0.01 s twenty times slower, 25 a second
    return shell::text_of(folder.path(name));
  };
  CHECK(film("film.mp4").substr(4, 4) == "ftyp");
  CHECK(film("film.webm").starts_with("\x1a\x45\xdf\xa3"));  // EBML
  const std::string gif = film("film.gif");
  CHECK(gif.starts_with("GIF89a"));
  CHECK(gif.size() > 10000);
}

TEST_CASE("without a Chromium there is a message, and no film") {
  const TempFolder folder;
  const std::string out = run_of_two_bricks(folder);
  ::setenv("CHROMIUM", "/nowhere/chromium", 1);
  ::setenv("FFMPEG", "true", 1);
  const shell::Outcome o = voussoir("report " + out + " --film " + folder.path("film.webm"));
  ::unsetenv("CHROMIUM");
  ::unsetenv("FFMPEG");
  CHECK(o.code == 3);
  CHECK(o.text.find("Debian: chromium") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(folder.path("film.webm")));
}

TEST_CASE("a page holds as many mode shapes as it was asked for, of one run alone") {
  const TempFolder folder;
  const std::string out = run_of_two_bricks(folder);
  CHECK(voussoir("report " + out + " --modes 2").code == 0);
  const std::string page = shell::text_of(out + "/report.html");
  const std::size_t at = page.find("id=\"modes\">");
  REQUIRE(at != std::string::npos);
  const std::string list = page.substr(at, page.find("</script>", at) - at);
  std::size_t modes = 0;
  for (std::size_t i = list.find("\"frequency\""); i != std::string::npos; i = list.find("\"frequency\"", i + 1)) ++modes;
  CHECK(modes == 2);
  CHECK(page.find("id=\"mode-shapes\">") != std::string::npos);
  CHECK(voussoir("report " + out + " " + out + " --modes 2").code == 2);
  CHECK(voussoir("report " + out + " --modes 0").code == 2);
}
