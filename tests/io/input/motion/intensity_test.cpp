// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/motion/spectra/intensity.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <exception>
#include <numbers>
#include <string>

#include "io/input/case_file/case_file.h"
#include "io/input/motion/motion_files.h"
#include "io/input/motion/spectra/figures.h"
#include "io/input/motion/spectra/spectra.h"
#include "io/input/motion/synthetic/bam_like.h"

using namespace voussoir;

namespace {

cases::Case read(const std::string& text) { return io::read_case({"test.toml", text}, {}).value; }

std::string refusal(const std::string& text) {
  try {
    io::load_motion(*read(text).motion, "");
  } catch (const std::exception& e) {
    return e.what();
  }
  return "accepted";
}

const std::string kRecord = "[motion]\nrecord = \"bam-like\"\n";

double peak(const cases::Accelerogram& a) { return io::figures(a).peak_acceleration; }

}  // namespace

TEST_CASE("motion intensity: each measure is reached, by one factor for all components or one for each") {
  const cases::GroundMotion as_recorded = io::load_motion(*read(kRecord).motion, "");
  CHECK(as_recorded.factor == std::array{1.0, 1.0, 1.0});
  for (const std::string measure : {"measure = \"PGA\"", "measure = \"PGV\"", "measure = \"Sa\"\nperiod = 0.3"}) {
    for (const std::string of : {"each", "geometric mean", "RotD50", "larger"}) {
      CAPTURE(measure);
      CAPTURE(of);
      const cases::Case c = read(kRecord + "[motion.intensity]\nlevel = 2.5\ncomponents = \"" + of + "\"\n" + measure);
      const cases::GroundMotion motion = io::load_motion(*c.motion, "");
      CHECK(io::intensity(*c.motion->intensity, motion.axis[0], motion.axis[1]) == doctest::Approx(2.5).epsilon(1e-12));
      if (of == "each") {  // and neither is above it
        CHECK(io::intensity(*c.motion->intensity, motion.axis[0], {}) == doctest::Approx(2.5).epsilon(1e-12));
        CHECK(io::intensity(*c.motion->intensity, {}, motion.axis[1]) == doctest::Approx(2.5).epsilon(1e-12));
        CHECK(motion.factor[0] != motion.factor[1]);
        CHECK(motion.factor[2] == doctest::Approx(std::sqrt(motion.factor[0] * motion.factor[1])).epsilon(1e-12));
      } else {
        CHECK(motion.factor == std::array{motion.factor[0], motion.factor[0], motion.factor[0]});
      }
      for (std::size_t i = 0; i < 3; ++i) {
        REQUIRE(motion.axis[i].acceleration.size() == as_recorded.axis[i].acceleration.size());
        for (const std::size_t n : {100U, 700U, 1500U})
          CHECK(motion.axis[i].acceleration[n] == as_recorded.axis[i].acceleration[n] * motion.factor[i]);
      }
    }
  }
  CHECK(read(kRecord + "[motion.intensity]\nlevel = 2.5\nmeasure = \"PGA\"").motion->intensity->components == cases::IntensityOf::each);
}

