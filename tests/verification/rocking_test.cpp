// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <vector>

#include "cases/names.h"
#include "tests/verification/collapse.h"
#include "tests/verification/contact/contact_by_hand.h"

// V4: a stiff block rocks about its outermost rows of contact points, which lie at b_e = b (1 − 1/n) (Housner 1963), or, with
// segments.rule = "rim" and "corners", at b_e = b.
namespace voussoir::testing {
namespace {

/// The block of rocking.toml and tilt.toml.
struct Block {
  double b = 0.1, h = 0.4;       // m, half width and half height
  int points = 8;                // segments over the base
  std::string rule = "centres";  // segments.rule

  [[nodiscard]] double lever() const { return rule == "centres" ? b * (1.0 - 1.0 / points) : b; }
  [[nodiscard]] std::vector<std::string> segments() const {
    return {"segments.size=" + std::to_string(2.0 * b / points), "segments.rule=" + rule};
  }
  [[nodiscard]] double alpha() const { return std::atan(lever() / h); }
  [[nodiscard]] double radius() const { return std::hypot(lever(), h); }
  /// About the row of contact points, per mass [m2].
  [[nodiscard]] double inertia() const { return (b * b + h * h) / 3.0 + radius() * radius(); }
  [[nodiscard]] double rate() const { return std::sqrt(kGravity * radius() / inertia()); }  // p, 1/s
  /// Potential energy at the angle theta over that of the upright, per mass [J/kg].
  [[nodiscard]] double height(double theta) const {
    return kGravity * radius() * (std::cos(alpha() - std::abs(theta)) - std::cos(alpha()));
  }
  [[nodiscard]] double quarter_period(double theta0) const { return std::acosh(1.0 / (1.0 - theta0 / alpha())) / rate(); }
};

std::string triple(const std::string& key, double x, double y, double z) {
  return key + "=[" + std::to_string(x) + "," + std::to_string(y) + "," + std::to_string(z) + "]";
}

/// Angle about y.
double angle(const Run& run) {
  const Quaternion q = run.orientation(0);
  return 2.0 * std::atan2(q.y, q.w);
}

struct History {
  std::vector<double> time, theta;
};
/// Angles of the block that passes the upright with the speed that takes it to theta0.
History rock(const Block& block, double theta0, double end, const std::vector<std::string>& more = {}) {
  const double w = std::sqrt(2.0 * block.height(theta0) / block.inertia());
  std::vector<std::string> keys{triple("block[0].velocity", block.h * w, 0.0, block.lever() * w),
                                triple("block[0].angular_velocity", 0.0, w, 0.0)};
  const std::string side = std::to_string(block.b), top = std::to_string(2.0 * block.h);
  keys.push_back("block[0].box=[[-" + side + ",-" + side + ",0],[" + side + "," + side + "," + top + "]]");
  for (const std::string& key : block.segments()) keys.push_back(key);
  keys.insert(keys.end(), more.begin(), more.end());
  Run run("rocking", keys);
  History history;
  run.until(end, {}, [&] {
    history.time.push_back(run.time());
    history.theta.push_back(angle(run));
  });
  return history;
}

struct Peak {
  double time = 0.0, theta = 0.0;
};
/// The largest angle from entry `first` on until the sign changes, and the entry behind that change.
Peak next_peak(const History& h, std::size_t& first) {
  Peak peak;
  const bool sign = h.theta[first] > 0.0;
  for (; first < h.theta.size() && (h.theta[first] > 0.0) == sign; ++first) {
    if (std::abs(h.theta[first]) > std::abs(peak.theta)) peak = {h.time[first], h.theta[first]};
  }
  return peak;
}

/// Energy of the second swing over that of the first.
double energy_ratio(const Block& block, const History& h) {
  std::size_t at = 1;
  const Peak first = next_peak(h, at), second = next_peak(h, at);
  REQUIRE(at < h.time.size());
  CHECK(first.theta > 0.0);
  CHECK(second.theta < 0.0);
  return block.height(second.theta) / block.height(first.theta);
}

/// Stone of rocking.toml: adobe, a hundred times as stiff.
constexpr double kStone = 100.0;

/// The block once more, in its plane and by none of the program's code: n points on springs and dashpots, by steps so short that they no
/// longer count. The dashpots are those that the program has at its own step.
History rock_by_hand(const Block& block, double theta0, double end, double programs_step) {
  const double plane = kStone * Adobe::plane, shear = kStone * Adobe::shear, rho = Adobe::density, b = block.b, h = block.h;
  const double beta = face_damping_bound({2 * b, 2 * b, 2 * h}, plane, shear, rho, 1.0);
  const ContactByHand law = ContactByHand::on_base(plane, shear, rho, h, 1.0, 2.0 * programs_step * beta, std::tan(radians(60.0)));
  std::vector<PointByHand> points(static_cast<std::size_t>(block.points), PointByHand(law));
  const double mass = rho * 8.0 * b * b * h, inertia = mass * (b * b + h * h) / 3.0, area = 4.0 * b * b / block.points, dt = 1e-6;
  double w = std::sqrt(2.0 * block.height(theta0) / block.inertia()), theta = 0.0, x = 0.0, z = h;
  Vec3 v{h * w, 0.0, block.lever() * w};
  History history;
  for (double t = 0.0; t < end; t += dt) {
    history.time.push_back(t), history.theta.push_back(theta);
    Vec3 force{0.0, 0.0, -mass * kGravity};
    double torque = 0.0;
    const double c = std::cos(theta), s = std::sin(theta);
    for (int i = 0; i < block.points; ++i) {
      const double along = b * ((2.0 * i + 1.0) / block.points - 1.0);
      const double rx = along * c - h * s, rz = -along * s - h * c;  // from the centroid, turned by theta about y
      const Vec3 f = area * points[static_cast<std::size_t>(i)].step(z + rz, {v.x + w * rz, 0.0, v.z - w * rx}, dt);
      force += f, torque += rz * f.x - rx * f.z;
    }
    v += (dt / mass) * force, w += dt / inertia * torque;
    x += dt * v.x, z += dt * v.z, theta += dt * w;
  }
  return history;
}

/// Rocking history of the closed form until the first impact, and what came out, in parts of alpha.
void draw(const Block& block, double theta0, const History& h) {
  Curve curve{"v4_rocking", "V4: rocking from the upright", "time [s]", "angle / angle of overturning", false, {}};
  Series got{"computed", "-", {}, {}}, exact{"closed form", "--", {}, {}};
  for (std::size_t i = 0; i < h.time.size(); i += 100) {
    got.x.push_back(h.time[i]), got.y.push_back(h.theta[i] / block.alpha());
  }
  const double quarter = block.quarter_period(theta0);
  for (double t = 0.0; t <= 2.0 * quarter; t += quarter / 40.0) {
    exact.x.push_back(t);
    exact.y.push_back(1.0 - (1.0 - theta0 / block.alpha()) * std::cosh(block.rate() * (t - quarter)));
  }
  curve.series = {got, exact};
  write(curve);
}

/// Whether the block topples within 3 s on a base tilted by `tilt` [rad].
bool topples(const Block& block, double tilt) {
  std::vector<std::string> keys = block.segments();
  keys.push_back("base.tilt=[0.0," + std::to_string(tilt * 180.0 / kPi) + "]");
  Run run("tilt", keys);
  run.settle();
  while (run.time() < run.description().time.duration) {
    run.until(run.time() + 0.05);
    if (std::abs(angle(run)) > 0.5 * block.alpha()) return true;
  }
  return false;
}

double tilt_that_topples(const Block& block) {
  return bisect(0.97 * block.alpha(), 1.03 * block.alpha(), 2e-3 * block.alpha(), [&](double tilt) { return topples(block, tilt); });
}

}  // namespace

TEST_CASE("V4: rocking block, quarter period and energy ratio at an impact") {
  const Block block;
  const double theta0 = 0.5 * block.alpha();
  const History h = rock(block, theta0, 1.4);
  std::size_t at = 1;
  const Peak first = next_peak(h, at);
  REQUIRE(at < h.time.size());
  const double impact = h.time[at];
  draw(block, theta0, h);
  expect_near("V4 height of the first swing, angle [rad]", first.theta, theta0, 2e-2);
  expect_near("V4 quarter period from half the angle of overturning [s]", impact - first.time, block.quarter_period(theta0), 2e-2);
  // Expected: the same block by hand, in short steps. Dashpots are semi-implicit, so a quarter of the step has stronger ones.
  const double step = 4e-5;
  expect_within("V4 energy ratio at the first impact", energy_ratio(block, rock(block, theta0, 1.4, {"time.step=4e-5"})),
                energy_ratio(block, rock_by_hand(block, theta0, 1.4, step)), 2e-3);
  const History fine = rock(block, theta0, 1.4, {"time.step=1e-5"});
  expect_within("V4 energy ratio at the first impact, a quarter of the step", energy_ratio(block, fine),
                energy_ratio(block, rock_by_hand(block, theta0, 1.4, 0.25 * step)), 2e-3);
}

TEST_CASE("V4: rocking block, energy ratio of contact at two edges") {
  // With n = 2 there are two rows of contact points and nothing between them: Housner's impact, by angular momentum about the new row.
  Block block;
  block.points = 2;
  const History h = rock(block, 0.5 * block.alpha(), 1.4);
  const double kept = 1.0 - 2.0 * block.lever() * block.lever() / block.inertia();
  expect_within("V4 energy ratio at the first impact, n = 2", energy_ratio(block, h), kept * kept, 0.01);
}

TEST_CASE("V4: rocking block, quarter period beyond the tilt at which a joint comes apart") {
  const Block block;
  const double theta0 = 0.8 * block.alpha();
  REQUIRE(theta0 > 0.15);  // rad: past it the base joint lives on as a free patch
  const History h = rock(block, theta0, 1.4);
  std::size_t at = 1;
  const Peak peak = next_peak(h, at);
  REQUIRE(at < h.time.size());
  expect_near("V4 quarter period from 0.8 of the angle of overturning [s]", h.time[at] - peak.time, block.quarter_period(theta0), 2e-2);
}

TEST_CASE("V4: tilt test") {
  const Block block;
  CHECK(!topples(block, 0.97 * block.alpha()));
  CHECK(topples(block, 1.03 * block.alpha()));
  expect_near("V4 tangent of the tilt at which the block topples", std::tan(tilt_that_topples(block)), block.lever() / block.h, 2e-2);
}

TEST_CASE("V4: points to the rim, n = 4: a block turns about its edge") {
  Block block;
  block.points = 4, block.rule = "rim";
  const double theta0 = 0.5 * block.alpha();
  const History h = rock(block, theta0, 1.4);
  std::size_t at = 1;
  const Peak first = next_peak(h, at);
  REQUIRE(at < h.time.size());
  expect_near("V4 rim: height of the first swing, angle [rad]", first.theta, theta0, 2e-2);
  expect_near("V4 rim: quarter period from half the angle of overturning [s]", h.time[at] - first.time, block.quarter_period(theta0), 1e-2);
  expect_near("V4 rim: tangent of the tilt at which the block topples, against b/h", std::tan(tilt_that_topples(block)), block.b / block.h,
              1e-2);
}

// Between two edges there is nothing that bears: Housner's impact, whatever the stiffness, the dashpots and the height.
TEST_CASE("V4: points at the corners: a block turns about its edge and loses in an impact what Housner's loses") {
  Block block;
  block.rule = "corners";
  const double theta0 = 0.5 * block.alpha();
  const History h = rock(block, theta0, 1.4);
  std::size_t at = 1;
  const Peak first = next_peak(h, at);
  REQUIRE(at < h.time.size());
  expect_near("V4 corners: quarter period from half the angle of overturning [s]", h.time[at] - first.time, block.quarter_period(theta0),
              1e-2);
  expect_near("V4 corners: tangent of the tilt at which the block topples, against b/h", std::tan(tilt_that_topples(block)),
              block.b / block.h, 1e-2);
  struct Way {
    double height;
    std::string key;
  };
  for (const Way& way : {Way{0.4, ""}, Way{0.4, "contact.damping=0.1"}, Way{0.4, "contact.restitution=0.5"},
                         Way{0.4, "materials.stone.young=9.8e8"}, Way{0.3, ""}, Way{0.6, ""}, Way{0.8, ""}}) {
    block.h = way.height;
    const double kept = 1.0 - 2.0 * block.lever() * block.lever() / block.inertia();
    std::vector<std::string> more;
    if (!way.key.empty()) more.push_back(way.key);
    expect_within("V4 corners: energy ratio at the first impact, h/b = " + cases::text(block.h / block.b) + " " + way.key,
                  energy_ratio(block, rock(block, 0.5 * block.alpha(), 1.8, more)), kept * kept, 0.03);
  }
}

TEST_CASE("V4: tilt test, convergence with the size of segments" * doctest::skip()) {
  Series got{"computed", "o", {}, {}}, exact{"1/n", "--", {}, {}};
  for (const int n : {2, 4, 8, 16}) {
    Block block;
    block.points = n;
    const double tangent = std::tan(tilt_that_topples(block)), continuum = block.b / block.h;
    expect_near("V4 tangent of the tilt at which the block topples, n = " + std::to_string(n), tangent, block.lever() / block.h, 2e-2);
    got.x.push_back(n), got.y.push_back(1.0 - tangent / continuum);
    exact.x.push_back(n), exact.y.push_back(1.0 / n);
  }
  write(Curve{
      "v4_tilt", "V4: tilt at which a block topples", "contact points over the base n", "1 less the tangent over b/h", true, {got, exact}});
}

}  // namespace voussoir::testing
