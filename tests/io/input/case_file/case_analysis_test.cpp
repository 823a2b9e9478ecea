// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "io/input/case_file/case_file.h"

// Table [analysis]: what is read, what goes together, what is refused.

using namespace voussoir;
using io::read_case;

namespace {

cases::Case read(const std::string& text) { return read_case({"test.toml", text}).value; }

std::string refusal(const std::string& text) {
  try {
    read(text);
  } catch (const io::CaseFileError& e) {
    return e.what();
  }
  return "accepted";
}

std::string analysis(const std::string& keys) { return "[analysis]\n" + keys; }

const std::string kPushed =
    "[materials.m]\ndensity = 1.0\nyoung = 1.0\npoisson = 0.0\n[[block]]\nname = \"a\"\nmaterial = \"m\"\n"
    "box = [[0, 0, 0], [1, 1, 1]]\n[[load]]\nblock = \"a\"\nforce = [1.0, 0.0, 0.0]\ngrows = true\n";

}  // namespace

TEST_CASE("analysis: a case without the table is a time history, and its end is time.duration") {
  const cases::Case c = read("[time]\nduration = 3.0\n");
  CHECK(c.analysis.kind == cases::AnalysisKind::time_history);
  CHECK_FALSE(is_assessment(c.analysis));
  CHECK(c.end() == 3.0);
}

TEST_CASE("analysis: every key of a pushover is read and written") {
  const cases::Case c =
      read(analysis("kind = \"pushover\"\npattern = \"mode\"\ndirection = [0.0, -2.0]\ncontrol = [1.0, 2.0, 3.0]\ndrop = 0.3\n"
                    "share = 0.25\npace = 4.0\ndamping = 2.5\nlongest = 50.0\nlargest_factor = 2.0\nlargest_drift = 0.1\n"));
  const cases::Analysis& a = c.analysis;
  CHECK(a.kind == cases::AnalysisKind::pushover);
  CHECK(a.pattern == cases::LoadPattern::mode);
  CHECK(a.direction == std::array{0.0, -2.0});
  CHECK(a.control == Vec3{1.0, 2.0, 3.0});
  CHECK(a.drop == 0.3);
  CHECK(a.share == 0.25);
  CHECK(a.pace == 4.0);
  CHECK(a.damping == 2.5);
  CHECK(a.largest_factor == 2.0);
  CHECK(a.largest_drift == 0.1);
  CHECK(c.end() == 50.0);
  const std::string resolved = io::resolved_toml(c);
  CHECK(io::resolved_toml(read(resolved)) == resolved);
}

TEST_CASE("analysis: the control point is a point or a name, each as the other was not given") {
  const cases::Case c = read(analysis("kind = \"pushover\"\ncontrol = \"front wall, storey 2\"\n"));
  CHECK(c.analysis.control_name == "front wall, storey 2");
  CHECK_FALSE(c.analysis.control);
  const std::string resolved = io::resolved_toml(c);
  CHECK(resolved.find("control = \"front wall, storey 2\"") != std::string::npos);
  CHECK(io::resolved_toml(read(resolved)) == resolved);
  const cases::Case point =
      io::read_case({"test.toml", analysis("kind = \"pushover\"\ncontrol = \"top\"\n")}, {"analysis.control=[1.0, 2.0, 3.0]"}).value;
  CHECK(point.analysis.control == Vec3{1.0, 2.0, 3.0});
  CHECK(point.analysis.control_name.empty());
}

TEST_CASE("analysis: a triangular push with eccentricity and a demand is read and written, and what does not go with it is refused") {
  const cases::Case c =
      read(analysis("kind = \"pushover\"\npattern = \"triangular\"\neccentricity = -0.05\ndemand = \"ec8:2:c:1.5\"\n"
                    "demand_damping = 0.04\n"));
  CHECK(c.analysis.pattern == cases::LoadPattern::triangular);
  CHECK(c.analysis.eccentricity == -0.05);
  CHECK(c.analysis.demand == "ec8:2:c:1.5");
  CHECK(c.analysis.demand_damping == 0.04);
  CHECK(has_push_shape(c.analysis));
  const std::string resolved = io::resolved_toml(c);
  CHECK(io::resolved_toml(read(resolved)) == resolved);
  CHECK_FALSE(has_push_shape(read(analysis("kind = \"pushover\"\n")).analysis));
  CHECK_FALSE(has_push_shape(read(analysis("kind = \"tilt\"\n")).analysis));
  const auto says = [](const std::string& keys, const std::string& words) {
    const std::string got = refusal(analysis(keys));
    CHECK_MESSAGE(got.find(words) != std::string::npos, got);
  };
  says("kind = \"tilt\"\neccentricity = 0.05\n", "goes only with kind = \"pushover\" and a pattern other than \"given\"");
  says("kind = \"pushover\"\npattern = \"given\"\neccentricity = 0.05\n", "goes only with kind = \"pushover\" and a pattern other than");
  says("kind = \"pushover\"\neccentricity = 5.0\n", "eccentricity");
  says("kind = \"tilt\"\ndemand = \"ec8:1:A:0.1g\"\n", "demand = \"ec8:1:A:0.1g\": goes only with kind = \"pushover\"");
  says("kind = \"pushover\"\ndemand = \"spectrum.csv\"\n", "wanted four parts; allowed: ec8:TYPE:GROUND:AG");
  says("kind = \"pushover\"\ndemand = \"ec8:1:F:0.1g\"\n", "no ground 'F'");
  says("kind = \"pushover\"\ndemand_damping = 0.1\n", "goes only with demand");
}