TEST_CASE("motion intensity: RotD50 of two equal components against its closed form, and turned by 90 degrees") {
  // Two equal components make a motion along 45 degrees: its peak along an angle is sqrt(2) A |cos(angle - 45)|, of which the median over
  // all angles is sqrt(2) A cos(45) = A.
  cases::Accelerogram a{"sine", 0.01, {}};
  for (int i = 0; i <= 400; ++i) a.acceleration.push_back(1.5 * std::sin(0.05 * i));
  const cases::MotionIntensity of{cases::IntensityMeasure::pga, 1.0, {}, cases::IntensityOf::rotd50};
  CHECK(io::intensity(of, a, a) == doctest::Approx(1.5).epsilon(0.02));
  const std::array<cases::Accelerogram, 3> ltv = io::bam_like_1();
  cases::Accelerogram back = ltv[0];
  for (double& v : back.acceleration) v = -v;
  for (const cases::IntensityMeasure m : {cases::IntensityMeasure::pga, cases::IntensityMeasure::pgv, cases::IntensityMeasure::sa}) {
    const cases::MotionIntensity both{m, 1.0, 0.3, cases::IntensityOf::rotd50};
    CHECK(io::intensity(both, ltv[1], back) == doctest::Approx(io::intensity(both, ltv[0], ltv[1])).epsilon(1e-12));
  }
  const double w = 2.0 * std::numbers::pi / 0.3;  // of spectra the same as voussoir motion --combine has
  CHECK(io::intensity({cases::IntensityMeasure::sa, 1.0, 0.3, cases::IntensityOf::rotd50}, ltv[0], ltv[1]) ==
        doctest::Approx(w * w * io::combined_displacement(ltv[0], ltv[1], 1.0 / 0.3, io::kIntensityDamping).rotd50).epsilon(1e-12));
  cases::Accelerogram other = a;
  other.dt = 0.02;
  CHECK_THROWS_WITH(io::intensity(of, a, other), doctest::Contains("needs horizontal components of one time step, not 0.01 and 0.02 s"));
}

TEST_CASE("motion intensity: measures of a sine against their closed forms") {
  // a = A sin(w t), over whole periods: PGA = A; PGV = 2 A / w; Sa at a period far shorter than the sine's nears PGA.
  const double amplitude = 1.5, w = 2.0 * std::numbers::pi * 0.5;
  cases::Accelerogram a{"sine", 0.001, {}};
  for (int i = 0; i <= 8000; ++i) a.acceleration.push_back(amplitude * std::sin(w * 0.001 * i));
  cases::Accelerogram b = a;
  for (double& v : b.acceleration) v *= 4.0;
  using cases::IntensityMeasure;
  CHECK(io::intensity({IntensityMeasure::pga, 1.0, {}}, a, a) == doctest::Approx(amplitude).epsilon(1e-6));
  CHECK(io::intensity({IntensityMeasure::pgv, 1.0, {}}, a, a) == doctest::Approx(2.0 * amplitude / w).epsilon(1e-5));
  CHECK(io::intensity({IntensityMeasure::sa, 1.0, 0.02}, a, a) == doctest::Approx(amplitude).epsilon(0.01));
  SUBCASE("the geometric mean of two") {
    const cases::MotionIntensity mean{IntensityMeasure::pga, 6.0, {}, cases::IntensityOf::geometric_mean};
    CHECK(io::intensity(mean, a, b) == doctest::Approx(2.0 * amplitude).epsilon(1e-6));
    CHECK(io::factors_to_reach(mean, a, b)[0] == doctest::Approx(2.0).epsilon(1e-6));
  }
  SUBCASE("the larger of two, and the smaller one of each") {
    CHECK(io::intensity({IntensityMeasure::pga, 6.0, {}, cases::IntensityOf::larger}, a, b) ==
          doctest::Approx(4.0 * amplitude).epsilon(1e-6));
    CHECK(io::intensity({IntensityMeasure::pga, 6.0, {}, cases::IntensityOf::each}, a, b) == doctest::Approx(amplitude).epsilon(1e-6));
    const std::array<double, 3> factors = io::factors_to_reach({IntensityMeasure::pga, 6.0, {}, cases::IntensityOf::each}, a, b);
    CHECK(factors[0] == doctest::Approx(4.0).epsilon(1e-6));
    CHECK(factors[1] == doctest::Approx(1.0).epsilon(1e-6));
    CHECK(factors[2] == doctest::Approx(2.0).epsilon(1e-6));
  }
  SUBCASE("one that is not there, or does not move, does not count") {
    CHECK(io::intensity({IntensityMeasure::pga, 1.0, {}}, a, {}) == doctest::Approx(amplitude).epsilon(1e-6));
    CHECK(io::intensity({IntensityMeasure::pga, 1.0, {}}, {"still", 0.001, {0.0, 0.0, 0.0}}, b) ==
          doctest::Approx(4.0 * amplitude).epsilon(1e-6));
  }
}

