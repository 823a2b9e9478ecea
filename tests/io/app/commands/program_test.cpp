// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

// The program as a user meets it: exit codes, messages, and that nothing is touched when the input is bad.

namespace {

using shell::Outcome;

using shell::voussoir;

constexpr const char* kHead = R"(title = "test"
[gravity]
settle = false
[time]
duration = 0.01
[materials.stone]
density = 2000.0
young = 1e8
poisson = 0.2
[joints]
default = "dry"
[base]
z = 0.0
)";

std::string block(const std::string& name, const std::string& shape) {
  return "[[block]]\nname = \"" + name + "\"\nmaterial = \"stone\"\n" + shape + "\n";
}
std::string box(const std::string& name, const std::string& low, const std::string& high, const std::string& more = "") {
  return block(name, "box = [" + low + ", " + high + "]\n" + more);
}

/// Checks a case with the given text after the head.
Outcome check(const TempFolder& folder, const std::string& rest, const std::string& more = "") {
  std::ofstream(folder.path("case.toml")) << kHead << rest;
  return voussoir("check " + folder.path("case.toml") + " " + more);
}

bool says(const Outcome& o, std::initializer_list<const char*> parts) {
  for (const char* p : parts) {
    if (o.text.find(p) != std::string::npos) continue;
    MESSAGE("missing '" << std::string(p) << "' in: " << o.text);
    return false;
  }
  return true;
}

}  // namespace

TEST_CASE("each kind of bad input gets its message with file, line and key, and exit code 2") {
  const TempFolder folder;
  const std::string good = box("a", "[0,0,0]", "[0.2,0.2,0.2]");
  REQUIRE(check(folder, good).code == 0);

  Outcome o = check(folder, good + "colour = \"red\"\n");
  CHECK(o.code == 2);
  CHECK(says(o, {"case.toml:19", "colour"}));
  o = check(folder, box("a", "[0,0,0]", "[0.2,0.2,\"x\"]"));
  CHECK(o.code == 2);
  CHECK(says(o, {"case.toml:17", "box"}));
  o = check(folder, good, "--set materials.stone.density=-3");
  CHECK(o.code == 2);
  CHECK(says(o, {"--set", "materials.stone.density", "-3", "> 0"}));
  o = check(folder, good + box("b", "[0.1,0.1,0.1]", "[0.3,0.3,0.3]"));
  CHECK(o.code == 2);
  CHECK(says(o, {"case.toml:", "overlap", "\"a\"", "\"b\""}));
  o = check(folder, good + box("b", "[1,1,1]", "[1.2,1.2,1.2]"));
  CHECK(o.code == 2);
  CHECK(says(o, {"case.toml:", "touches nothing", "\"b\""}));
  o = check(folder, block("c", "vertices = [[0,0,0],[1,0,0],[0.4,0.4,0],[0,1,0],[0,0,1],[1,0,1],[0.4,0.4,1],[0,1,1]]"));
  CHECK(o.code == 2);
  CHECK(says(o, {"case.toml:", "convex"}));
  o = check(folder, block("c", "vertices = [[0,0,1],[1,0,1],[1,1,1],[0,1,1],[0,0,0],[1,0,0],[1,1,0],[0,1,0]]"));
  CHECK(o.code == 2);
  CHECK(says(o, {"case.toml:", "inside out"}));
  o = check(folder, good + "[motion]\nrecord = \"bamlike\"\n");
  CHECK(o.code == 2);
  CHECK(says(o, {"case.toml:", "motion.record", "bam-like"}));
  o = check(folder, "[[block\n");
  CHECK(o.code == 2);
  CHECK(says(o, {"case.toml:14"}));
  o = check(folder, box("a", "[0,0,-0.1]", "[0.2,0.2,0.2]"));
  CHECK(o.code == 2);
  CHECK(says(o, {"below"}));
}

