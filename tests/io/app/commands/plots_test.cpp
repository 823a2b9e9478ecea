// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

// The scripts that draw figures, on a run of the program. They need packages of Python that the program does not: where those are absent
// this says so and passes. In an SVG every word of a figure is text.
namespace {

using shell::text_of;

const std::string kCase = R"(title = "two bonded blocks"
[gravity]
settle = false
[time]
duration = 0.1
[materials.stone]
density = 2000.0
young = 1e8
poisson = 0.2
[joint_laws.mortar]
tension = 1e5
cohesion = 1e5
friction = 30.0
compression = 1e6
[joints]
default = "mortar"
[motion]
record = "bam-like"
[[output.history]]
name = "upper"
point = [0.1, 0.1, 0.3]
[[block]]
name = "a"
material = "stone"
box = [[0, 0, 0], [0.2, 0.2, 0.2]]
[[block]]
name = "b"
material = "stone"
box = [[0, 0, 0.2], [0.2, 0.2, 0.4]]
[base]
z = 0.0
)";

int code_of(const std::string& command) { return shell::code_of(command + " >/dev/null 2>&1"); }

/// A Python that has the packages; empty if none has.
std::string python() {
  for (const char* name : {"python3", "/usr/bin/python3"}) {
    if (code_of(std::string(name) + " -c 'import h5py, matplotlib, numpy'") == 0) return name;
  }
  MESSAGE("skipped: no python3 with h5py, numpy and matplotlib");
  return "";
}

std::string script(const char* name) { return " " + shell::source(std::string("scripts/") + name) + " "; }

/// The figure that the script draws with these words, as text.
std::string figure(const std::string& python, const TempFolder& folder, const char* name, const std::string& words) {
  const std::string path = folder.path("figure.svg");
  REQUIRE(code_of(python + script(name) + words + " -o " + path) == 0);
  return text_of(path);
}

bool has(const std::string& text, const std::string& word) { return text.find(">" + word + "<") != std::string::npos; }

}  // namespace

TEST_CASE("the scripts draw what a run and a table of spectra hold") {
  const std::string py = python();
  if (py.empty()) return;
  const TempFolder folder;
  const std::string run = folder.path("run"), table = folder.path("spectra.csv");
  const std::string voussoir = shell::kProgram;
  REQUIRE(code_of(voussoir + " run " + folder.write("case.toml", kCase) + " -j 1 -o " + run) == 0);
  REQUIRE(code_of(voussoir + " motion bam-like --spectra " + table) == 0);

  std::string drawn = figure(py, folder, "plot_histories.py", "First=" + run + " Second=" + run);
  for (const char* word : {"upper", "First", "Second", "time, s"}) CHECK(has(drawn, word));
  drawn = figure(py, folder, "plot_histories.py", run + " --show upper:z --quantity velocity");
  CHECK(has(drawn, "velocity z, m/s"));
  const std::string peaks = folder.path("peaks.csv");
  figure(py, folder, "plot_histories.py", "First=" + run + " --show upper:z --until 0.002 --peaks " + peaks);
  const std::string rows = text_of(peaks);
  CHECK(rows.starts_with("run,history,axis,peak [m],time [s]\nFirst,upper,z,"));
  CHECK(std::stod(rows.substr(rows.rfind(',') + 1)) <= 0.002);
  drawn = figure(py, folder, "plot_damage.py", run);
  for (const char* word : {"run", "opened by tension", "opened by shear", "opened by compression", "slipped, holds"})
    CHECK(has(drawn, word));
  drawn = figure(py, folder, "plot_damage.py", "--first " + run);
  for (const char* word : {"run", "reached first tension", "reached first shear", "reached first compression"}) CHECK(has(drawn, word));
  drawn = figure(py, folder, "plot_debris.py", "First=" + run + " " + run + " --below 5");
  for (const char* word : {"First, 0.10 s", "run, 0.10 s", "y, m"}) CHECK(has(drawn, word));
  drawn = figure(py, folder, "plot_energy.py", "Pair=" + run);
  for (const char* word : {"Pair", "ground and gravity", "fracture", "energy, kJ", "residual"}) CHECK(has(drawn, word));
  const std::string pushed = folder.path("pushed");
  REQUIRE(code_of(voussoir + " run " + folder.path("case.toml") + " --set analysis.kind=pushover --set analysis.longest=0.1 -j 1 -o " +
                  pushed) == 0);
  drawn = figure(py, folder, "plot_capacity.py", "Pushed=" + pushed + " --bilinear");
  for (const char* word : {"Pushed", "base shear, kN", "displacement of the control point, mm"}) CHECK(has(drawn, word));
  CHECK(code_of(py + script("plot_capacity.py") + run) == 1);
  drawn = figure(py, folder, "plot_spectra.py", table + " --quantity Sd --over period");
  for (const char* word : {"bam-like L, 2 %", "bam-like V, 2 %", "period, s", "displacement, m"}) CHECK(has(drawn, word));

  CHECK(code_of(py + script("plot_histories.py") + folder.path("nowhere")) == 1);
  CHECK(code_of(py + script("plot_histories.py") + run + " --show lower:x") == 1);
  CHECK(code_of(py + script("plot_spectra.py") + folder.path("case.toml")) == 1);
}