TEST_CASE("analysis: every key of a cyclic test is read and written") {
  const cases::Case c =
      read(kPushed + "follows = true\n" + analysis("kind = \"cyclic\"\namplitudes = [0.001, 0.002]\ncycles = 3\nlevel = true\n"));
  CHECK(c.analysis.amplitudes == std::vector{0.001, 0.002});
  CHECK(c.analysis.cycles == 3);
  CHECK(c.analysis.level);
  CHECK(c.loads.at(0).grows);
  CHECK(c.loads.at(0).follows);
  const std::string resolved = io::resolved_toml(c);
  CHECK(io::resolved_toml(read(resolved)) == resolved);
}

TEST_CASE("analysis: what does not go together is refused, with line, key and what would go") {
  CHECK(
      refusal(analysis("kind = \"push\"")) ==
      "test.toml:2: analysis.kind = \"push\": must be \"time-history\" | \"pushover\" | \"tilt\" | \"settlement\" | \"cyclic\" | \"rest\"");
  CHECK(refusal(analysis("pace = 2.0")).starts_with("test.toml:2: analysis.pace = 2 s: goes only with a kind other than \"time-history\""));
  CHECK(refusal(analysis("kind = \"tilt\"\npattern = \"mode\""))
            .starts_with("test.toml:3: analysis.pattern = \"mode\": goes only with kind = \"pushover\""));
  const std::string at_rest = "kind = \"tilt\"\nsolver = \"equilibrium\"\n", moved = "kind = \"tilt\"\nsolver = \"dynamics\"\n";
  CHECK(refusal(analysis(at_rest + "tolerance = 1e-3\npath_step = 0.01")) == "accepted");
  CHECK(refusal(analysis("solver = \"equilibrium\"")).find("goes only with a kind other than \"time-history\"") != std::string::npos);
  CHECK(refusal(analysis(moved + "tolerance = 1e-3")).find("goes only with solver = \"equilibrium\"") != std::string::npos);
  CHECK(refusal(analysis("kind = \"tilt\"\npace = 2.0\npath_step = 0.1")).find("goes only with solver = \"equilibrium\"") !=
        std::string::npos);
  CHECK(refusal(analysis("kind = \"tilt\"\ntolerance = 1e-3")) == "accepted");  // states of rest unless told otherwise
  CHECK(refusal(analysis("kind = \"tilt\"\npace = 2.0")) == "accepted");        // which a pace does
  CHECK(refusal(analysis("solver = \"dynamics\"")) == "accepted");              // as cases of older runs have it
  CHECK(refusal(analysis(at_rest + "pace = 2.0")).find("goes only with solver = \"dynamics\"") != std::string::npos);
  CHECK(refusal(analysis(at_rest + "damping = 2.0")).find("goes only with solver = \"dynamics\"") != std::string::npos);
  CHECK(refusal(kPushed.substr(0, kPushed.find("grows")) + "ramp = [0.0, 1.0]\n" + analysis(at_rest)).find("which has no time") !=
        std::string::npos);
  CHECK(refusal(analysis("kind = \"tilt\"\ndrop = 1.0")).starts_with("test.toml:3: analysis.drop = 1: must be in (0, 1)"));
  CHECK(refusal(analysis("kind = \"tilt\"\ndirection = [0, 0]")).find("analysis.direction") != std::string::npos);
  CHECK(refusal(analysis("kind = \"tilt\"\ndirection = [0, 0]")).find("has no direction") != std::string::npos);
  CHECK(refusal(analysis("kind = \"tilt\"\n[gravity]\nacceleration = [0, 0, 0]")).find("needs gravity") != std::string::npos);
  CHECK(refusal(kPushed + analysis("kind = \"cyclic\"")).find("analysis.amplitudes is missing") != std::string::npos);
  CHECK(refusal(kPushed + analysis("kind = \"cyclic\"\namplitudes = [0.001, 0.0]")).find("must all be > 0 (m)") != std::string::npos);
  CHECK(refusal(analysis("kind = \"cyclic\"\namplitudes = [0.001]")).find("needs a [[load]] with grows = true") != std::string::npos);
  CHECK(refusal(analysis("kind = \"settlement\"")).find("needs a motion of a fixed block, of fixed stones or of a [[base.part]]") !=
        std::string::npos);
  CHECK(refusal("[[base.part]]\nwall = \"rear\"\nlevel = 0.2\nmotion = { velocity = [0, 0, -0.1] }\n" +
                analysis("kind = \"settlement\"")) == "accepted");
  CHECK(refusal(kPushed + analysis("kind = \"pushover\"\npattern = \"given\"\nlevel = true")) == "accepted");
  CHECK(refusal(analysis("kind = \"pushover\"\nlevel = true"))
            .find("goes only with kind = \"cyclic\", or \"pushover\" and pattern = \"given\"") != std::string::npos);
  CHECK(refusal(kPushed).find("load[0].grows") != std::string::npos);
  CHECK(refusal(kPushed + analysis("kind = \"tilt\"")).find("has no use for a [[load]] with grows = true") != std::string::npos);
  CHECK(refusal(kPushed + "ramp = [0.0, 1.0]\n" + analysis("kind = \"cyclic\"\namplitudes = [0.001]")).find("load[0].ramp") !=
        std::string::npos);
}
