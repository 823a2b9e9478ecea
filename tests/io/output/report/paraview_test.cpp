// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/files/errors.h"
#include "io/input/files/text_file.h"
#include "io/input/files/whole_file.h"
#include "io/output/report/paraview_files.h"
#include "tests/io/results_fixture.h"

namespace voussoir::io {
namespace {

using namespace test;

constexpr double kHalf = 0.05;  // of a cube's edge, m

/// Two frames of the two cubes: at rest; then the first moved by (1, 2, 3) m, the second turned by 90 degrees about z.
void write_run(const TempFolder& folder) {
  ResultsWriter results(folder.path(), two_cubes(), kCase, kNames, {}, by_hand());
  const std::array<float, 8> upright{1, 0, 0, 0, 1, 0, 0, 0};
  const std::array<float, 2> whole{0, 0}, damaged{0.25F, 1};
  results.frame({-0.5, std::array<float, 6>{}, upright, whole});
  const float r = std::sqrt(0.5F);
  results.frame({0.02, std::array<float, 6>{1, 2, 3, 0, 0, 0}, std::array<float, 8>{1, 0, 0, 0, r, 0, 0, r}, damaged});
  results.finish();
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

TEST_CASE("every frame has its vertices turned and moved with their elements") {
  const TempFolder folder;
  write_run(folder);
  write_paraview(folder.path(), false);
  const Hdf5File file = Hdf5File::open(folder.file("paraview.h5"));
  CHECK(file.read<std::int32_t>("/cells").size() == 2 * 9);
  CHECK(file.read<std::int32_t>("/cells")[9] == 9);  // XDMF's hexahedron, of the second cell
  CHECK(file.read<std::int32_t>("/element") == std::vector<std::int32_t>{0, 1});
  CHECK(file.read<std::int32_t>("/material") == std::vector<std::int32_t>{0, 0});

  const auto before = file.read<float>("/frames/0/points"), after = file.read<float>("/frames/1/points");
  REQUIRE(before.size() == 16 * 3);
  const auto reference = Hdf5File::open(folder.file("run.h5")).read<double>("/model/vertex");
  for (std::size_t v = 0; v < 16; ++v) {
    const double x = reference[3 * v], y = reference[3 * v + 1], z = reference[3 * v + 2];
    const bool first = v < 8;
    // a turn by 90 degrees takes (x, y) about the centroid to (-y, x)
    const std::array<double, 3> expected = first ? std::array{x + 1, y + 2, z + 3} : std::array{0.15 - (y - kHalf), kHalf + (x - 0.15), z};
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(before[3 * v + k] == doctest::Approx(reference[3 * v + k]).epsilon(1e-6));
      CHECK(after[3 * v + k] == doctest::Approx(expected[k]).epsilon(1e-6));
    }
  }
  CHECK(file.read<float>("/frames/1/broken") == std::vector<float>{0.25F, 1});
  const auto u = file.read<float>("/frames/1/displacement");
  CHECK(u[0] == doctest::Approx(1));
  CHECK(u[2] == doctest::Approx(3));
  CHECK(u[3] == doctest::Approx(0));
}

TEST_CASE("files for ParaView count from the origin of the run, and say so") {
  const TempFolder folder;
  cases::Model m = two_cubes();
  m.origin = {650001, 4820000, 312};
  ResultsWriter results(folder.path(), m, kCase, kNames, {}, by_hand());
  results.frame({0.0, std::array<float, 6>{1, 0, 0, 0, 0, 0}, std::array<float, 8>{1, 0, 0, 0, 1, 0, 0, 0}, std::array<float, 2>{}});
  results.finish();
  write_paraview(folder.path(), false);
  const Hdf5File file = Hdf5File::open(folder.file("paraview.h5"));
  CHECK(file.read<double>("/origin") == std::vector<double>{650001, 4820000, 312});
  CHECK(file.read<float>("/frames/0/points")[0] == 1.0F);
  const std::string xdmf = read_text_file(folder.file("run.xdmf"), 1U << 20U);
  CHECK(count(xdmf, "<Information Name=\"origin\" Value=\"650001 4820000 312\"/>") == 1);
}

TEST_CASE("run.xdmf has a grid for every frame, and refers to its neighbour by name alone") {
  const TempFolder folder;
  write_run(folder);
  write_paraview(folder.path(), false);
  const std::string xdmf = read_text_file(folder.file("run.xdmf"), 1U << 20U);
  CHECK(count(xdmf, "<Grid Name=\"house\"") == 2);
  CHECK(count(xdmf, "<Time Value=\"-0.5\"/>") == 1);
  CHECK(count(xdmf, "<Time Value=\"0.02\"/>") == 1);
  CHECK(count(xdmf, "Dimensions=\"16 3\">paraview.h5:/frames/1/points<") == 1);
  CHECK(count(xdmf, folder.path()) == 0);
  CHECK(count(xdmf, "Polyhedron") == 0);
}

TEST_CASE("files for ParaView are not replaced unasked, and need frames") {
  const TempFolder folder;
  write_run(folder);
  write_text_file(folder.file("run.xdmf"), "<Xdmf/>");
  CHECK_THROWS_WITH_AS(write_paraview(folder.path(), false), doctest::Contains("--overwrite"), FileError);
  write_paraview(folder.path(), true);
  CHECK(count(read_text_file(folder.file("run.xdmf"), 1U << 20U), "<Grid Name=\"house\"") == 2);

  const TempFolder empty;
  ResultsWriter(empty.path(), two_cubes(), kCase, kNames, {}, by_hand()).finish();
  CHECK_THROWS_WITH_AS(write_paraview(empty.path(), false), doctest::Contains("no frames"), FileError);
  CHECK_FALSE(std::filesystem::exists(empty.file("paraview.h5")));
}

}  // namespace
}  // namespace voussoir::io