TEST_CASE("a picture and a plan show stones of any shape, by faces that look outward") {
  const std::string py = python();
  if (py.empty()) return;
  const TempFolder folder;
  const std::string shapes = R"([[block]]
name = "pyramid"
material = "stone"
vertices = [[1, 0, 0], [1.2, 0, 0], [1.2, 0.2, 0], [1, 0.2, 0], [1.1, 0.1, 0.2]]
faces = [[0, 3, 2, 1], [0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]
[[block]]
name = "wedge"
material = "stone"
polygon = [[2, 0], [2.2, 0], [2, 0.2]]
extrude = [0, 0.2]
)";
  const std::string run = folder.path("run");
  REQUIRE(code_of(shell::kProgram + " run " + folder.write("case.toml", kCase + shapes) + " -j 1 --duration 0.01 -o " + run) == 0);
  CHECK(has(figure(py, folder, "plot_debris.py", run), "run, 0.01 s"));
  CHECK(has(figure(py, folder, "render.py", run + " --time 0"), "0.00 s"));
  const std::string outward = folder.write("outward.py", R"(import sys
sys.path.insert(0, sys.argv[1])
import numpy
import render
run = render.Run(sys.argv[2])
assert set(run.kinds) == {10, 12, 13}
for cell, kind in zip(run.cells, run.kinds):
    corners = run.reference[cell[cell >= 0]]
    for face in render.FACES[int(kind)]:
        c = corners[list(face)]
        assert numpy.cross(c[1] - c[0], c[2] - c[0]) @ (c.mean(axis=0) - corners.mean(axis=0)) > 0, (kind, face)
)");
  CHECK(code_of(py + " " + outward + script("") + run) == 0);
}

TEST_CASE("a path that is there is no LABEL=DIR, though it has an = in it") {
  const std::string py = python();
  if (py.empty()) return;
  const TempFolder folder;
  const std::string run = folder.path("height=2,mortar=weak");
  REQUIRE(code_of(shell::kProgram + " run " + folder.write("case.toml", kCase) + " -j 1 --duration 0.01 -o " + run) == 0);
  CHECK(has(figure(py, folder, "plot_energy.py", run), "height=2,mortar=weak"));
  CHECK(has(figure(py, folder, "plot_energy.py", "Weak=" + run), "Weak"));
  CHECK(code_of("cd " + folder.path() + " && " + py + script("plot_energy.py") + "height=2,mortar=weak -o energy.svg") == 0);
}

