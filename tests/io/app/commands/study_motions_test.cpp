// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <string>

#include "tests/io/app/commands/study_table.h"
#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

// The motions of studies (scripts/study): changed ones, what they have of the paper's record, and a frame that rocks under them.
namespace {

using shell::code_of;
using shell::text_of;
using study::script;

/// A folder with a record of 5 s: sines of 1 Hz, amplitudes in m/s2. That of T is another from 4 s on.
std::string sines(const TempFolder& folder, const std::string& name, double of_l, double of_t, double of_t_at_last) {
  const auto column = [](double amplitude, double at_last) {
    std::ostringstream text;
    text << "t [s], a [m/s2]\n";
    for (int k = 0; k <= 1000; ++k) {
      text << 0.005 * k << ", " << (k < 800 ? amplitude : at_last) * std::sin(2.0 * std::acos(-1.0) * 0.005 * k) << "\n";
    }
    return text.str();
  };
  folder.write(name + "/L.csv", column(of_l, of_l));
  folder.write(name + "/T.csv", column(of_t, of_t_at_last));
  folder.write(name + "/record.toml", "name = \"" + name + "\"\nL = \"L.csv\"\nT = \"T.csv\"\n");
  return folder.path(name);
}

}  // namespace

TEST_CASE("motions: peaks of L, and at how many frequencies its spectrum lies above or below that of T") {
  const TempFolder folder;
  const std::string out = folder.path("table.md");
  const std::string words =
      sines(folder, "pair-1", 2.0, 1.0, 1.0) + " " + sines(folder, "pair-2", 1.0, 1.5, 1.5) + " " + sines(folder, "late-1", 1.0, 0.5, 20.0);
  REQUIRE(code_of("VOUSSOIR=" + shell::kProgram + " " + script("motions.py") + words + " >" + out) == 0);
  const std::string text = text_of(out);
  CHECK(text.starts_with("| motion | realisations | peak acceleration of L, m/s2 | peak velocity, m/s | peak displacement, m |"));
  // From rest, a sine of amplitude a and circular frequency w leaves a velocity of up to 2 a/w, and a displacement of a t/w at a whole
  // cycle. In its first 3.5 s T of `late` is the weaker one.
  CHECK(text.find("\n| `pair` | 2 | 1.00 to 2.00 | 0.32 to 0.64 | 0.80 to 1.59 | 0 to 100 | 0 to 100 |\n") != std::string::npos);
  CHECK(text.ends_with("\n| `late` | 1 | 1.00 | 0.32 | 0.80 | 100 | 100 |\n"));
}

TEST_CASE(
    "changed motions: half of the pulse is half of the displacement, what is left without it is small, T ends at rest, L can lie below T") {
  if (code_of("/usr/bin/python3 -c 'import numpy' 2>/dev/null") != 0) {
    MESSAGE("skipped: no numpy for /usr/bin/python3; scripts/setup study installs it");
    return;
  }
  const TempFolder folder;
  const std::string out = folder.path("peaks.md");
  REQUIRE(code_of("VOUSSOIR=" + shell::kProgram + " " + script("changed_motions") + folder.path("motions") + " 4 >" + out) == 0);
  std::istringstream lines(text_of(out));
  std::map<std::string, std::array<double, 3>> peaks;  // m/s2, m/s, m
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string bar, name, letter;
    std::array<double, 3> p{};
    if (words >> bar >> name >> bar >> letter >> bar >> p[0] >> bar >> p[1] >> bar >> p[2]) peaks[name + " " + letter] = p;
  }
  REQUIRE(peaks.size() == 10);
  const auto displacement = [&](const char* motion) { return peaks.at(motion)[2] / peaks.at("bam-like#4 L")[2]; };
  CHECK(displacement("pulse50-4 L") == doctest::Approx(0.5).epsilon(0.03));
  CHECK(displacement("pulse25-4 L") == doctest::Approx(0.25).epsilon(0.06));
  CHECK(displacement("pulse0-4 L") < 0.15);  // of the short waves
  CHECK(peaks.at("strongT200-4 T")[0] == doctest::Approx(2.0 * peaks.at("bam-like#4 T")[0]).epsilon(0.01));
  CHECK(peaks.at("strongT200-4 T")[1] > 1.7 * peaks.at("bam-like#4 T")[1]);
  // L of the paper's Fig. 9 (b): the peak acceleration is kept, the velocity is not.
  CHECK(peaks.at("fig9-4 L")[0] == doctest::Approx(peaks.at("bam-like#4 L")[0]).epsilon(1e-3));
  CHECK(peaks.at("fig9-4 L")[2] > 2.0 * peaks.at("pulse0-4 L")[2]);  // as much of the pulse as may be, not none
  CHECK(peaks.at("fig9-4 L")[1] < 0.7 * peaks.at("bam-like#4 L")[1]);
  // A quarter of the pulse, and a short wave that alters nothing but the peak acceleration.
  CHECK(peaks.at("paper-4 L")[0] == doctest::Approx(peaks.at("bam-like#4 L")[0]).epsilon(1e-3));
  CHECK(peaks.at("paper-4 L")[2] == doctest::Approx(peaks.at("pulse25-4 L")[2]).epsilon(0.01));
  // The program reads them: figures of its own agree.
  const std::string figures = folder.path("figures");
  REQUIRE(code_of(shell::kProgram + " motion " + folder.path("motions/pulse50-4") + " >" + figures) == 0);
  CHECK(text_of(figures).find("pulse50-4") != std::string::npos);
}

// Small tilts, one constant acceleration of A times what the walls bear, from rest, for a time T: the frame overturns if exp(p T) exceeds
// A / (A - 1). Of the frame p is 2.2767 1/s, by (3 g / 4 R) (1 + 2 m) / (1 + 3 m) with R = 1.2042 m and m = 0.27546: T = 0.3045 s for A
// = 2.
TEST_CASE("rocking frame: it stands below what the walls bear, and overturns by a constant acceleration that lasts long enough") {
  if (code_of("/usr/bin/python3 -c 'import numpy' 2>/dev/null") != 0) {
    MESSAGE("skipped: no numpy for /usr/bin/python3; scripts/setup study installs it");
    return;
  }
  const TempFolder folder;
  const std::string out = folder.path("falls"), ask = folder.write("ask.py", R"(import math, sys
import numpy as np
sys.path.insert(0, sys.argv[1])
import rocking_frame as frame
t = np.arange(0.0, 6.0, frame.STEP)
for times, last in ((0.99, 6.0), (2.0, 0.3045 * 0.95), (2.0, 0.3045 * 1.05), (-2.0, 0.3045 * 1.05)):
    a = np.where(t < last, times * frame.GRAVITY * math.atan2(0.2, 2.4), 0.0)
    print(int(frame.falls_at(a, np.zeros_like(a)) > 0), end=" ")
print(f"{frame.REBOUND:.4f}")
)");
  REQUIRE(code_of("/usr/bin/python3 " + ask + " " + shell::source("scripts/study") + " >" + out) == 0);
  CHECK(text_of(out) == "0 0 1 1 0.9881\n");
}
