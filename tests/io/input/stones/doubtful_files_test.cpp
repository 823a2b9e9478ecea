// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "tests/io/input/stones/written_files.h"

// Files that are read, but may be damaged or hold more than was read. (findings_test.cpp: these doubts are findings of `check` and `view`.)

using namespace stones;

namespace {

const Mesh kBox = box({0, 0, 0}, {1, 1, 1});

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  REQUIRE(text.find(from) != std::string::npos);
  return text.replace(text.find(from), from.size(), to);
}

/// One tetrahedron. \param corners  of the connectivity
std::string vtu(const std::string& corners) {
  const auto array = [](const std::string& name, const std::string& type, const std::string& values) {
    return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" format=\"ascii\">" + values + "</DataArray>\n";
  };
  return "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"4\" "
         "NumberOfCells=\"1\">\n<Points>" +
         array("Points", "Float64", "0 0 0 1 0 0 0 1 0 0 0 1") + "</Points>\n<Cells>" + array("connectivity", "Int64", corners) +
         array("offsets", "Int64", "4") + array("types", "UInt8", "10") + "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

/// The only doubt about a file of one stone; "": there is none.
std::string doubt(const std::string& file) {
  const auto c = load(file);
  CHECK(c.stones[0].stones.size() == 1);
  CHECK(c.stones[0].doubts.size() <= 1);
  return c.stones[0].doubts.empty() ? "" : c.stones[0].doubts.front();
}

}  // namespace

TEST_CASE("doubts: OBJ with lines that it does not know, or cut in a line that is to go on") {
  const TempFolder folder;
  const std::string plain = obj({{"a", kBox}});
  CHECK(doubt(folder.write("a.obj", plain + "vn 0 0 1\nusemtl red\ns off\n# end\n")).empty());
  CHECK(doubt(folder.write("a.obj", plain + "call b.obj\nvt 0 0\nface 1 2 3\n"))
            .starts_with("left out: 2 lines that are not of OBJ, the first with 'call' in line "));
  CHECK(doubt(folder.write("a.obj", replaced(plain, "\nf ", "\nfo "))).empty());
  CHECK(refusal(folder.write("a.obj", plain + "f 1 2 \\\n")).find("ends within a line that is to go on") != std::string::npos);
}

TEST_CASE("doubts: PLY with bytes behind its last element, or with strips of triangles") {
  const TempFolder folder;
  for (const Ply kind : {Ply::ascii, Ply::little}) {
    const std::string plain = ply(kBox, kind);
    CHECK(doubt(folder.write("a.ply", plain + "\n")).empty());
    CHECK(doubt(folder.write("a.ply", plain + "3 0 1 2")).find(" behind its last element are passed over") != std::string::npos);
  }
  const std::string strips =
      replaced(ply(kBox, Ply::ascii), "end_header", "element tristrips 1\nproperty list int int vertex_indices\nend_header");
  CHECK(doubt(folder.write("a.ply", strips + "3 0 1 2\n")) == "left out: its strips of triangles (tristrips); write faces");
}

TEST_CASE("doubts: VTU that was cut, or whose connectivity goes on behind its cells") {
  const TempFolder folder;
  CHECK(doubt(folder.write("a.vtu", vtu("0 1 2 3"))).empty());
  CHECK(doubt(folder.write("a.vtu", vtu("0 1 2 3 0 1"))) == "2 numbers behind the last cell of its connectivity are passed over");
  CHECK(doubt(folder.write("a.vtu", replaced(vtu("0 1 2 3"), "</VTKFile>", ""))) == "ends without </VTKFile>: it may have been cut");
}

TEST_CASE("doubts: COMPAS with solids of other kinds; a transformation without a matrix is refused") {
  const TempFolder folder;
  const std::string box_data = R"({"dtype": "compas.geometry/Box", "data": {"xsize": 1, "ysize": 1, "zsize": 1,
    "frame": {"data": {"point": [0, 0, 0], "xaxis": [1, 0, 0], "yaxis": [0, 1, 0]}}}})";
  const std::string drum = R"({"dtype": "compas.geometry/Cylinder", "data": {"radius": 1, "height": 2}})";
  CHECK(doubt(folder.write("a.json", "[" + box_data + "]")).empty());
  CHECK(doubt(folder.write("a.json", "[" + box_data + ", " + drum + ", " + drum + "]")) ==
        "left out: 2 of 'compas.geometry/Cylinder', which are no mesh, polyhedron or box");
  const std::string moved = R"([{"transformation": {"data": {"matrix": [[1, 0, 0, 5]]}}, "geometry": )" + box_data + "}]";
  CHECK(refusal(folder.write("a.json", moved)).find("has a transformation without a matrix") != std::string::npos);
}

TEST_CASE("COMPAS: corners that a transformation or the size of a box carries beyond all numbers are refused by name") {
  const TempFolder folder;
  const std::string mesh = R"("vertices":[[0,0,0],[9,0,0],[0,1,0],[0,0,1]],"faces":[[0,2,1],[0,1,3],[1,2,3],[2,0,3]]})";
  const std::string far = R"({"transformation":{"matrix":[[1e308,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]},)";
  CHECK(refusal(folder.write("a.json", "{" + mesh)).empty());
  CHECK(refusal(folder.write("a.json", far + mesh)).find("has corners that are no finite numbers") != std::string::npos);
  const std::string box =
      R"({"dtype":"compas.geometry/Box","data":{"frame":{"point":[1e308,0,0],"xaxis":[1,0,0],"yaxis":[0,1,0]},"xsize":1.7e308,)"
      R"("ysize":1,"zsize":1}})";
  CHECK(refusal(folder.write("a.json", box)).find("has corners that are no finite numbers") != std::string::npos);
}

TEST_CASE("a face of more corners than any stone has is refused by name, at once") {
  const TempFolder folder;
  constexpr int kCorners = 300000;
  std::string text = "o disc\n", face = "f";
  for (int i = 0; i < kCorners; ++i) {
    text += "v " + std::to_string(std::cos(6.28 * i / kCorners)) + " " + std::to_string(std::sin(6.28 * i / kCorners)) + " 0\n";
    face += " " + std::to_string(i + 1);
  }
  CHECK(refusal(folder.write("a.obj", text + face + "\n")).find("holds a face of 300000 corners, of 'disc'; allowed: at most 1000") !=
        std::string::npos);
}

TEST_CASE("a face of many groups takes time in proportion") {
  const TempFolder folder;
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\ng";
  for (int i = 0; i < 200000; ++i) text += " n" + std::to_string(i);
  const auto c = load(folder.write("a.obj", text + "\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"));
  CHECK(c.stones[0].stones.size() == 1);
}

TEST_CASE("a corner so far off that all others weld to one place leaves no solid") {
  const TempFolder folder;
  for (const char* far : {"2147483648", "1e12", "1e300"}) {
    Mesh m = kBox;
    m.vertices[2].y = std::stod(far);
    CHECK(refusal(folder.write("a.obj", obj({{"a", m}}))).find("holds no solid") != std::string::npos);
    CHECK(load(folder.write("b.obj", obj({{"a", m}, {"b", kBox}}))).stones[0].stones.size() == 1);
  }
}