TEST_CASE("a sheet of runs in folders of one name shows each run's own pictures, and makes them once") {
  const std::string py = python();
  if (py.empty()) return;
  const TempFolder folder;
  const std::string first = folder.path("a/run"), other = folder.path("b/run"), drawn = folder.path("drawn");
  REQUIRE(code_of(shell::kProgram + " run " + folder.write("case.toml", kCase) + " -j 1 --duration 0.01 -o " + first) == 0);
  std::filesystem::create_directory(folder.path("b"));
  std::filesystem::copy(first, other, std::filesystem::copy_options::recursive);
  // In place of the program, which needs a Chromium: it notes of which run a picture is wanted, and makes an empty one.
  const std::string stills = folder.write("stills.py", R"(import os, sys
from PIL import Image
kept = sys.argv[sys.argv.index("--output") + 1]
os.makedirs(kept, exist_ok=True)
Image.new("RGB", (40, 30)).save(os.path.join(kept, "corner-0.01s.png"))
open(")" + drawn + R"(", "a").write(sys.argv[2] + "\n")
)");
  const std::string program = folder.write("program", "#!/bin/sh\nexec " + py + " " + stills + " \"$@\"\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  const std::string sheet = py + script("contact_sheet.py") + first + " " + other + " --times 0.01 --voussoir " + program + " --stills " +
                            folder.path("kept") + " -o " + folder.path("sheet.png");
  for (int time = 0; time < 2; ++time) {
    REQUIRE(code_of(sheet) == 0);
    CHECK(text_of(drawn) == first + "\n" + other + "\n");
  }
}

TEST_CASE("capacity: runs of a case file lie in the folder that was named, and nowhere else") {
  const std::string py = python();
  if (py.empty()) return;
  const TempFolder folder;
  const std::string house = folder.write("house.toml", kCase), log = folder.path("log");
  // In place of the program: it notes where results go, and fails.
  const std::string program = folder.write("program", "#!/bin/sh\necho \"$5\" >" + log + "\nexit 3\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  CHECK(code_of("VOUSSOIR=" + program + " " + py + script("capacity") + house + " " + folder.path("runs") + " +x") == 1);
  CHECK(text_of(log) == folder.path("runs") + "/house+x-pushover\n");
}

TEST_CASE("a line through means over seeds has a gap where the thing came in some of them alone") {
  const std::string py = python();
  if (py.empty()) return;
  const TempFolder folder;
  std::string table = "run,case,direction,record,scale,options,seed,status,first_crack_time\n";
  const auto row = [&](const std::string& scale, const std::string& status, const std::string& time) {
    table += "r,house,LTV,,";
    table += scale + ",,0," + status + "," + time + "\n";
  };
  row("0.5", "done", "4.0"), row("0.5", "done", "-1.0");
  row("1.0", "done", "2.0"), row("1.0", "done", "3.0"), row("1.0", "to be done", "");
  row("2.0", "done", "1.0"), row("2.0", "done", "1.0");
  const std::string means = folder.write("means.py", R"(import csv, math, pathlib, sys
sys.path.insert(0, sys.argv[1] + "study")
import plot
figures = []
plot.run_file.save = lambda figure, path: figures.append(figure)
plot.draw(list(csv.DictReader(open(sys.argv[2]))), pathlib.Path(sys.argv[3]) / "first_crack_time.svg")
line, points = figures[0].axes[0].lines
assert list(line.get_xdata()) == [0.5, 1.0, 2.0]
assert math.isnan(line.get_ydata()[0]) and list(line.get_ydata()[1:]) == [2.5, 1.0], line.get_ydata()
assert list(points.get_ydata()) == [4.0, 2.0, 3.0, 1.0, 1.0]
)");
  const std::string words = " " + shell::source("scripts/") + " " + folder.write("table.csv", table) + " " + folder.path();
  CHECK(code_of(py + " " + means + words) == 0);
}
