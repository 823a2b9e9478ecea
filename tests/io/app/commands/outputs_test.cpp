// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "io/input/files/output_path.h"
#include "solver/limit/limit.h"
#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

// No output of any command replaces what is not a file of its own kind, an input, or the target of a link. A table of all outputs, each
// tried with every kind of thing that may be in its place.

namespace {

using shell::Outcome;
using shell::quoted;
using shell::text_of;
using shell::voussoir;
namespace fs = std::filesystem;

constexpr const char* kPart = R"([materials.stone]
density = 2000.0
young = 1e8
poisson = 0.2
)";
constexpr const char* kCase = R"(title = "a, block"
include = "part.toml"
[gravity]
settle = false
[time]
duration = 0.01
[output]
frame_interval = 0.005
[joints]
default = "dry"
[base]
z = 0.0
[[block]]
name = "a"
material = "stone"
part = "front wall"
box = [[0, 0, 0], [0.2, 0.2, 0.2]]
)";
constexpr const char* kRecord = "t [s], a [m/s2]\n0.0, 0.0\n0.1, 1.0\n0.2, 0.0\n";

/// An output: the words that ask for it, where it is, and the inputs of its command. All paths are in the folder of the test.
struct Row {
  std::string words, output;
  std::vector<std::string> inputs;
};

std::vector<Row> rows() {
  const std::vector<std::string> of_case{"case.toml", "part.toml"}, of_run{"done/run.h5"}, of_record{"a.csv"};
  std::vector<Row> all{
      {"check case.toml -j 1 --draw out.svg", "out.svg", of_case},
      {"view case.toml -j 1 -o out.html", "out.html", of_case},
      {"view case.toml -j 1 --still out.png", "out.png", of_case},
      {"modes case.toml -j 1 --no-impulse --shapes out.vtu", "out.vtu", of_case},
      {"bench case.toml -j 1 --batches 1 --steps 5 --csv out.csv", "out.csv", of_case},
      {"bench case.toml -j 1 --batches 1 --steps 5 --stages-csv out.csv", "out.csv", of_case},
      {"motion a.csv --spectra out.csv", "out.csv", of_record},
      {"motion rec --write out", "out/L.csv", {"rec/b.csv", "rec/record.toml"}},
      {"motion rec --write out", "out/record.toml", {"rec/b.csv", "rec/record.toml"}},
      {"assess done --spectra out.csv", "out.csv", of_run},
      {"assess done --maps out --time 0.01", "out/front-wall-0.010s.svg", of_run},
      {"report done -o out.html", "out.html", of_run},
      {"report done --film out.mp4", "out.mp4", of_run},
      {"report done --stills 0 -o out", "out/corner-0s.png", of_run},
      {"report done --paraview", "done/run.xdmf", of_run},
      {"report done --paraview", "done/paraview.h5", of_run},
      {"run case.toml -j 1 --quiet -o out", "out/case.toml", of_case},
      {"run case.toml -j 1 --quiet -o out", "out/run.h5", of_case},
      {"run case.toml -j 1 --quiet -o out", "out/report.html", of_case},
      {"run case.toml -j 1 --quiet -o out", "out/checkpoint-000001.h5", of_case},
      {"run case.toml -j 1 --quiet -o out", "out/parts/0000.h5", of_case},
      {"run case.toml -j 1 --quiet -o out", "out/.lock", of_case},
  };
  if (voussoir::solver::has_linear_programmes())
    all.push_back({"limit case.toml -j 1 --associated --mechanism out.csv", "out.csv", of_case});
  return all;
}

class Place {
 public:
  Place() {
    folder.write("part.toml", kPart);
    folder.write("case.toml", kCase);
    folder.write("a.csv", kRecord);
    folder.write("rec/b.csv", kRecord);
    folder.write("rec/record.toml", "L = \"b.csv\"\n");
    REQUIRE(said("run case.toml -j 1 --quiet -o done").code == 0);
  }
  [[nodiscard]] Outcome said(const std::string& words) const { return shell::voussoir(words, "cd " + quoted(folder.path()) + " && "); }
  [[nodiscard]] std::string path(const std::string& name) const { return folder.path(name); }
  /// Makes way for what is to be tried.
  void clear(const std::string& output) const {
    fs::remove_all(path("out"));
    fs::remove_all(path(output));
    fs::create_directories(fs::path(path(output)).parent_path());
  }

  TempFolder folder;
};

mode_t kind_of(const std::string& path) {
  struct stat is {};
  return ::lstat(path.c_str(), &is) == 0 ? is.st_mode & S_IFMT : 0;
}

/// The command refuses the output by name, and leaves what is there.
void refuses(const Place& place, const Row& row, const std::string& why, bool flag = true) {
  const std::string output = place.path(row.output);
  const mode_t kind = kind_of(output);
  const std::string text = kind == S_IFREG ? text_of(output) : "";
  const bool man = row.words.starts_with("man ");  // has no such option
  const Outcome o = place.said(row.words + (flag && !man ? " --overwrite" : ""));
  CAPTURE(row.words);
  CAPTURE(row.output);
  CAPTURE(o.text);
  CHECK(o.code == 3);
  CHECK(o.text.find(row.output) != std::string::npos);
  CHECK(o.text.find(why) != std::string::npos);
  CHECK(kind_of(output) == kind);
  if (kind == S_IFREG) CHECK(text_of(output) == text);
}

}  // namespace

