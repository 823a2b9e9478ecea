// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <vector>

#include "cases/names.h"
#include "tests/verification/fixture.h"

// THEORY.md (22b): a tilt of a box that spins flat grows or dies at the rate of the linear theory of friction on an elastic foundation.
namespace voussoir::testing {
namespace {

/// A box of sides a, a and h that lies on the base and spins about its vertical axis, so fast that it slides at all its points.
struct Box {
  double side = 0.2, height = 0.1, friction = 32.0;  // m, m, degrees
  double of_bound = 0.995;                           // step over the bound of Eq. 19

  static constexpr double density = 2000.0, young = 1e9, poisson = 0.2;
  [[nodiscard]] double plane() const { return young / (1.0 - poisson * poisson); }
  [[nodiscard]] double step() const { return of_bound * height / 2.0 * std::sqrt(density / plane()); }
  [[nodiscard]] double inertia() const { return mass() * (side * side + height * height) / 12.0; }  // kg m2, about a horizontal axis
  [[nodiscard]] double mass() const { return density * side * side * height; }
  [[nodiscard]] double second_moment() const { return std::pow(side, 4) / 12.0; }  // m4, of the face that lies
};

/// β of (20) of the lower face: 64th root of the sum of the 64th powers of the eigenvalues of M⁻¹C [1/s].
double bound_of_lower_face(const Box& b) {
  const double cn = 2.0 * std::sqrt(b.density * b.plane()),
               cs = 2.0 * std::sqrt(b.density * b.young / (2.0 * (1.0 + b.poisson)));  // Pa s/m
  const double area = b.side * b.side, lever = b.height / 2.0;
  const double sway = cs * area / b.mass(), across = cs * area * lever, rock = (cn * b.second_moment() + across * lever) / b.inertia();
  const double mean = (sway + rock) / 2.0, apart = std::sqrt(std::pow((sway - rock) / 2.0, 2) + across * across / (b.mass() * b.inertia()));
  const double rise = cn * area / b.mass(), yaw = 2.0 * cs * b.second_moment() / (b.mass() * area / 6.0);
  double sum = std::pow(rise, 64) + std::pow(yaw, 64);
  for (const double rate : {mean + apart, mean - apart}) sum += 2.0 * std::pow(rate, 64);
  return std::pow(sum, 1.0 / 64);
}

/// Rate at which a tilt grows [1/s]. Tilts about two horizontal axes are one complex number w. A tilt makes the pressure on one side
/// larger, friction there is larger, too, and turns the box about the other axis: I dw/dt = −(1 + iq) (C w + K θ), with the step's lag.
double growth(const Box& b) {
  const double kn = b.plane() / (b.height / 2.0);
  const double cn = 2.0 * std::sqrt(b.density * b.height * kn) / (1.0 + 2.0 * b.step() * bound_of_lower_face(b));  // (20)
  const double root2 = std::numbers::sqrt2;
  const double first_moment = std::pow(b.side, 3) * (root2 + std::log(1.0 + root2)) / 6.0;  // m3, of distances from the middle
  const double q = std::tan(radians(b.friction)) * b.height / 4.0 * first_moment / b.second_moment();
  using Complex = std::complex<double>;
  const Complex of_friction(1.0, q);
  const Complex c = of_friction * b.step() * cn * b.second_moment() / b.inertia();
  const Complex k = of_friction * b.step() * b.step() * kn * b.second_moment() / b.inertia();
  const Complex half_trace = 1.0 - (c + k) / 2.0, root = std::sqrt(half_trace * half_trace - (1.0 - c));
  return std::log(std::max(std::abs(half_trace + root), std::abs(half_trace - root))) / b.step();
}

struct Tilts {
  std::vector<double> time, tilt;  // s, rad
};

/// Tilts of the box from the step in which it begins to spin, tilting at 1e-5 rad/s, until one of 1e-7 rad, which nearly lifts an edge.
Tilts tilts(const Box& b) {
  const std::string a = cases::text(b.side / 2.0), h = cases::text(b.height);
  cases::Case c = load("spinning_box", {"contact.friction=" + cases::text(b.friction), "block[0].angular_velocity=[1e-5,0,10]",
                                        "output.history[0].point=[0,0," + cases::text(b.height / 2.0) + "]",
                                        "block[0].box=[[-" + a + ",-" + a + ",0],[" + a + "," + a + "," + h + "]]"})
                      .value;
  c.time.step = b.step();
  Run run(std::move(c));
  run.settle();
  Tilts found;
  run.until(0.02, {}, [&] {
    const Quaternion q = run.orientation(0);
    const double tilt = 2.0 * std::hypot(q.x, q.y);
    if (!found.tilt.empty() && found.tilt.back() > 1e-7) return;
    found.time.push_back(run.time()), found.tilt.push_back(tilt);
  });
  return found;
}

/// The same, measured: the slope of the logarithm of the tilt over time, from half a millisecond on [1/s].
double measured_growth(const Box& b) {
  const Tilts all = tilts(b);
  double n = 0.0, t = 0.0, y = 0.0, tt = 0.0, ty = 0.0;
  for (std::size_t i = 0; i < all.time.size(); ++i) {
    if (all.time[i] < 5e-4) continue;
    const double time = all.time[i], logarithm = std::log(all.tilt[i]);
    n += 1.0, t += time, y += logarithm, tt += time * time, ty += time * logarithm;
  }
  return (n * ty - t * y) / (n * tt - t * t);
}

std::string named(const Box& b) {
  return "contact, a box of " + cases::text(b.side) + " m, " + cases::text(b.height) + " m high, spins, " + cases::text(b.friction) +
         " degrees, " + cases::text(b.of_bound) + " of the bound: ";
}

}  // namespace

TEST_CASE("contact: the tilt of a box that spins grows as theory says") {
  for (const Box& b : {Box{.friction = 50.0}, Box{.height = 0.2}, Box{.side = 0.1, .height = 0.15, .of_bound = 0.2},
                       Box{.side = 0.1, .height = 0.15, .friction = 45.0, .of_bound = 0.2}})
    expect_near(named(b) + "growth of a tilt [1/s]", measured_growth(b), growth(b), 0.05);
}

TEST_CASE("contact: the tilt of a box that spins dies where theory says so") {
  for (const Box& b : {Box{}, Box{.height = 0.2, .of_bound = 0.2}}) {
    REQUIRE(growth(b) < -100.0);
    const Tilts all = tilts(b);  // sway of the spinning box keeps a tenth of it up; a tilt that grows is largest at the end
    expect_below(named(b) + "tilt at the end over the largest", all.tilt.back() / *std::max_element(all.tilt.begin(), all.tilt.end()), 0.2);
  }
}

}  // namespace voussoir::testing