TEST_CASE("missing files give exit code 3, wrong words on the command line 2") {
  const TempFolder folder;
  CHECK(voussoir("check " + folder.path("no.toml")).code == 3);
  std::ofstream(folder.path("m.toml")) << kHead << box("a", "[0,0,0]", "[0.2,0.2,0.2]") << "[motion]\nx = \"none.AT2\"\n";
  const Outcome o = voussoir("check " + folder.path("m.toml"));
  CHECK(o.code == 3);
  CHECK(says(o, {"none.AT2"}));
  CHECK(voussoir("").code == 2);
  CHECK(voussoir("fly").code == 2);
  CHECK(voussoir("run flat20n --kernels slow").code == 2);
  CHECK(voussoir("run nohouse").code == 2);
  CHECK(voussoir("motion " + folder.path("no.AT2")).code == 3);
}

TEST_CASE("help, version, catalogue and keys are printed with exit code 0") {
  CHECK(says(voussoir("--help"), {"run", "check", "motion", "cases", "example"}));
  CHECK(voussoir("--version").code == 0);
  CHECK(says(voussoir("cases"), {"flat20n", "flat40n"}));
  CHECK(says(voussoir("keys"), {"joint_laws", "frame_interval"}));
  CHECK(says(voussoir("check flat20n"), {"4,263", "5.028e-05", "lintel", "no faults"}));
}

TEST_CASE("check draws and modes lists frequencies, and neither writes over a file unless told to") {
  const TempFolder folder;
  const std::string draw = "check arch --draw " + folder.path("arch.svg");
  CHECK(says(voussoir(draw), {"bill of blocks", "adobe voussoir, hexahedron", "arch.svg", "no faults"}));
  // A long bill ends with what the shorter kinds are together.
  const Outcome some = voussoir("check farmhouse -j 1"), all = voussoir("check farmhouse -j 1 --bill");
  CHECK(says(some, {" other kinds (--bill: all)"}));
  CHECK(all.text.find("other kinds") == std::string::npos);
  CHECK(all.text.size() > some.text.size());
  CHECK(voussoir(draw).code == 3);
  CHECK(voussoir(draw + " --overwrite").code == 0);
  const std::string modes = "modes arch --count 3 --quiet -j 1 --shapes " + folder.path("arch.vtu");
  CHECK(says(voussoir(modes), {"eigenvalues", "impulse", "crown"}));
  CHECK(std::filesystem::exists(folder.path("arch.vtu")));
  CHECK(voussoir(modes + " --no-impulse").code == 3);
  CHECK(voussoir(modes + " --no-impulse --overwrite").code == 0);
}

TEST_CASE("bench keeps its two tables as CSV, each in a file of its own, and replaces none unless told to") {
  const TempFolder folder;
  check(folder, box("a", "[0, 0, 0]", "[1, 1, 1]") + box("b", "[0, 0, 1]", "[1, 1, 2]"));
  const auto bench = [&](const std::string& more) {
    return voussoir("bench " + folder.path("case.toml") + " -j 2 --batches 1 --steps 20 --csv " + folder.path("t.csv") + " " + more);
  };
  Outcome o = bench("--stages-csv " + folder.path("t.csv"));
  CHECK(o.code == 3);
  CHECK(says(o, {"t.csv", "is named twice"}));
  CHECK_FALSE(std::filesystem::exists(folder.path("t.csv")));
  o = bench("--stages-csv " + folder.path("s.csv"));
  REQUIRE(o.code == 0);
  const auto lines = [&](const char* name) {
    std::ifstream file(folder.path(name));
    std::vector<std::string> all;
    for (std::string line; std::getline(file, line);) all.push_back(line);
    return all;
  };
  const std::vector<std::string> timings = lines("t.csv"), stages = lines("s.csv");
  CHECK(timings.size() == 1 + 2);      // on one thread and on two
  CHECK(stages.size() == 1 + 2 * 11);  // ten parts and the step
  const auto commas = [](const std::string& line) { return std::ranges::count(line, ','); };
  for (const auto& table : {timings, stages}) {
    for (const std::string& line : table) CHECK(commas(line) == commas(table.front()));
  }
  o = bench("");
  CHECK(o.code == 3);
  CHECK(says(o, {"t.csv", "exists"}));
  CHECK(lines("t.csv") == timings);
}

