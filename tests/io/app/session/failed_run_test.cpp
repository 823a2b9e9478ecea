// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <utility>

#include "io/app/session/exit_code.h"
#include "io/app/session/session.h"
#include "io/input/case_file/case_file.h"
#include "io/input/files/hdf5_file.h"
#include "solver/analysis/drive.h"
#include "tests/io/temp_folder.h"

// A run whose numbers go wrong, in a folder that takes no more files.

using namespace voussoir;
namespace fs = std::filesystem;

namespace {

/// Standard error goes to a file for as long as this lives.
class CaughtErrors {
 public:
  explicit CaughtErrors(std::string path) : path_(std::move(path)), before_(::dup(2)) {
    std::fflush(stderr);
    const int file = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    ::dup2(file, 2);
    ::close(file);
  }
  CaughtErrors(const CaughtErrors&) = delete;
  CaughtErrors& operator=(const CaughtErrors&) = delete;
  ~CaughtErrors() {
    std::fflush(stderr);
    ::dup2(before_, 2);
    ::close(before_);
  }
  [[nodiscard]] std::string text() const {
    std::fflush(stderr);
    std::ifstream file(path_);
    return {std::istreambuf_iterator<char>(file), {}};
  }

 private:
  std::string path_;
  int before_;
};

/// Two bricks, one thrown onto the other with a step far too long.
cases::Case blown_up() {
  cases::Case c;
  c.materials["stone"] = {2000.0, 1e8, 0.2};
  c.joints.default_law = "dry";
  c.gravity.settle = false;
  c.time.step = 0.01;
  c.time.duration = 20.0;
  c.base = cases::Base{};
  for (int i = 0; i < 2; ++i) {
    cases::BlockSpec b;
    b.name = "b" + std::to_string(i);
    b.material = "stone";
    b.box = {{Vec3{0.0, 0.0, 0.2 * i}, Vec3{0.2, 0.2, 0.2 * (i + 1)}}};
    c.blocks.push_back(b);
  }
  c.blocks[1].velocity = {1.0, 0.0, -3.0};
  return c;
}

/// Two stones on each other, pushed with a step far too long.
constexpr const char* kPushed = R"(
[materials.stone]
density = 2000.0
young = 1.0e8
poisson = 0.2
[gravity]
settle = false
[time]
step = 4.0e-3
[base]
[analysis]
kind   = "pushover"
solver = "dynamics"
[output]
ledger_interval = 4.0e-3
[[block]]
name = "lower"
material = "stone"
box = [[0.0, 0.0, 0.0], [0.2, 0.2, 0.2]]
[[block]]
name = "upper"
material = "stone"
box = [[0.0, 0.0, 0.2], [0.2, 0.2, 0.4]]
)";

}  // namespace

TEST_CASE("a run that is lost keeps its measures, and its capacity curve up to there") {
  const TempFolder folder;
  const std::string run = folder.path("run");
  fs::create_directories(run);
  const cases::Case c = io::read_case({"case.toml", kPushed}).value;
  const cases::Model model = cases::build_model(c);
  auto sim = std::make_unique<solver::Simulation>(c, model, cases::GroundMotion{}, solver::Options{});
  solver::choose_drive(*sim, c);
  io::ResultsWriter results(run, model, kPushed, io::history_names(c), io::provenance(1));
  io::Checkpoints checkpoints(run, io::facts_of(*sim, kPushed, {}, false), {});
  solver::RunState plan;
  const CaughtErrors errors(folder.path("errors"));
  CHECK(io::run_session(c, std::move(sim), plan, results, checkpoints, run, true) == io::kNumericalFailure);
  CAPTURE(errors.text());
  const io::Hdf5File file = io::Hdf5File::open(run + "/run.h5");
  CHECK(file.attribute_int("/summary", "finished") == 0);
  CHECK(file.has_attribute("/summary", "end_time"));
  REQUIRE(file.has_attribute("/summary", "failure"));
  const std::string why = file.attribute_text("/summary", "failure");
  CHECK(why.starts_with("the energy ledger is off by "));
  CHECK(errors.text().find("numerical failure: " + why) != std::string::npos);
  CHECK(file.exists("/capacity"));
  REQUIRE(results.capacity());
  const std::size_t rows = file.read<double>("/assessment/time").size();
  CHECK(rows > 1);
  CHECK(results.capacity()->curve.time.size() == rows - 1);  // without the row in which the balance broke
}

TEST_CASE("a numerical failure is told and keeps its exit code though neither rows nor state can be written") {
  const TempFolder folder;
  const std::string run = folder.path("run");
  fs::create_directories(run);
  const cases::Case c = blown_up();
  const cases::Model model = cases::build_model(c);
  auto sim = std::make_unique<solver::Simulation>(c, model, cases::GroundMotion{}, solver::Options{});
  io::ResultsWriter results(run, model, "", io::history_names(c), io::provenance(1));
  io::Checkpoints checkpoints(run, io::facts_of(*sim, "", {}, false), {});
  solver::RunState plan;
  // Folders that are not empty stand where the files would go.
  fs::create_directories(run + "/parts/0000.h5/in the way");
  fs::create_directories(run + "/checkpoint-failed.h5/in the way");
  const CaughtErrors errors(folder.path("errors"));
  CHECK(io::run_session(c, std::move(sim), plan, results, checkpoints, run, true) == io::kNumericalFailure);
  const std::string text = errors.text();
  const std::size_t failure = text.find("numerical failure"), rows = text.find("the last rows are not in the results"),
                    state = text.find("the state is not saved");
  CAPTURE(text);
  CHECK(failure < rows);
  CHECK(rows < state);
  CHECK(state != std::string::npos);
  CHECK(text.find("the state is in") == std::string::npos);
}