TEST_CASE("outputs: no command replaces a pipe, a link or a folder") {
  const Place place;
  std::vector<Row> all = rows();
  all.push_back({"man out", "out/voussoir.1", {}});
  for (const Row& row : all) {
    place.clear(row.output);
    REQUIRE(::mkfifo(place.path(row.output).c_str(), 0600) == 0);
    refuses(place, row, "is a pipe");
    place.clear(row.output);
    fs::create_symlink(place.folder.write("target", "mine\n"), place.path(row.output));
    refuses(place, row, "is a symbolic link");
    CHECK(text_of(place.path("target")) == "mine\n");
    place.clear(row.output);
    fs::create_symlink(place.path("nowhere"), place.path(row.output));
    refuses(place, row, "is a symbolic link");
    CHECK_FALSE(fs::exists(place.path("nowhere")));
    place.clear(row.output);
    fs::create_directories(place.path(row.output));
    refuses(place, row, "is a folder");
    place.clear(row.output);
  }
}

TEST_CASE("outputs: no command replaces one of its inputs, under none of its names") {
  const Place place;
  for (const Row& row : rows()) {
    for (const std::string& input : row.inputs) {
      place.clear(row.output);
      fs::create_hard_link(place.path(input), place.path(row.output));
      const std::string before = text_of(place.path(input));
      const bool own = row.output.ends_with("/case.toml") || row.output.ends_with("/.lock");  // told by what is in it
      refuses(place, row, own ? "is no " : "is an input of this command");
      CHECK(text_of(place.path(input)) == before);
      place.clear(row.output);
    }
    // The input itself. Folders have names of their own.
    const std::size_t at = row.words.rfind(" " + row.output);
    if (at == std::string::npos) continue;
    Row itself = row;
    itself.output = row.inputs.front();
    itself.words.replace(at + 1, row.output.size(), itself.output);
    if (row.output != "out.mp4") refuses(place, itself, "is an input of this command");  // a film is told by its name before
  }
  Row over{"motion rec --write rec", "rec/record.toml", {}};
  refuses(place, over, "is an input of this command");
  over = {"run done/case.toml -j 1 --quiet -o done", "done/case.toml", {}};
  refuses(place, over, "is an input of this command");
}

TEST_CASE("outputs: a file of another kind stays, one of the same kind is replaced on request, an empty one too") {
  const Place place;
  for (const Row& row : rows()) {
    if (row.words.starts_with("run ") || row.output.ends_with("png") || row.output.ends_with("mp4")) continue;  // by name; need programs
    place.clear(row.output);
    place.folder.write(row.output, "mine = \"1, 2\"\n");
    refuses(place, row, "is no ");
    refuses(place, row, "is no ", false);
    place.folder.write(row.output, "");
    CHECK(place.said(row.words).text.find("exists; --overwrite replaces it") != std::string::npos);
    CHECK(place.said(row.words + " --overwrite").code == 0);
    CHECK(fs::file_size(place.path(row.output)) > 0);
    CHECK(place.said(row.words).code == 3);
    CHECK(place.said(row.words + " --overwrite").code == 0);
    place.clear(row.output);
  }
}

TEST_CASE("outputs: what is no table is told from one") {
  using voussoir::io::FileKind;
  using voussoir::io::is_of_kind;
  for (const char* table : {"", "# made\nt [s],x [m]\n0,1\n", "t,x\n", "a,\"b, c\"\n1,2\n", "1,2\n3,4", "t,x\n0,1\n0.1,"})
    CHECK_MESSAGE(is_of_kind(FileKind::table, table), table);
  for (const char* other : {"#!/bin/sh\necho 1, 2\n", "Dear Sir, I write\nto tell you, briefly, and in short\n", "One line, a sentence.",
                            "a = 1, 2", "<a, b>", "{ \"a\": 1, \"b\": 2 }"})
    CHECK_MESSAGE(!is_of_kind(FileKind::table, other), other);
}

TEST_CASE("outputs: two options do not name one file, standard output is no file, and a run follows no links in its folder") {
  const Place place;
  const auto refused = [&](const std::string& words, const std::string& why) {
    const Outcome o = place.said(words);
    CAPTURE(words);
    CAPTURE(o.text);
    CHECK(o.code == 3);
    CHECK(o.text.find(why) != std::string::npos);
  };
  refused("bench case.toml -j 1 --csv t.csv --stages-csv ./t.csv", "is named twice: by --csv and by --stages-csv");
  CHECK_FALSE(fs::exists(place.path("t.csv")));
  refused("assess done --maps maps --time 0.01 --spectra maps/front-wall-0.010s.svg", "no folder");
  fs::create_directory(place.path("maps"));
  refused("assess done --maps maps --time 0.01 --spectra maps/front-wall-0.010s.svg", "is named twice");
  refused("check case.toml -j 1 --draw /dev/stdout --overwrite", "is a symbolic link");
  refused("check case.toml -j 1 --draw /dev/null --overwrite", "is a device");
  refused("motion a.csv --target a.csv --spectra a.csv --overwrite", "is an input");

  fs::create_directories(place.path("elsewhere"));
  place.folder.write("elsewhere/0000.h5", "mine");
  fs::create_directories(place.path("linked"));
  fs::create_directory_symlink(place.path("elsewhere"), place.path("linked/parts"));
  refused("run case.toml -j 1 --quiet -o linked --overwrite", "linked/parts: is a symbolic link");
  fs::remove(place.path("done/parts"));
  fs::create_directory_symlink(place.path("elsewhere"), place.path("done/parts"));
  refused("resume done --until 0.02 -j 1 --quiet", "done/parts: is a symbolic link");
  CHECK(text_of(place.path("elsewhere/0000.h5")) == "mine");
  fs::remove(place.path("done/parts"));
  // What a resume replaces.
  fs::rename(place.path("done/run.h5"), place.path("kept.h5"));
  fs::create_symlink(place.path("kept.h5"), place.path("done/run.h5"));
  refused("resume done --until 0.02 -j 1 --quiet", "run.h5: is a symbolic link");
}