TEST_CASE("a run writes its results, and never over another's unless told to") {
  const TempFolder folder;
  std::ofstream(folder.path("case.toml")) << kHead << box("a", "[0,0,0]", "[0.2,0.2,0.2]");
  const std::string words = "run " + folder.path("case.toml") + " --quiet -j 1 -o " + folder.path("out");
  Outcome o = voussoir(words);
  CHECK(o.code == 0);
  CHECK(says(o, {"collapsed", "joints failed first  0 points in tension, 0 in shear", "joints opened        0 points in", "energy error",
                 "run.h5"}));
  CHECK(std::filesystem::exists(folder.path("out/run.h5")));
  CHECK(std::filesystem::exists(folder.path("out/case.toml")));
  CHECK(says(voussoir("summary " + folder.path("out")),
             {"finished at", "fallen mass", "debris", "joints failed first  0 points in tension, 0 in shear, 0 in compression\n",
              "joints opened        0 points in tension, 0 in shear, 0 in compression; 0 have slipped and hold\n"}));
  CHECK(says(voussoir("summary " + folder.path("out") + " --format json"),
             {"\"damage_grade\": -1", "\"walls\": []", "\"state_hash\"", "\"first_shear\": 0", "\"shear\": 0"}));
  CHECK(voussoir("summary " + folder.path("nowhere")).code == 3);
  o = voussoir(words);
  CHECK(o.code == 3);
  CHECK(says(o, {"--overwrite"}));
  CHECK(voussoir(words + " --overwrite").code == 0);
  // Bad input is found before the folder is touched.
  CHECK(voussoir(words + " --overwrite --set time.duration=-1").code == 2);
  CHECK(std::filesystem::exists(folder.path("out/run.h5")));
}

TEST_CASE("files or a record on the command line take the place of those that the case names") {
  const TempFolder folder;
  const std::string file = folder.write("rest.csv", "t [s], a [m/s2]\n0, 0\n0.005, 0\n0.01, 0\n"),
                    other = folder.write("other.csv", "t [s], a [m/s2]\n0, 0\n1, 0\n");
  const auto begin = [&](const std::string& motion, const std::string& words) {
    std::ofstream(folder.path("case.toml")) << kHead << box("a", "[0,0,0]", "[0.2,0.2,0.2]") << "[motion]\n" << motion << '\n';
    return voussoir("run " + folder.path("case.toml") + " --quiet --overwrite -j 1 -o " + folder.path("out") + " " + words);
  };
  const Outcome missing = begin("x = \"none.csv\"", "");
  CHECK(missing.code == 3);
  CHECK(says(missing, {"case.toml:", "motion.x = \"none.csv\" cannot be used: ", "none.csv: no such file"}));
  // What a run keeps of its case means the same from anywhere, through links too, and is the same wherever its files lie.
  REQUIRE(begin("x = \"rest.csv\"", "").code == 0);
  CHECK(voussoir("check " + folder.path("out/case.toml")).code == 0);
  std::filesystem::create_directories(folder.path("far/cases"));
  std::filesystem::copy_file(file, folder.path("far/rest.csv"));
  std::filesystem::copy_file(folder.path("case.toml"), folder.path("far/cases/case.toml"));
  std::filesystem::create_directory_symlink(folder.path("far/cases"), folder.path("link"));
  const std::string linked = folder.path("link/case.toml") + " --set 'motion.x=\"../rest.csv\"'";
  REQUIRE(voussoir("run " + linked + " --quiet -j 1 -o " + folder.path("other")).code == 0);
  std::filesystem::remove(file);
  CHECK(voussoir("check " + folder.path("other/case.toml")).code == 0);
  CHECK(says(voussoir("compare " + folder.path("out") + " " + folder.path("other")), {"identical"}));
  std::filesystem::copy_file(folder.path("far/rest.csv"), file);
  const std::string shipped = "record = \"bam-like\"\ndirection = \"TLV\"";
  CHECK(begin(shipped, "--motion x=" + file).code == 0);
  CHECK(says(begin(shipped, "--motion x=" + file + " --direction TLV"), {"direction", "files are given for x, y, z"}));
  CHECK(begin(shipped, "--motion L=" + file).code == 0);
  CHECK(begin("x = \"" + file + "\"", "--motion T=" + other).code == 0);
  CHECK(begin("L = \"" + file + "\"\ndirection = \"TLV\"", "--motion y=" + other).code == 0);
  CHECK(begin("x = \"" + file + "\"", "--record bam-like").code == 0);
  CHECK(says(begin(shipped, "--motion x=" + file + " --motion L=" + other), {"does not go with motion.x"}));
  CHECK(says(begin(shipped, "--record bam-like --motion x=" + file), {"does not go with motion.record"}));
}

