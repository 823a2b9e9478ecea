// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/assess/kinematic_check.h"

#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>

// The kinematic verification of Circolare 7/2019 against numbers worked out apart from the program.

using namespace voussoir;
using namespace voussoir::io;

namespace {

/// Relative to the value itself, however small it is.
doctest::Approx about(double value) { return doctest::Approx(value).scale(0.0).epsilon(2e-6); }

constexpr double kG = 9.80665;  // m/s2

/// A straight curve from a multiplier of 0.1 to zero at 0.2 m of the control point.
solver::KinematicCurve straight() {
  solver::KinematicCurve k;
  k.parts = 1, k.freedoms = 1, k.participation = 0.8, k.spectral = 0.75, k.weight = 1e4, k.zero = 0.2;
  k.points = {{0.0, 0.1}, {0.05, 0.075}, {0.2, 0.0}};
  return k;
}

/// EN 1998-1, type 1, ground B, 0.2 g.
KinematicQuestion asked() {
  KinematicQuestion q;
  q.demand.emplace();
  q.demand->name = "ec8:1:B:0.2g";
  q.demand->target.code = Eurocode8{1, 'B', 0.2 * kG};
  return q;
}

constexpr BuildingAround kBuilding{.height = 6.0, .top = 8.0, .period = 0.25, .damping = 0.05, .storeys = 2};

}  // namespace

TEST_CASE("kinematic check: at the base, linear and non-linear") {
  const KinematicCheck c = check_kinematics(straight(), asked(), kG);
  CHECK(c.activation == about(0.90802315));
  CHECK(c.zero == about(0.15));
  REQUIRE(c.lines.size() == 4);
  CHECK(c.lines[0].demand == about(2.353596));
  CHECK(c.lines[1].demand == about(1.176798));
  CHECK(c.lines[1].ratio() == about(1.176798 / 0.90802315));
  CHECK(c.lines[2].capacity == about(0.06));
  CHECK(c.lines[2].period == about(1.75150223));
  CHECK(c.lines[2].demand == about(0.114477783));
  CHECK(c.lines[3].capacity == about(0.09));
  CHECK(c.lines[3].period == about(2.43959239));
  CHECK(c.lines[3].demand == about(0.121693270));
  const std::string text = kinematic_text(straight(), asked(), c, "associated", {});
  CHECK(text.find("multiplier 0.10000, e* 0.8000, a_0 = 0.9080 m/s2 with FC = 1.35") != std::string::npos);
  CHECK(text.find("demand 0.1145 m at 1.752 s, capacity 0.0600 m: demand over capacity 1.908, NOT borne") != std::string::npos);
}

TEST_CASE("kinematic check: at a height the building's first mode amplifies the ground") {
  const DemandSpectrum d = *asked().demand;
  CHECK(floor_acceleration(d, kBuilding).value() == about(5.32200309));
  CHECK(floor_spectrum(d, kBuilding, 0.0, 0.05).value() == about(5.32200309));
  CHECK(floor_spectrum(d, kBuilding, 0.1, 0.05).value() == about(11.4181853));
  CHECK(floor_spectrum(d, kBuilding, 0.25, 0.05).value() == about(26.1807935));
  CHECK(floor_spectrum(d, kBuilding, 1.0, 0.08).value() == about(2.58030031));
  BuildingAround low = kBuilding;
  low.height = 0.0;
  CHECK(floor_acceleration(d, low).value() == about(2.353596));  // that of the ground
  KinematicQuestion q = asked();
  q.around = kBuilding;
  const KinematicCheck c = check_kinematics(straight(), q, kG);
  CHECK(c.lines[1].demand == about(0.5 * 5.32200309));
  CHECK(c.lines[2].demand == about(0.114477783));  // long periods are those of the ground
  q.around->period = 1.4;                          // now the peak lies there
  CHECK(check_kinematics(straight(), q, kG).lines[2].demand > 0.2);
}

TEST_CASE("kinematic check: a curve without a zero has linear lines alone, and a spectrum that ends too soon proves nothing") {
  solver::KinematicCurve k = straight();
  k.zero = solver::KinematicCurve::kNone, k.none = "it slides";
  const KinematicCheck c = check_kinematics(k, asked(), kG);
  CHECK(c.lines[1].open.empty());
  CHECK(c.lines[2].open == "it slides");
  KinematicQuestion q = asked();
  q.demand->target = {"", {}, {0.0, 1.0}, {2.0, 2.0}};
  const KinematicCheck early = check_kinematics(straight(), q, kG);
  CHECK(early.lines[1].demand == about(1.0));
  CHECK(early.lines[2].open.find("has no value at 1.752 s") != std::string::npos);
  CHECK(kinematic_text(straight(), q, early, "associated", {}).find("NOT proven: the spectrum") != std::string::npos);
}

TEST_CASE("kinematic check: a confidence factor divides the acceleration and leaves the displacement, whose period it lengthens") {
  KinematicQuestion q = asked();
  q.confidence = 1.0;
  const KinematicCheck sure = check_kinematics(straight(), q, kG), c = check_kinematics(straight(), asked(), kG);
  CHECK(sure.activation == about(1.35 * c.activation));
  CHECK(sure.zero == c.zero);
  CHECK(c.lines[2].period == about(std::sqrt(1.35) * sure.lines[2].period));
  const auto json = nlohmann::json::parse(kinematic_json(straight(), q, sure, {}));
  CHECK(json["checks"][2]["name"] == "nonlinear_slv");
  CHECK(json["curve"]["displacement"].size() == 3);
}
