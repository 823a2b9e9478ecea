// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/results/results_model.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "io/input/files/errors.h"
#include "tests/io/results_fixture.h"

namespace voussoir::io {
namespace {

using namespace test;

/// The datasets of a model, as they are in a file.
class ModelFile {
 public:
  explicit ModelFile(const cases::Model& m) {
    Hdf5File out = Hdf5File::create(path_);
    write_model(out, m);
    out.close();
  }
  [[nodiscard]] Hdf5File open() const { return Hdf5File::open(path_); }

 private:
  TempFolder folder_;
  std::string path_ = folder_.file("model.h5");
};

template <class T>
std::vector<T> values(const ModelFile& all, const std::string& name) {
  const Hdf5File file = all.open();
  REQUIRE(file.type(name) == Hdf5TypeOf<T>::value);
  return file.read<T>(name);
}

/// A regular polygon in the y-z plane, pulled along x; counter-clockwise seen from +x, or clockwise.
geometry::Polyhedron prism(int corners, bool counter_clockwise) {
  geometry::Polyhedron p;
  for (const double x : {0.0, 1.0})
    for (int i = 0; i < corners; ++i) {
      const double angle = (counter_clockwise ? 1 : -1) * 2 * M_PI * i / corners;
      p.vertices.push_back({x, std::cos(angle), std::sin(angle)});
    }
  std::vector<std::int32_t> bottom, top;
  for (int i = 0; i < corners; ++i) {
    const int next = (i + 1) % corners;
    p.faces.push_back({i, next, corners + next, corners + i});
    bottom.push_back(i);
    top.push_back(corners + i);
  }
  p.faces.push_back(bottom);
  p.faces.push_back(top);
  return p;
}

cases::Model one_block(const geometry::Polyhedron& shape) {
  cases::Model m;
  m.materials = {{"adobe", {1800.0, 9.8e7, 0.25}}};
  m.blocks.emplace_back();
  m.blocks[0].name = "odd";
  m.blocks[0].shape = shape;
  m.assembly.elements.emplace_back();
  return m;
}

Vec3 corner(const cases::Model& m, const std::vector<std::int32_t>& cells, std::size_t i) {
  return m.blocks[0].shape.vertices[static_cast<std::size_t>(cells[i])];
}

}  // namespace

TEST_CASE("the static datasets of two cubes") {
  const ModelFile all(two_cubes());
  CHECK(values<double>(all, "/model/element/mass") == std::vector<double>{1.8, 1.8});
  CHECK(values<double>(all, "/model/element/inertia")[0] == doctest::Approx(1.8 * 0.01 / 6));
  CHECK(values<double>(all, "/model/element/position0")[3] == doctest::Approx(0.15));
  CHECK(all.open().read_strings("/model/element/tag") == std::vector<std::string>{"front wall", "slider"});
  CHECK(values<std::int32_t>(all, "/model/element/first_vertex") == std::vector<std::int32_t>{0, 8});
  CHECK(values<double>(all, "/model/element/segment_size") == std::vector<double>{0.0, 0.0});  // as the fixture has them
  CHECK(values<std::uint8_t>(all, "/model/element/fixed") == std::vector<std::uint8_t>{0, 1});
  CHECK(values<std::int32_t>(all, "/model/cells") == std::vector<std::int32_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15});
  CHECK(values<std::uint8_t>(all, "/model/cell_type") == std::vector<std::uint8_t>{12, 12});
  CHECK(values<std::int32_t>(all, "/model/face/element") == std::vector<std::int32_t>{0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1});
  CHECK(values<double>(all, "/model/vertex")[3 * 8] == doctest::Approx(0.1));
  CHECK(values<std::int32_t>(all, "/model/joint/element_b") == std::vector<std::int32_t>{1});
  CHECK(values<std::int32_t>(all, "/model/joint/law") == std::vector<std::int32_t>{1});
  CHECK(all.open().read_strings("/model/law/name") == std::vector<std::string>{"dry", "normal"});
  CHECK(values<double>(all, "/model/law/tension") == std::vector<double>{0, 1.27e5});
}

TEST_CASE("a bit that flips in the model's numbers is an error, not another number") {
  TempFolder folder;
  const std::string path = folder.file("run.h5");
  std::vector<double> mass(5000);
  for (std::size_t i = 0; i < mass.size(); ++i) mass[i] = 10.0 + 1e-3 * static_cast<double>(i);
  StaticDataset d{.name = "/model/element/mass", .shape = {mass.size()}, .bytes = {}, .source = {}, .note = {"kg", "mass"}};
  d.bytes.assign(reinterpret_cast<const std::byte*>(mass.data()), reinterpret_cast<const std::byte*>(mass.data() + mass.size()));
  {
    Hdf5File file = Hdf5File::create(path);
    write_datasets(file, {d});
  }
  const auto read = [&] { return Hdf5File::open(path).read<double>(d.name); };
  CHECK(read() == mass);
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  std::stringstream all;
  all << file.rdbuf();
  const std::size_t at = all.str().find(std::string(reinterpret_cast<const char*>(&mass[1234]), sizeof(double)));
  REQUIRE(at != std::string::npos);
  file.seekp(static_cast<std::streamoff>(at + 6)).put(static_cast<char>(all.str()[at + 6] ^ 1));
  file.close();
  CHECK_THROWS_AS(read(), FileError);
}