TEST_CASE("what people look at: written at the end of a run if asked for, or later; pictures say what they lack") {
  const TempFolder folder;
  std::ofstream(folder.path("case.toml")) << kHead << box("a", "[0,0,0]", "[0.2,0.2,0.2]");
  const std::string out = folder.path("out"), words = "run " + folder.path("case.toml") + " --quiet -j 1 -o " + out + " --frames 0.005";
  Outcome o = voussoir(words + " --report --paraview");
  CHECK(o.code == 0);
  CHECK(says(o, {"/out/report.html", "/out/run.xdmf"}));
  for (const char* name : {"report.html", "run.xdmf", "paraview.h5"}) CHECK(std::filesystem::exists(out + "/" + name));
  CHECK(voussoir(words + " --overwrite").code == 0);  // none of them is of this run
  for (const char* name : {"report.html", "run.xdmf", "paraview.h5"}) CHECK_FALSE(std::filesystem::exists(out + "/" + name));
  CHECK(says(voussoir("resume " + out + " --quiet -j 1 --report"), {"is finished", "report.html"}));

  CHECK(voussoir("report " + out).code == 3);  // it is there
  CHECK(voussoir("report --paraview " + out).code == 0);
  CHECK(voussoir("report --paraview " + out).code == 3);
  CHECK(voussoir("report " + out + " --view front").code == 2);
  CHECK(voussoir("report " + out + " --stills 0.005 --view under").code == 2);
  o = voussoir("report --stills 0.005,9 --view front,top " + out);
  CHECK(o.code == 2);
  CHECK(says(o, {"--stills", "9 s", "0 to 0.01 s"}));
  ::setenv("CHROMIUM", "/nowhere/chromium", 1);
  o = voussoir("report --stills 0.005,0.0149 --view front,top " + out);  // the latter nearest to the last frame
  const Outcome pair = voussoir("report " + out + " " + out + " --stills 0");
  ::unsetenv("CHROMIUM");
  CHECK(o.code == 0);
  CHECK(says(o, {"no Chromium was found", "plain", "/stills/front-0.005s.png", "/stills/top-0.0149s.png"}));
  CHECK(shell::text_of(out + "/stills/front-0.005s.png").starts_with("\x89PNG"));
  CHECK(pair.code == 3);
  CHECK(says(pair, {"/nowhere/chromium", "cannot start", "Debian: chromium"}));
  const std::string plain = shell::text_of(out + "/stills/top-0.0149s.png");
  CHECK(voussoir("report " + out + " --stills 0.0149 --view top --plain").code == 3);  // it is there
  CHECK(says(voussoir("report " + out + " --stills 0.0149 --view top --plain --overwrite"), {"/stills/top-0.0149s.png"}));
  CHECK(shell::text_of(out + "/stills/top-0.0149s.png") == plain);
  CHECK(voussoir("report " + out + " --stills 0.01,0.01 --plain -o " + out + "/twice").code == 0);
  CHECK(says(voussoir("report " + out + " --plain"), {"--plain", "needs --stills"}));
  CHECK(says(voussoir("report " + out + " " + out + " --plain --stills 0"), {"--plain", "one run"}));
  CHECK(says(voussoir("report " + out + " --stills 0.005 0.01, 9"), {"--stills", "9 s"}));  // commas and spaces
  CHECK(says(voussoir("report " + out + " --stills 0.005,1x"), {"--stills", "'1x' is no number"}));
}

