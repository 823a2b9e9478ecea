// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Dense>
#include <array>

#include "tests/verification/fixture.h"

// V1 and V2: a column of N rigid elements on springs, against the closed forms of the discrete chain and, by the rate, of the continuum.
namespace voussoir::testing {
namespace {

/// Square section b × b, length L in N elements of length a, n contact points an edge.
struct Column {
  int elements = 10;
  double length = 2.0, side = 0.2;
  int points = 4;
  bool rim = false;  // segments.rule

  [[nodiscard]] double a() const { return length / elements; }
  [[nodiscard]] double area() const { return side * side; }
  [[nodiscard]] double inertia() const { return side * side * side * side / 12.0; }
  [[nodiscard]] double inertia_n() const { return rim ? inertia() : inertia() * (1.0 - 1.0 / (points * points)); }
};

/// ω_j of the axial chain, rad/s.
double axial_frequency(const Column& c, int j) { return 2.0 * Adobe::speed() / c.a() * std::sin((2 * j - 1) * kPi / (4.0 * c.elements)); }

/// The transverse chain: unknowns (x, θ) an element; joints are springs of shear GA/a and bending E'I_n/a, twice that at the base.
struct BendingModes {
  Eigen::VectorXd omega;  // rad/s
  Eigen::MatrixXd shape;  // columns
  Eigen::VectorXd mass;
};

BendingModes bending_modes(const Column& c) {
  const int n = 2 * c.elements;
  const double a = c.a();
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd m(n);
  for (int i = 0; i < c.elements; ++i) {
    const double share = i == 0 ? 2.0 : 1.0;  // half the compliance at the rigid base
    Eigen::VectorXd shear = Eigen::VectorXd::Zero(n), bend = Eigen::VectorXd::Zero(n);
    shear(2 * i) = 1.0, shear(2 * i + 1) = -0.5 * a, bend(2 * i + 1) = 1.0;
    if (i > 0) shear(2 * i - 2) = -1.0, shear(2 * i - 1) = -0.5 * a, bend(2 * i - 1) = -1.0;
    k += share * Adobe::shear * c.area() / a * shear * shear.transpose() +
         share * Adobe::plane * c.inertia_n() / a * bend * bend.transpose();
    m(2 * i) = Adobe::density * c.area() * a;
    m(2 * i + 1) = m(2 * i) * (c.side * c.side + a * a) / 12.0;
  }
  const Eigen::VectorXd root = m.cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solved(root.asDiagonal() * k * root.asDiagonal());
  return {solved.eigenvalues().cwiseSqrt(), root.asDiagonal() * solved.eigenvectors(), m};
}

/// End values of bending moment times shear force over the two ways to start: zero at a frequency of the Timoshenko cantilever with E'I_n,
/// GA and rotary inertia ρI (1 + (a/h)²). Integrates w' = φ + V/GA, φ' = M/EI, M' = −V − ρI* ω² φ, V' = −ρA ω² w from the clamped end.
double timoshenko_determinant(const Column& c, double omega) {
  const double ei = Adobe::plane * c.inertia_n(), ga = Adobe::shear * c.area(), w2 = omega * omega;
  const double rotary = Adobe::density * c.inertia() * (1.0 + std::pow(c.a() / c.side, 2)), rho = Adobe::density * c.area();
  Eigen::Matrix4d s;
  s << 0, 1, 0, 1 / ga, 0, 0, 1 / ei, 0, 0, -w2 * rotary, 0, -1, -w2 * rho, 0, 0, 0;
  // Fourth order; 500 steps leave 1e-11.
  const int steps = 500;
  const Eigen::Matrix4d h = s * (c.length / steps), one = Eigen::Matrix4d::Identity();
  const Eigen::Matrix4d step = one + h * (one + h / 2 * (one + h / 3 * (one + h / 4)));
  Eigen::Matrix4d all = one;
  for (int i = 0; i < steps; ++i) all = step * all;
  return all.block<2, 2>(2, 2).determinant();
}

/// First frequency [rad/s] by bisection.
double timoshenko_frequency(const Column& c) {
  double low = 0.1 * 2 * kPi, high = low;
  const bool sign = timoshenko_determinant(c, low) > 0.0;
  while ((timoshenko_determinant(c, high) > 0.0) == sign) low = high, high *= 1.05;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    ((timoshenko_determinant(c, middle) > 0.0) == sign ? low : high) = middle;
  }
  return low;
}

/// The free column in `elements` pieces, with the same speed of the top.
cases::Case free_column(const Column& c) {
  cases::Case free = load("column_free").value;
  const Vec3 speed = free.blocks.back().velocity;
  cases::BlockSpec piece = free.blocks.front();
  free.blocks.clear();
  for (int i = 0; i < c.elements; ++i) {
    piece.name = "e" + std::to_string(i);
    piece.box = {{Vec3{-0.5 * c.side, -0.5 * c.side, i * c.a()}, Vec3{0.5 * c.side, 0.5 * c.side, (i + 1) * c.a()}}};
    free.blocks.push_back(piece);
  }
  free.blocks.back().velocity = speed;
  return free;
}

/// Share of a bending mode in the present state.
double bending_share(const Run& run, const BendingModes& modes, int j) {
  double sum = 0.0;
  for (int i = 0; i < static_cast<int>(run.count()); ++i) {
    const auto e = static_cast<std::size_t>(i);
    sum += modes.shape(2 * i, j) * modes.mass(2 * i) * run.displacement(e).x +
           modes.shape(2 * i + 1, j) * modes.mass(2 * i + 1) * 2.0 * run.orientation(e).y;
  }
  return sum;
}

/// Deflection of the top [m] under the load of the case, and the closed form of the discrete column.
void bend(const std::string& row, const Column& c, const std::vector<std::string>& keys) {
  Run run("column_bend", keys);
  run.until(run.description().time.duration);
  const double load = 0.1, n = c.elements;
  const double bending = load * std::pow(c.length, 3) / (3.0 * Adobe::plane * c.inertia_n()) * (1.0 + 1.0 / (2.0 * n * n));
  const double shear = load * c.length / (Adobe::shear * c.area()) * (1.0 - 1.0 / (2.0 * n));
  const double got = run.displacement(9).x + 2.0 * run.orientation(9).y * 0.5 * c.a();
  expect_near(row + " end load, deflection at z = L [m]", got, bending + shear, 1e-4);
}

}  // namespace