TEST_CASE("cells have the orientation that VTK asks for, whichever way the corners went") {
  for (const bool turn : {false, true})
    for (const int corners : {3, 4, 5, 7}) {
      CAPTURE(turn);
      CAPTURE(corners);
      const cases::Model m = one_block(prism(corners, turn));
      const ModelFile all(m);
      const auto cells = values<std::int32_t>(all, "/model/cells");
      const bool hexahedron = corners == 4;
      REQUIRE(cells.size() == 8U * (hexahedron ? 1U : static_cast<std::size_t>(corners - 2)));
      double volume = 0;
      for (std::size_t c = 0; c < cells.size(); c += 8) {
        const std::size_t third = hexahedron ? 3 : 2, above = hexahedron ? 4 : 3;
        const Vec3 o = corner(m, cells, c);
        const double triple = dot(cross(corner(m, cells, c + 1) - o, corner(m, cells, c + third) - o), corner(m, cells, c + above) - o);
        CHECK((triple > 0) == hexahedron);  // a wedge's bottom looks outward
        if (!hexahedron) CHECK(cells[c + 6] == -1);
        if (!hexahedron) CHECK(cells[c + 7] == -1);
        volume += std::abs(triple) / (hexahedron ? 1 : 2);
      }
      CHECK(volume == doctest::Approx(0.5 * corners * std::sin(2 * M_PI / corners)));
      CHECK(values<std::uint8_t>(all, "/model/cell_type")[0] == (hexahedron ? 12 : 13));
      for (const std::int32_t e : values<std::int32_t>(all, "/model/cell_element")) CHECK(e == 0);
    }
}

TEST_CASE("any other polyhedron is tetrahedra that fill it, each the right way round; its faces are loops") {
  geometry::Polyhedron pyramid = prism(4, true);
  pyramid.vertices.resize(5);
  pyramid.vertices[4] = {0.1, 0.2, 1.5};
  pyramid.faces = {{3, 2, 1, 0}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  const cases::Model m = one_block(pyramid);
  const ModelFile all(m);
  const auto types = values<std::uint8_t>(all, "/model/cell_type");
  const auto cells = values<std::int32_t>(all, "/model/cells");
  double volume = 0.0;
  for (std::size_t c = 0; c < types.size(); ++c) {
    CHECK(types[c] == 10);
    const Vec3 o = corner(m, cells, 8 * c);
    const double six = dot(cross(corner(m, cells, 8 * c + 1) - o, corner(m, cells, 8 * c + 2) - o), corner(m, cells, 8 * c + 3) - o);
    CHECK(six > 0.0);
    volume += six / 6.0;
    for (std::size_t k = 4; k < 8; ++k) CHECK(cells[8 * c + k] == -1);
  }
  CHECK(volume == doctest::Approx(geometry::mass_properties(pyramid).volume).epsilon(1e-12));
  CHECK(values<std::int32_t>(all, "/model/face/first_corner") == std::vector<std::int32_t>{0, 4, 7, 10, 13});
  CHECK(values<std::int32_t>(all, "/model/face/corners") == std::vector<std::int32_t>{3, 2, 1, 0, 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4});
}

TEST_CASE("bars of meshes and decks: between which points, held by what, and when they break; apart from the separate ties") {
  cases::Model m = two_cubes();
  const auto bar = [](const std::string& name, std::int32_t mesh, std::int32_t from, std::int32_t to, double breaking) {
    cases::TieBar b;
    b.name = name, b.mesh = mesh, b.breaking = breaking;
    b.yield = std::numeric_limits<double>::infinity();
    b.ends = {{{{from, 1.0, {1, 2, 3}}}, {{to, 0.25, {4, 0, 0}}, {geometry::kBase, 0.75, {0, 4, 0}}}}};
    return b;
  };
  m.ties = {bar("rod", -1, 0, 1, 0.5), bar("net", 0, 0, 1, std::numeric_limits<double>::infinity()), bar("net", 0, 1, 0, 0.01)};
  const ModelFile all(m);
  CHECK(values<double>(all, "/model/tie_ends") == std::vector<double>{1, 2, 3, 1, 3, 0});
  CHECK(values<std::int32_t>(all, "/model/tie_element") == std::vector<std::int32_t>{0, geometry::kBase});
  CHECK(values<std::int64_t>(all, "/model/mesh_bars") == std::vector<std::int64_t>{2});
  CHECK(values<double>(all, "/model/mesh_bar_ends") == std::vector<double>{1, 2, 3, 1, 3, 0, 1, 2, 3, 1, 3, 0});
  CHECK(values<std::int32_t>(all, "/model/mesh_bar_element") == std::vector<std::int32_t>{0, geometry::kBase, 1, geometry::kBase});
  const auto breaking = values<double>(all, "/model/mesh_bar_breaking");
  REQUIRE(breaking.size() == 2);
  CHECK(std::isnan(breaking[0]));
  CHECK(breaking[1] == 0.01);
}

TEST_CASE("each run.h5 takes the model from the one before, even if that has been removed") {
  const TempFolder folder;
  std::optional<cases::Model> model(two_cubes());
  ResultsWriter results(folder.path(), *model, kCase, kNames, {}, by_hand());
  model.reset();
  const std::string run = folder.file("run.h5");
  const auto all = [&] { return Hdf5File::open(run).datasets(); };
  const std::vector<std::string> before = all();
  for (const char* why : {"so that it is written", "and once more"}) {
    std::filesystem::remove(run);
    results.failure(why);
    results.flush();
    CHECK(all() == before);
    CHECK(Hdf5File::open(run).read<double>("/model/element/mass") == std::vector<double>{1.8, 1.8});
    CHECK(Hdf5File::open(run).attribute_text("/model/element/mass", "unit") == "kg");
  }
}

TEST_CASE("an assembly that is not of the blocks is refused") {
  cases::Model m = two_cubes();
  m.joint_law.clear();
  CHECK_THROWS_AS(ModelFile{m}, std::invalid_argument);
}

}  // namespace voussoir::io