TEST_CASE("a film says what it lacks, two runs make one page, and a run writes its page while it goes on") {
  const TempFolder folder;
  std::ofstream(folder.path("case.toml")) << kHead << box("a", "[0,0,0]", "[0.2,0.2,0.2]");
  const std::string out = folder.path("out"), words = "run " + folder.path("case.toml") + " --quiet -j 1 -o " + out + " --frames 0.005";
  CHECK(voussoir(words + " --report-every 0").code == 2);
  CHECK(voussoir(words + " --report-every 30").code == 0);
  CHECK(std::filesystem::exists(out + "/report.html"));

  Outcome o = voussoir("report " + out + " --film " + folder.path("film.avi"));
  CHECK(o.code == 2);
  CHECK(says(o, {"--film", "film.avi", ".mp4, .webm, .gif"}));
  CHECK(voussoir("report " + out + " --film " + folder.path("film.mp4") + " --stills 0").code == 2);
  CHECK(voussoir("report " + out + " --film " + folder.path("film.mp4") + " --view front,top").code == 2);
  ::setenv("FFMPEG", "/nowhere/ffmpeg", 1);
  o = voussoir("report " + out + " --film " + folder.path("film.mp4"));
  ::unsetenv("FFMPEG");
  CHECK(o.code == 3);
  CHECK(says(o, {"/nowhere/ffmpeg", "cannot start", "Debian: ffmpeg"}));
  CHECK_FALSE(std::filesystem::exists(folder.path("film.mp4")));
  std::ofstream(folder.path("film.mp4")) << "GIF89a";
  CHECK(says(voussoir("report " + out + " --film " + folder.path("film.mp4")), {"film.mp4", "--overwrite"}));

  CHECK(voussoir("report " + out + " " + out).code == 0);
  CHECK(std::filesystem::exists(out + "/comparison.html"));
  CHECK(voussoir("report " + out + " " + out + " --paraview").code == 2);
}

TEST_CASE("a step far too large ends with exit code 1, says what to try, and keeps the results") {
  const TempFolder folder;
  std::ofstream(folder.path("case.toml")) << kHead << box("a", "[0,0,0.0]", "[0.2,0.2,0.2]") << box("b", "[0,0,0.2]", "[0.2,0.2,0.4]")
                                          << "[[load]]\nblock = \"b\"\nforce = [100.0, 0.0, -1000.0]\n";
  const Outcome o = voussoir("run " + folder.path("case.toml") + " --quiet -j 1 --dt 0.01 --duration 20 -o " + folder.path("out"));
  CHECK(o.code == 1);
  CHECK(says(o, {"numerical failure", "--dt"}));
  CHECK(std::filesystem::exists(folder.path("out/run.h5")));
}

TEST_CASE("SIGTERM stops a run after its step, with the results so far and exit code 143") {
  const TempFolder folder;
  std::ofstream(folder.path("case.toml")) << kHead << box("a", "[0,0,0]", "[0.2,0.2,0.2]");
  const std::string out = folder.path("out");
  const Outcome o = voussoir("run " + folder.path("case.toml") + " --quiet -j 1 --duration 100000 -o " + out +
                             " & pid=$!; sleep 1; kill -TERM $pid; wait $pid; echo code $?");
  CHECK(says(o, {"code 143", "run.h5", " of 100000 s, shaking, by SIGTERM", "collapsed            not so far"}));
  CHECK(std::filesystem::exists(folder.path("out/run.h5")));
}

#if defined(__x86_64__)
TEST_CASE("memory is asked for ahead of its use: compilers may take that for nothing and leave it out (kernels/prefetch.h)") {
  const Outcome o = shell::run("objdump -d --no-show-raw-insn " + shell::kProgram + " | awk '/>:$/{ours = /voussoir/} ours && /prefetch/'");
  CHECK(o.code == 0);
  CHECK(o.text.find("prefetch") != std::string::npos);
}
#endif