TEST_CASE("motion intensity: direction and scale") {
  const std::string level = "[motion.intensity]\nmeasure = \"PGA\"\nlevel = 3.0\n";
  const cases::GroundMotion ltv = io::load_motion(*read(kRecord + level).motion, "");
  const cases::GroundMotion vlt = io::load_motion(*read(kRecord + "direction = \"VLT\"\n" + level).motion, "");
  CHECK(vlt.factor == ltv.factor);  // L and T are meant, wherever they go
  CHECK(vlt.axis[1].acceleration == ltv.axis[0].acceleration);
  // After `scale`: here L alone moves, and has the level.
  const cases::GroundMotion alone = io::load_motion(*read(kRecord + "scale = [5.0, 0.0, 0.0]\n" + level).motion, "");
  CHECK(peak(alone.axis[0]) == doctest::Approx(3.0).epsilon(1e-12));
  CHECK(peak(alone.axis[1]) == 0.0);
}

TEST_CASE("motion intensity: what was done is told, and the resolved case says it again") {
  const cases::Case c = read(kRecord + "[motion.intensity]\nmeasure = \"Sa\"\nperiod = 0.3\nlevel = 4.0\n");
  const cases::GroundMotion motion = io::load_motion(*c.motion, "");
  CHECK(io::motion_lines(c, motion).find("to reach Sa(0.3 s) = 4 m/s2") != std::string::npos);
  cases::Case pushover = c;
  pushover.analysis.kind = cases::AnalysisKind::pushover;
  CHECK(io::ground_motion(c).axis[0].acceleration == motion.axis[0].acceleration);
  CHECK(io::ground_motion(pushover).axis[0].acceleration.empty());
  CHECK(io::motion_lines(pushover, {}).empty());
  const std::string resolved = io::resolved_toml(c);
  CHECK(io::resolved_toml(read(resolved)) == resolved);
  CHECK(io::load_motion(*read(resolved).motion, "").axis[0].acceleration == motion.axis[0].acceleration);
}

TEST_CASE("motion intensity: what is refused") {
  const auto with = [](const std::string& keys) { return refusal(kRecord + "[motion.intensity]\n" + keys); };
  CHECK(with("measure = \"PGA\"").find("motion.intensity") != std::string::npos);
  CHECK(with("level = 2").find("measure") != std::string::npos);
  CHECK(with("measure = \"PGA\"\nlevel = 0") == "test.toml:5: motion.intensity.level = 0: must be > 0");
  CHECK(with("measure = \"PGA\"\nlevel = 1\ncomponents = \"rotd50\"")
            .find("must be \"each\" | \"geometric mean\" | \"RotD50\" | \"larger\"") != std::string::npos);
  CHECK(with("measure = \"CAV\"\nlevel = 1").find("must be \"PGA\" | \"PGV\" | \"Sa\"") != std::string::npos);
  CHECK(with("measure = \"Sa\"\nlevel = 1").find("needs motion.intensity.period") != std::string::npos);
  CHECK(with("measure = \"PGV\"\nlevel = 1\nperiod = 1").find("goes with measure = \"Sa\" alone") != std::string::npos);
  CHECK(refusal(kRecord + "scale = 2.0\n[motion.intensity]\nmeasure = \"PGA\"\nlevel = 1").find("has no effect beside motion.intensity") !=
        std::string::npos);
  CHECK(refusal(kRecord + "scale = 2.0\n[motion.intensity]\nmeasure = \"PGA\"\nlevel = 1")
            .find("motion.intensity.level says how strong the motion is; in a study the levels of [intensity], in place of scales") !=
        std::string::npos);
  CHECK(refusal(kRecord + "scale = [0.0, 0.0, 1.0]\n[motion.intensity]\nmeasure = \"PGA\"\nlevel = 1")
            .find("motion.intensity: cannot be PGA = 1 m/s2: of the horizontal components as they are it is 0") != std::string::npos);
}
