// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <filesystem>
#include <regex>
#include <string>

#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

// What `cmake --install` installs works from anywhere, by itself.
namespace {

namespace fs = std::filesystem;

constexpr const char* kCase = R"(title = "two dry blocks"
[gravity]
settle = false
[time]
duration = 0.05
[materials.stone]
density = 2000.0
young = 1e8
poisson = 0.2
[joints]
default = "dry"
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

/// Installed once for all tests here.
struct Installed {
  TempFolder folder;
  std::string prefix = folder.path("a prefix");
  shell::Outcome done = shell::run(shell::quoted(VOUSSOIR_CMAKE) + " --install " + shell::quoted(VOUSSOIR_BUILD_DIR) + " --prefix " +
                                   shell::quoted(prefix) + " 2>&1");
};
const Installed& installed() {
  static const Installed i;
  return i;
}

/// A command in an empty folder, which finds the installed program and nothing of this build.
shell::Outcome there(const TempFolder& folder, const std::string& command) {
  return shell::run("cd " + shell::quoted(folder.path()) + " && env -i HOME=" + shell::quoted(folder.path()) +
                    " PATH=" + shell::quoted(installed().prefix + "/bin:/usr/bin:/bin") + " OMP_NUM_THREADS=1 bash -c " +
                    shell::quoted(command) + " 2>&1");
}

/// Relative targets of the links of a page.
std::vector<std::string> links_of(const std::string& page) {
  static const std::regex link(R"(\]\(([^)#\s]+)[^)]*\))");
  std::vector<std::string> targets;
  for (std::sregex_iterator it(page.begin(), page.end(), link), end; it != end; ++it)
    if ((*it)[1].str().find("://") == std::string::npos) targets.push_back((*it)[1]);
  return targets;
}

}  // namespace

TEST_CASE("installed: the program runs, reports and knows its cases, from another folder") {
  REQUIRE_MESSAGE(installed().done.code == 0, installed().done.text);
  const TempFolder folder;
  folder.write("two.toml", kCase);
  CHECK(there(folder, "command -v voussoir").text == installed().prefix + "/bin/voussoir\n");
  CHECK(there(folder, "voussoir cases").text.find("\nflat20n ") != std::string::npos);
  CHECK(there(folder, "voussoir check arch").code == 0);
  CHECK(there(folder, "voussoir run two.toml --quiet").code == 0);
  CHECK(there(folder, "voussoir report results/two").code == 0);
  CHECK(shell::text_of(folder.path("results/two/report.html")).find("</html>") != std::string::npos);
  CHECK(there(folder, "voussoir modes two.toml --no-impulse --quiet").code == 0);
}

TEST_CASE("installed: manual pages, completions and the licence") {
  const TempFolder folder;
  const std::string share = installed().prefix + "/share";
  const std::string page = there(folder, "gunzip -c " + shell::quoted(share + "/man/man1/voussoir-run.1.gz")).text;
  CHECK(page.find("\\fB\\-\\-checkpoint\\-every\\fR") != std::string::npos);
  CHECK(there(folder, "source " + shell::quoted(share + "/bash-completion/completions/voussoir") + "; complete -p voussoir").code == 0);
  CHECK(fs::exists(share + "/fish/vendor_completions.d/voussoir.fish"));
  CHECK(shell::text_of(share + "/doc/voussoir/copyright").find("University of Cincinnati") != std::string::npos);
}

TEST_CASE("installed: links of the manual lead to pages, pictures and cases that are installed") {
  const fs::path doc = installed().prefix + "/share/doc/voussoir";
  REQUIRE(fs::exists(doc / "cases/tutorial/hut.toml"));
  int pages = 0;
  for (const auto& entry : fs::recursive_directory_iterator(doc)) {
    if (entry.path().extension() != ".md") continue;
    ++pages;
    for (const std::string& target : links_of(shell::text_of(entry.path().string()))) {
      const std::string kind = fs::path(target).extension().string();
      const bool shown = kind == ".md" || kind == ".png" || kind == ".jpg" || kind == ".svg" || kind == ".toml" || kind == ".csv";
      if (shown) CHECK_MESSAGE(fs::exists(entry.path().parent_path() / target), entry.path().lexically_relative(doc) << " -> " << target);
    }
  }
  CHECK(pages > 30);
}

TEST_CASE("installed: scripts find the installed program and the packages beside them") {
  const TempFolder folder;
  const std::string scripts = installed().prefix + "/share/voussoir/scripts";
  const auto says = there(folder, "cd " + shell::quoted(scripts) +
                                      " && python3 -c 'import sys; sys.path.insert(0, \"python/voussoir\"); import program; "
                                      "print(program.program()); print(program.CHECKOUT)'");
  CHECK(says.text == installed().prefix + "/bin/voussoir\nNone\n");
  if (shell::code_of("/usr/bin/python3 -c 'import h5py, matplotlib, numpy' 2>/dev/null") != 0) {
    MESSAGE("skipped: no python3 with h5py, numpy and matplotlib");
    return;
  }
  folder.write("two.toml", kCase);
  REQUIRE(there(folder, "voussoir run two.toml --quiet").code == 0);
  const std::string package = there(folder, "PYTHONPATH=" + shell::quoted(installed().prefix + "/lib/python3/dist-packages") +
                                                " /usr/bin/python3 -c 'import voussoir; print(voussoir.Run(\"results/two\").finished)'")
                                  .text;
  CHECK(package == "True\n");
  for (const char* script : {"plot_energy.py results/two -o x.png", "plot_damage.py results/two -o x.png", "study/run --help"}) {
    const shell::Outcome o = there(folder, "/usr/bin/python3 " + shell::quoted(scripts) + "/" + script);
    CHECK_MESSAGE(o.code == 0, script << ": " << o.text);
  }
}