TEST_CASE("V1: axial column, end load") {
  const Column c;
  Run run("column_pull");
  run.until(run.description().time.duration);
  const double load = 1000.0;
  const double expected = -load * (c.length - 0.5 * c.a()) / (Adobe::plane * c.area());
  expect_near("V1 end load, u of the top block [m]", run.displacement(9).z, expected, 1e-4);
}

// THEORY.md (5a): N joints, the foot's too, of 0.05 m of adobe's normal stiffness and a third of its shear stiffness, in series.
TEST_CASE("V1: axial column whose joints have a stiffness of their own") {
  const Column c;
  const double own = Adobe::plane / 0.05, own_shear = Adobe::shear / 0.15;
  const std::vector<std::string> keys = {"joint_laws.glue.normal_stiffness=" + std::to_string(own),
                                         "joint_laws.glue.shear_stiffness=" + std::to_string(own_shear)};
  std::vector<std::string> slower = keys;
  slower.insert(slower.end(), {"damping.alpha=320", "time.duration=0.4"});
  Run pulled("column_pull", slower);
  pulled.until(pulled.description().time.duration);
  const double stretch = (c.length - 0.5 * c.a()) / Adobe::plane + c.elements / own;
  expect_near("V1 joints of a stiffness, u of the top block [m]", pulled.displacement(9).z, -1000.0 / c.area() * stretch, 1e-4);

  const double force = 0.1, alpha = 12.0;  // about critical for the first mode, by shear and bending
  std::vector<std::string> bent = keys;
  bent.insert(bent.end(), {"damping.alpha=" + std::to_string(alpha), "time.duration=5"});
  Run bend("column_bend", bent);
  bend.until(bend.description().time.duration);
  double deflection = 0.0;
  for (int i = 0; i < c.elements; ++i) {  // joint i at the height i a under the arm L − i a
    const double arm = c.length - i * c.a(), blocks = (i == 0 ? 0.5 : 1.0) * c.a();
    deflection += force * arm * arm / c.inertia_n() * (blocks / Adobe::plane + 1.0 / own);
    deflection += force / c.area() * (blocks / Adobe::shear + 1.0 / own_shear);
  }
  const double got = bend.displacement(9).x + 2.0 * bend.orientation(9).y * 0.5 * c.a();
  expect_near("V1 joints of a stiffness, deflection at z = L [m]", got, deflection, 1e-4);
}

