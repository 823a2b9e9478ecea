// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/files/run_folder.h"

#include <sys/stat.h>
#include <sys/wait.h>

#include <chrono>
#include <fstream>
#include <sstream>

#include "io/input/files/errors.h"
#include "io/input/files/whole_file.h"
#include "tests/io/results_fixture.h"

namespace voussoir::io {
namespace {

using namespace test;
namespace fs = std::filesystem;

void touch(const std::string& path, const std::string& text = "x") {
  fs::create_directories(fs::path(path).parent_path());
  std::ofstream(path) << text;
}

/// A file as a run leaves it: its first bytes.
void leave(const std::string& path) {
  const auto is = [&](const char* ending) { return path.find(ending) != std::string::npos; };
  touch(path, is("case.toml")    ? std::string(kResolvedHead) + "\n"
              : is(".html")      ? "<!DOCTYPE html>"
              : is(".xdmf")      ? "<Xdmf>"
              : is(".png")       ? "\x89PNG"
              : is("checkpoint") ? "voussoir checkpoint 8\n"
                                 : "\x89HDF\r\n");
}

std::string text_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// Exit code of `work` in a child.
template <class Work>
int in_child(Work work) {
  const pid_t child = ::fork();
  if (child == 0) {
    int code = 99;
    try {
      code = work();
    } catch (...) {
    }
    ::_exit(code);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

TEST_CASE("a new folder is made with those above it, and holds the case") {
  const TempFolder dir;
  const RunFolder folder = RunFolder::create(dir.file("a/b/"), false);
  CHECK(folder.path() == dir.file("a/b"));
  folder.write_case("title = 1\n");
  CHECK(text_of(folder.file("case.toml")) == "title = 1\n");
  folder.write_case("title = 2\n");
  CHECK(text_of(folder.file("case.toml")) == "title = 2\n");
  CHECK(files_in(folder.path()) == std::set<std::string>{".lock", "case.toml"});
}

TEST_CASE("results of another run are refused, or on request removed and nothing else") {
  for (const char* own :
       {"run.h5", "parts/0003.h5", "checkpoint-12.h5", "case.toml", "report.html", "comparison.html", "run.xdmf", "paraview.h5"}) {
    CAPTURE(own);
    const TempFolder dir;
    leave(dir.file(own));
    CHECK_THROWS_WITH_AS(RunFolder::create(dir.path(), false), doctest::Contains("--overwrite"), FileError);
    CHECK(fs::exists(dir.file(own)));
  }
  const TempFolder dir;
  const std::set<std::string> foreign{"notes.txt", "parts/plan.h5",   "run.h5.bak",         "house.toml",          "checkpoint-x.txt",
                                      "log",       "stills/plan.png", "stills/front-s.png", "report.html.old.tmp", "plan.1.tmp"};
  for (const std::string& name : foreign) touch(dir.file(name));
  for (const char* own : {"run.h5", "run.h5.tmp", "parts/0003.h5", "parts/0004.h5.tmp", "checkpoint-12.h5", "case.toml",
                          "stills/front-2.5s.png", "stills/front-2.5s.png.77.tmp", "report.html", "report.html.1234.tmp", "comparison.html",
                          "run.xdmf", "paraview.h5", "paraview.h5.1234.tmp", "case.toml.9.tmp"})
    leave(dir.file(own));
  const RunFolder folder = RunFolder::create(dir.path(), true);
  std::set<std::string> left = foreign;
  left.insert(".lock");
  CHECK(files_in(dir.path()) == left);
}

TEST_CASE("a file with the name of a result that no run wrote is kept, with --overwrite too") {
  for (const char* name : {"run.h5", "report.html", "comparison.html", "run.xdmf", "paraview.h5", "checkpoint-000007.h5",
                           "checkpoint-999999.h5.tmp", "parts/0000.h5", "stills/photo-2.5s.png"}) {
    CAPTURE(name);
    const TempFolder dir;
    leave(dir.file("run.h5"));
    touch(dir.file(name), "mine");
    CHECK_THROWS_WITH_AS(RunFolder::create(dir.path(), false), doctest::Contains("holds the results of another run"), FileError);
    CHECK_THROWS_WITH_AS(RunFolder::create(dir.path(), true), doctest::Contains("so no run wrote it"), FileError);
    CHECK_THROWS_WITH_AS(RunFolder::open(dir.path()), doctest::Contains("so no run wrote it"), FileError);
    CHECK(text_of(dir.file(name)) == "mine");
    touch(dir.file(name), std::string(8, '\0'));  // as of a run that was killed while it wrote its first bytes
    CHECK_NOTHROW(RunFolder::create(dir.path(), true));
  }
}

TEST_CASE("results do not mix with files of something else unless told to, and never replace a case of the user's") {
  const TempFolder dir;
  touch(dir.file(".gitignore"));
  touch(dir.file(".lock"), "12\n");
  fs::create_directory(dir.file("parts"));  // as a run that has merged its parts may leave it
  CHECK_NOTHROW(RunFolder::create(dir.path(), false));
  for (const char* foreign : {"notes.txt", "photos/wall.jpg", "parts/plan.h5", "stills/plan.png"}) {
    CAPTURE(foreign);
    const TempFolder other;
    touch(other.file(foreign));
    CHECK_THROWS_WITH_AS(RunFolder::create(other.path(), false), doctest::Contains("holds what is of no run"), FileError);
    CHECK(files_in(other.path()) == std::set<std::string>{foreign});  // nor a lock
    CHECK_NOTHROW(RunFolder::create(other.path(), true));
    CHECK(fs::exists(other.file(foreign)));
  }
  touch(dir.file("a"));
  touch(dir.file("b"));
  CHECK_THROWS_WITH_AS(RunFolder::create(dir.path(), false), doctest::Contains("(a and 1 more)"), FileError);
  touch(dir.file("case.toml"), "title = \"mine\"\n");
  for (const bool overwrite : {false, true})
    CHECK_THROWS_WITH_AS(RunFolder::create(dir.path(), overwrite), doctest::Contains("no case that a run wrote"), FileError);
  CHECK(text_of(dir.file("case.toml")) == "title = \"mine\"\n");
}

TEST_CASE("two processes cannot have one folder") {
  const TempFolder dir;
  {
    const RunFolder folder = RunFolder::create(dir.path(), false);
    const std::string pid = std::to_string(::getpid());
    const auto refused = [&](bool open) {
      return in_child([&] {
        try {
          open ? RunFolder::open(dir.path()) : RunFolder::create(dir.path(), true);
        } catch (const FileError& e) {
          return std::string(e.what()).find("process " + pid) != std::string::npos ? 0 : 2;
        }
        return 1;
      });
    };
    CHECK(refused(false) == 0);
    CHECK(refused(true) == 0);
  }
  CHECK_NOTHROW(RunFolder::open(dir.path()));
  // A process that died holds nothing.
  CHECK(in_child([&]() -> int {
          const RunFolder folder = RunFolder::create(dir.path(), false);
          ::kill(::getpid(), SIGKILL);
          return 0;
        }) == -1);
  CHECK_NOTHROW(RunFolder::create(dir.path(), false));
}

TEST_CASE("places where nothing can be written") {
  const TempFolder dir;
  touch(dir.file("file"));
  CHECK_THROWS_WITH_AS(RunFolder::create(dir.file("file"), true), doctest::Contains("is a file"), FileError);
  CHECK_THROWS_AS(RunFolder::create(dir.file("file/below"), true), FileError);
  CHECK_THROWS_AS(RunFolder::create("", true), FileError);
  CHECK_THROWS_AS(RunFolder::open(dir.file("none")), FileError);
  fs::create_directory(dir.file("locked"));
  ::chmod(dir.file("locked").c_str(), 0555);
  ::chmod(dir.path().c_str(), 0755);
  const int code = in_child([&] {
    // The superuser may write anywhere, so become somebody else.
    if (::geteuid() == 0 && ::setuid(65534) != 0) return 3;
    try {
      RunFolder::create(dir.file("locked"), false);
    } catch (const FileError& e) {
      return std::string(e.what()).find("Permission denied") != std::string::npos ? 0 : 2;
    }
    return 1;
  });
  CHECK(code == 0);
}

TEST_CASE("a text that cannot be written leaves the old one") {
  const TempFolder dir;
  fs::create_directory(own_temporary(dir.file("t")));  // in the way of the temporary file
  touch(dir.file("t"));
  CHECK_THROWS_AS(write_text_file(dir.file("t"), "new"), FileError);
  CHECK(text_of(dir.file("t")) == "x");
}

TEST_CASE("two processes that write a file at once leave it whole") {
  const TempFolder dir;
  CHECK(in_child([&] {
          const pid_t other = ::fork();
          for (int i = 0; i < 100; ++i) write_text_file(dir.file("t"), std::string(200000, other == 0 ? 'b' : 'a'));
          int status = 0;
          if (other != 0) ::waitpid(other, &status, 0);
          return WEXITSTATUS(status);
        }) == 0);
  const std::string text = text_of(dir.file("t"));
  CHECK(text == std::string(200000, text.at(0)));
  CHECK(files_in(dir.path()) == std::set<std::string>{"t"});
}

TEST_CASE("what a killed process left of a file goes when the file is written an hour later") {
  const TempFolder dir;
  for (const char* name : {"t.1.tmp", "t.2.tmp", "t.x.tmp", "tt.1.tmp", "t..tmp"}) {
    touch(dir.file(name));
    if (std::string(name) != "t.2.tmp") fs::last_write_time(dir.file(name), fs::file_time_type::clock::now() - std::chrono::hours(2));
  }
  write_text_file(dir.file("t"), "new");
  CHECK(files_in(dir.path()) == std::set<std::string>{"t", "t.2.tmp", "t.x.tmp", "tt.1.tmp", "t..tmp"});
}

}  // namespace voussoir::io
