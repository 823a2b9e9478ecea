// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

// What goes wrong must not look like success, and what is there must stay there.
namespace {

using shell::Outcome;
using shell::text_of;
using shell::voussoir;
namespace fs = std::filesystem;

constexpr const char* kPillar = R"(title = "two blocks"
[gravity]
settle = false
[time]
duration = 0.05
[output]
frame_interval = 0.01
[materials.stone]
density = 2000.0
young = 1e9
poisson = 0.2
[joint_laws.mortar]
tension = 1e5
cohesion = 1e5
friction = 30.0
compression = 1e6
[joints]
default = "mortar"
[base]
z = 0.0
[[block]]
name = "a"
material = "stone"
box = [[0, 0, 0], [0.2, 0.2, 0.2]]
[[block]]
name = "b"
material = "stone"
box = [[0, 0, 0.2], [0.2, 0.2, 0.4]]
)";

struct Pillar {
  TempFolder folder;
  std::string file = folder.write("pillar.toml", kPillar);
  [[nodiscard]] Outcome run(const std::string& name, const std::string& words = "") const {
    return voussoir("run " + shell::quoted(file) + " -j 1 --quiet -o " + results(name) + " " + words);
  }
  [[nodiscard]] std::string results(const std::string& name) const { return shell::quoted(folder.path(name)); }
};

void refused(const Outcome& o, int code, const std::string& message) {
  CHECK(o.code == code);
  CAPTURE(o.text);
  CHECK(o.text.find(message) != std::string::npos);
}

}  // namespace

TEST_CASE("a run whose numbers blow up fails, however short it is, and check says so before") {
  const Pillar pillar;
  refused(pillar.run("blown", "--dt 0.001 --duration 0.01"), 1, "numerical failure");
  refused(voussoir("check " + shell::quoted(pillar.file) + " --set time.step=0.001"), 2, "a fault: the first steps go wrong");
  CHECK(pillar.run("large", "--dt 0.0002 --duration 0.001")
            .text.find("warning: the step of 0.0002 s is longer than the largest stable one") != std::string::npos);
  refused(pillar.run("tiny", "--dt 1e-20"), 2, "time.step = 1e-20 s is out of range; allowed: at least 1e-9");
}

TEST_CASE("results of another run are not gone on with, and a resume that is refused changes nothing") {
  const Pillar pillar;
  REQUIRE(pillar.run("one").code == 0);
  REQUIRE(pillar.run("other", "--set materials.stone.density=2001").code == 0);
  fs::copy_file(pillar.folder.path("other/run.h5"), pillar.folder.path("one/run.h5"), fs::copy_options::overwrite_existing);
  const std::string before = text_of(pillar.folder.path("one/case.toml"));
  refused(voussoir("resume " + pillar.results("one") + " --until 0.06 --quiet -j 1"), 3, "results of two runs do not go together");
  CHECK(text_of(pillar.folder.path("one/case.toml")) == before);
  CHECK(voussoir("resume " + pillar.results("other") + " --until 0.06 --quiet -j 1").code == 0);
  // A name in parts/ that no program gives.
  pillar.folder.write("other/parts/99999999999999999999999.h5", "");
  CHECK(voussoir("resume " + pillar.results("other") + " --until 0.07 --quiet -j 1").code == 0);
}

TEST_CASE("--overwrite removes what runs write, not a copy of a checkpoint; a table does not replace the record it is made from") {
  const Pillar pillar;
  REQUIRE(pillar.run("results").code == 0);
  pillar.folder.write("results/checkpoint-keep.h5", "mine");
  CHECK(pillar.run("results", "--overwrite").code == 0);
  CHECK(text_of(pillar.folder.path("results/checkpoint-keep.h5")) == "mine");
  const std::string record = pillar.folder.write("a.csv", "t [s], a [m/s2]\n0.0, 0.0\n0.1, 1.0\n0.2, 0.0\n"), was = text_of(record);
  refused(voussoir("motion " + shell::quoted(record) + " --spectra " + shell::quoted(record) + " --overwrite"), 3,
          "is an input of this command");
  CHECK(text_of(record) == was);
}

TEST_CASE("a run that makes no step is refused, by check too; check of results takes no words of a case") {
  const Pillar p;
  for (const char* duration : {"1e-300", "1e-9"}) {
    const std::string words = std::string("--set time.duration=") + duration;
    refused(p.run("none", words), 2, "makes no step");
    refused(voussoir("check " + shell::quoted(p.file) + " -j 1 " + words), 2, "makes no step");
  }
  CHECK(p.run("model", "--set time.duration=0").code == 0);
  CHECK(p.run("some").code == 0);
  for (const char* words : {"--draw x.svg", "--bill", "-j 3", "--set time.duration=5", "--duration 2"})
    refused(voussoir("check " + p.results("some") + " " + words), 2, "goes with a case");
  CHECK(voussoir("check " + p.results("some") + " --format json").code == 0);
}

TEST_CASE("words that mean nothing are refused with what is allowed; lost output is an error") {
  const Pillar pillar;
  refused(voussoir("runn x.toml"), 2, "\"runn\" is no command; is \"run\" meant?; allowed: new, cases");
  refused(pillar.run("nan", "--checkpoint-every nan"), 2, "--checkpoint-every");
  REQUIRE(pillar.run("done").code == 0);
  refused(voussoir("assess " + pillar.results("done") + " --time 99"), 2, "--time: = 99 s; allowed: from 0 to 0.05");
  refused(voussoir("assess " + pillar.results("done") + " --levels 5"), 2, "--levels: = 5 m; allowed: from 0 to 0 m");
  CHECK(shell::code_of(shell::kProgram + " summary " + pillar.results("done") + " >/dev/full 2>/dev/null") == 3);
  CHECK(shell::code_of(shell::kProgram + " cases >/dev/full 2>/dev/null") == 3);
}

TEST_CASE("an empty word, as of a variable that is not set, is refused with its name") {
  for (const char* words : {"summary", "assess", "report", "check", "compare x", "resume", "motion", "study", "run", "view", "bench", "modes", "limit"}) {
    const shell::Outcome o = shell::run(std::string(shell::kProgram) + " " + words + " '' 2>&1");
    CHECK_MESSAGE(o.code == 2, words << ": " << o.text);
    CHECK_MESSAGE(o.text.find(": is empty\n") != std::string::npos, words << ": " << o.text);
  }
  const shell::Outcome o = shell::run(std::string(shell::kProgram) + " run hut -o '' 2>&1");
  CHECK_MESSAGE(o.text.find("--output: is empty\n") != std::string::npos, o.text);
}

TEST_CASE("a file that cannot be written is named before the work") {
  const Pillar pillar;
  const std::string file = shell::quoted(pillar.file), nowhere = shell::quoted(pillar.folder.path("nowhere/x")),
                    message = "nowhere/x: cannot be written: there is no folder";
  for (const char* words : {"modes --no-impulse --shapes ", "limit --mechanism ", "check --draw ", "bench --csv ", "view -o "})
    refused(voussoir(words + nowhere + " " + file), 3, message);
}

TEST_CASE("bench takes a case with several rates, and leaves a checkpoint as it is") {
  const Pillar pillar;
  CHECK(voussoir("bench " + shell::quoted(pillar.file) + " -j 1 --set time.multirate=2 --batches 1 --steps 5").code == 0);
  REQUIRE(pillar.run("done").code == 0);
  const std::string checkpoint = shell::quoted(pillar.folder.path("done/checkpoint-000001.h5"));
  refused(voussoir("bench " + checkpoint + " -j 1 --after 1"), 2, "a checkpoint is measured as it stands");
}