TEST_CASE("V1: free vibration of a column whose joints have a stiffness of their own") {
  const Column c;
  const double own = Adobe::plane / 0.05;
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(c.elements, c.elements);
  for (int i = 0; i < c.elements; ++i) {
    const double spring = c.area() / ((i == 0 ? 0.5 : 1.0) * c.a() / Adobe::plane + 1.0 / own);
    k(i, i) += spring;
    if (i > 0) k(i - 1, i - 1) += spring, k(i, i - 1) -= spring, k(i - 1, i) -= spring;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solved(k / (Adobe::density * c.area() * c.a()));
  Run run("column_free", {"joint_laws.glue.normal_stiffness=" + std::to_string(own), "joint_laws.glue.shear_stiffness=1e9"});
  std::array<RisingZeros, 2> zeros;
  run.until(2.0, {}, [&] {
    for (int j = 0; j < 2; ++j) {
      double share = 0.0;
      for (int i = 0; i < c.elements; ++i) share += solved.eigenvectors()(i, j) * run.displacement(static_cast<std::size_t>(i)).z;
      zeros[static_cast<std::size_t>(j)].add(run.time(), share);
    }
  });
  for (std::size_t j = 0; j < 2; ++j) {
    const double expected = std::sqrt(solved.eigenvalues()[static_cast<Eigen::Index>(j)]) / (2.0 * kPi);
    expect_near("V1 joints of a stiffness, frequency of mode " + std::to_string(j + 1) + " [Hz]", zeros[j].frequency(), expected, 1e-3);
  }
}

TEST_CASE("V1: axial column, free vibration") {
  const Column c;
  Run run("column_free");
  std::array<RisingZeros, 2> zeros;
  run.until(2.0, {}, [&] {
    for (int j = 0; j < 2; ++j) {
      double share = 0.0;  // equal masses: the modes are orthogonal as they stand
      for (int i = 0; i < c.elements; ++i) {
        share += std::sin((2 * j + 1) * kPi * (i + 0.5) / (2.0 * c.elements)) * run.displacement(static_cast<std::size_t>(i)).z;
      }
      zeros[static_cast<std::size_t>(j)].add(run.time(), share);
    }
  });
  const double figures[] = {30.092, 89.536};  // Hz, as the specification prints them
  for (int j = 0; j < 2; ++j) {
    const double expected = axial_frequency(c, j + 1) / (2 * kPi);
    CHECK(std::abs(expected - figures[j]) < 6e-4);
    expect_near("V1 axial frequency " + std::to_string(j + 1) + " [Hz]", zeros[static_cast<std::size_t>(j)].frequency(), expected, 2e-3);
  }
}

TEST_CASE("V1: two blocks whose segments do not coincide") {
  // Faces of 0.2 m in 4 and in 8 cells: two sides of half the area each, with their own second moments I (1 − 1/n²).
  const double side = 0.2, area = side * side, inertia = side * side * side * side / 12.0;
  const double length = 0.1 + 0.05;  // m, both blocks' distances from centroid to face
  const double inertia_n = 0.5 * inertia * ((1.0 - 1.0 / 16.0) + (1.0 - 1.0 / 64.0));
  // Up to the rim both have the same points, and I.
  for (const bool rim : {false, true}) {
    Run run("two_sided", {std::string("segments.rule=") + (rim ? "\"rim\"" : "\"centres\"")});
    run.until(run.description().time.duration);
    const std::string row = rim ? "V1 rim: the same blocks" : "V1 two sides";
    expect_near(row + ", shortening [m]", -run.displacement(1).z, 10.0 * length / (Adobe::plane * area), 1e-4);
    expect_near(row + ", rotation [rad]", 2.0 * run.orientation(1).y, 1.0 * length / (Adobe::plane * (rim ? inertia : inertia_n)), 1e-4);
  }
}

TEST_CASE("V2: cantilever, end load") { bend("V2", {}, {}); }

TEST_CASE("V2: cantilever, end load, points to the rim: E'I whatever n") {
  for (const int n : {2, 3, 4}) {
    Column c;
    c.points = n, c.rim = true;
    const std::string row = "V2 rim, n = " + std::to_string(n) + ":";
    bend(row, c, {"segments.size=" + std::to_string(c.side / n), "segments.rule=\"rim\""});
  }
}

TEST_CASE("V2: cantilever of oblong section, end load along either edge") {
  const double b = 0.1, d = 0.2, size = 0.025, length = 2.0, load = 0.1;  // m along x, m along y, m, m, N
  const int n = 10;
  for (const bool along_x : {true, false}) {
    cases::Case c =
        testing::load("column_bend", {"segments.size=0.025", "damping.alpha=" + std::string(along_x ? "11.7" : "23.4"), "time.duration=6"})
            .value;
    for (cases::BlockSpec& block : c.blocks) (*block.box)[0].x = -0.5 * b, (*block.box)[1].x = 0.5 * b;
    c.loads[0].force = along_x ? Vec3{load, 0.0, 0.0} : Vec3{0.0, load, 0.0};
    Run run(c);
    run.until(c.time.duration);
    const double depth = along_x ? b : d, breadth = along_x ? d : b, points = depth / size;
    const double inertia = breadth * std::pow(depth, 3) / 12.0 * (1.0 - 1.0 / (points * points));
    const double bending = load * std::pow(length, 3) / (3.0 * Adobe::plane * inertia) * (1.0 + 1.0 / (2.0 * n * n));
    const double shear = load * length / (Adobe::shear * b * d) * (1.0 - 1.0 / (2.0 * n));
    const Quaternion q = run.orientation(9);
    const double half = 0.5 * length / n;
    const double got = along_x ? run.displacement(9).x + 2.0 * q.y * half : run.displacement(9).y - 2.0 * q.x * half;
    expect_near("V2 oblong section, deflection along " + std::string(along_x ? "x" : "y") + " [m]", got, bending + shear, 1e-4);
  }
}

TEST_CASE("V2: cantilever, frequencies") {
  const Column c;
  const BendingModes modes = bending_modes(c);
  Run run("column_free");
  std::array<RisingZeros, 3> zeros;
  run.until(5.0, {}, [&] {
    for (int j = 0; j < 3; ++j) zeros[static_cast<std::size_t>(j)].add(run.time(), bending_share(run, modes, j));
  });
  const double figures[] = {1.8636, 11.1269, 29.278}, digit[] = {6e-5, 6e-5, 6e-4};  // Hz, as the specification prints them
  for (int j = 0; j < 3; ++j) {
    const double expected = modes.omega(j) / (2 * kPi);
    CHECK(std::abs(expected - figures[j]) < digit[j]);
    expect_near("V2 bending frequency " + std::to_string(j + 1) + " [Hz]", zeros[static_cast<std::size_t>(j)].frequency(), expected, 2e-3);
  }
}

TEST_CASE("V2: cantilever, rate of convergence to the Timoshenko beam") {
  std::array<double, 3> error{};
  std::size_t k = 0;
  Curve curve{"v2_convergence", "V2: first bending frequency against the Timoshenko beam", "elements N", "relative difference", true, {}};
  Series got{"computed", "o", {}, {}}, rate{"second order", "--", {}, {}};
  for (const int elements : {5, 10, 20}) {
    Column c;
    c.elements = elements;
    const BendingModes modes = bending_modes(c);
    Run run(free_column(c));
    RisingZeros zeros;
    run.until(5.0, {}, [&] { zeros.add(run.time(), bending_share(run, modes, 0)); });
    const double beam = timoshenko_frequency(c) / (2 * kPi);
    error[k++] = zeros.frequency() / beam - 1.0;
    MESSAGE("V2 N = ", elements, ": beam ", beam, " Hz, got ", zeros.frequency(), ", difference ", error[k - 1]);
    got.x.push_back(elements), got.y.push_back(std::abs(error[k - 1]));
    rate.x.push_back(elements), rate.y.push_back(std::abs(error[0]) * std::pow(5.0 / elements, 2));
  }
  curve.series = {got, rate};
  write(curve);
  // Second order: a quarter for half the length. The next order of the series allows a tenth.
  for (std::size_t i = 0; i < 2; ++i) expect_near("V2 rate, error(N)/error(2N)", error[i] / error[i + 1], 4.0, 0.1);
}

}  // namespace voussoir::testing
