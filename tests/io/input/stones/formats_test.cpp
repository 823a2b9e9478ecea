// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>
#include <zlib.h>

#include <algorithm>

#include "io/output/report/vtu_file.h"
#include "tests/io/input/stones/written_files.h"

using namespace stones;
using voussoir::cases::Model;
using voussoir::geometry::Joint;

namespace {

const std::string kBase = "[base]\nz = 0.0\n";

Model model_from(const std::string& file, const std::string& keys = "") { return model_of(load(file, keys, kBase)); }

/// Elements by their centroids: formats without names may have them in another order.
std::vector<std::size_t> order_of(const Model& m) {
  std::vector<std::size_t> order(m.blocks.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](auto a, auto b) { return m.assembly.elements[a].mass.centroid.x < m.assembly.elements[b].mass.centroid.x; });
  return order;
}

void check_same(const Model& a, const Model& b, double tolerance) {
  REQUIRE(a.blocks.size() == b.blocks.size());
  const auto order_a = order_of(a), order_b = order_of(b);
  for (std::size_t i = 0; i < order_a.size(); ++i) {
    const auto &x = a.assembly.elements[order_a[i]].mass, &y = b.assembly.elements[order_b[i]].mass;
    CHECK(norm(x.centroid - y.centroid) <= tolerance);
    CHECK(std::abs(x.volume - y.volume) <= tolerance);
    CHECK(norm(x.principal - y.principal) <= tolerance);
  }
  REQUIRE(a.assembly.joints.size() == b.assembly.joints.size());
  const auto areas = [](const Model& m) {
    std::vector<double> all;
    for (const Joint& j : m.assembly.joints) all.push_back(j.area);
    std::sort(all.begin(), all.end());
    return all;
  };
  const auto areas_a = areas(a), areas_b = areas(b);
  for (std::size_t i = 0; i < areas_a.size(); ++i) CHECK(std::abs(areas_a[i] - areas_b[i]) <= tolerance);
}

std::string base64(const std::string& bytes) {
  static const char* const kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) out += i + k > bytes.size() ? '=' : kLetters[bits >> (18 - 6 * k) & 63U];
  }
  return out;
}

/// An array of VTK as it stands in the file: a head and the bytes, or deflated in two blocks.
std::string vtk_binary(const std::string& bytes, bool deflated) {
  std::string head;
  if (!deflated) {
    append_bytes(head, static_cast<std::uint32_t>(bytes.size()));
    return base64(head + bytes);
  }
  const std::size_t block = (bytes.size() + 1) / 2;
  std::string packed;
  append_bytes(head, std::uint32_t{2});
  append_bytes(head, static_cast<std::uint32_t>(block));
  append_bytes(head, static_cast<std::uint32_t>(bytes.size() - block));
  for (const std::string& part : {bytes.substr(0, block), bytes.substr(block)}) {
    std::vector<Bytef> room(compressBound(part.size()));
    uLongf size = room.size();
    compress(room.data(), &size, reinterpret_cast<const Bytef*>(part.data()), part.size());
    append_bytes(head, static_cast<std::uint32_t>(size));
    packed.append(reinterpret_cast<const char*>(room.data()), size);
  }
  return base64(head) + base64(packed);
}

enum class Vtu { ascii, base64, deflated };
std::string vtu(const std::vector<Named>& all, Vtu kind) {
  std::vector<double> points;
  std::vector<std::int64_t> corners, ends, faces, face_ends;
  for (const Named& n : all) {
    const auto first = static_cast<std::int64_t>(points.size() / 3);
    for (const Vec3& v : n.mesh.vertices) points.insert(points.end(), {v.x, v.y, v.z});
    for (std::size_t v = 0; v < n.mesh.vertices.size(); ++v) corners.push_back(first + static_cast<std::int64_t>(v));
    ends.push_back(static_cast<std::int64_t>(corners.size()));
    faces.push_back(static_cast<std::int64_t>(n.mesh.faces.size()));
    for (const auto& loop : n.mesh.faces) {
      faces.push_back(static_cast<std::int64_t>(loop.size()));
      for (const int v : loop) faces.push_back(first + v);
    }
    face_ends.push_back(static_cast<std::int64_t>(faces.size()));
  }
  const auto array = [&](const std::string& name, const char* type, const auto& values) {
    std::string out = std::string("<DataArray type=\"") + type + "\" Name=\"" + name + "\" format=\"" +
                      (kind == Vtu::ascii ? "ascii" : "binary") + "\">\n";
    if (kind == Vtu::ascii) {
      for (const auto v : values) out += number(static_cast<double>(v)) + " ";
    } else {
      std::string bytes;
      for (const auto v : values) append_bytes(bytes, v);
      out += "  " + vtk_binary(bytes, kind == Vtu::deflated);
    }
    return out + "\n</DataArray>\n";
  };
  return std::string("<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\"") +
         (kind == Vtu::deflated ? " compressor=\"vtkZLibDataCompressor\"" : "") + ">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
         std::to_string(points.size() / 3) + "\" NumberOfCells=\"" + std::to_string(all.size()) + "\">\n<Points>\n" +
         array("Points", "Float64", points) + "</Points>\n<Cells>\n" + array("connectivity", "Int64", corners) +
         array("offsets", "Int64", ends) + array("types", "UInt8", std::vector<std::uint8_t>(all.size(), 42)) +
         array("faces", "Int64", faces) + array("faceoffsets", "Int64", face_ends) +
         "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

Mesh together(const std::vector<Named>& all) {
  Mesh m;
  for (const Named& n : all) {
    const auto first = static_cast<std::int32_t>(m.vertices.size());
    m.vertices.insert(m.vertices.end(), n.mesh.vertices.begin(), n.mesh.vertices.end());
    for (auto loop : n.mesh.faces) {
      for (std::int32_t& v : loop) v += first;
      m.faces.push_back(loop);
    }
  }
  return m;
}

}  // namespace

TEST_CASE("an arch in every format is the same model") {
  const auto all = arch(13, 2.0, 2.4, 0.7);
  const TempFolder folder;
  const Model reference = model_from(folder.write("arch.obj", obj(all)));
  CHECK(reference.assembly.joints.size() == 14);  // twelve between stones, two on the base
  std::vector<Named> triangles = all;
  std::vector<Mesh> meshes;
  for (Named& n : triangles) n.mesh = in_triangles(n.mesh);
  for (const Named& n : all) meshes.push_back(n.mesh);
  SUBCASE("OBJ in triangles") { check_same(reference, model_from(folder.write("a.obj", obj(triangles))), 1e-12); }
  SUBCASE("COMPAS") { check_same(reference, model_from(folder.write("a.json", compas(all, false))), 1e-12); }
  SUBCASE("PLY, parts of one file") { check_same(reference, model_from(folder.write("a.ply", ply(together(all), Ply::ascii))), 1e-12); }
  SUBCASE("PLY, little-endian") { check_same(reference, model_from(folder.write("a.ply", ply(together(all), Ply::little))), 1e-12); }
  SUBCASE("PLY, big-endian") { check_same(reference, model_from(folder.write("a.ply", ply(together(triangles), Ply::big))), 1e-12); }
  SUBCASE("PLY of floats") { check_same(reference, model_from(folder.write("a.ply", ply(together(all), Ply::little_float))), 1e-6 * 4.8); }
  SUBCASE("PLY, a folder") {
    for (const Named& n : all) folder.write("ply/" + n.name + ".ply", ply(n.mesh, Ply::little));
    check_same(reference, model_from(folder.path("ply")), 1e-12);
  }
  SUBCASE("STL, ASCII, one heap of triangles") { check_same(reference, model_from(folder.write("a.stl", stl(meshes, true))), 1e-12); }
  SUBCASE("STL, binary, a folder") {
    for (const Named& n : all) folder.write("stl/" + n.name + ".stl", stl({n.mesh}, false));
    check_same(reference, model_from(folder.path("stl")), 1e-6 * 4.8);
  }
  SUBCASE("STL, binary, one heap of triangles") {
    check_same(reference, model_from(folder.write("a.stl", stl(meshes, false))), 1e-6 * 4.8);
  }
  SUBCASE("VTU, ASCII") { check_same(reference, model_from(folder.write("a.vtu", vtu(all, Vtu::ascii))), 1e-12); }
  SUBCASE("VTU, base64") { check_same(reference, model_from(folder.write("a.vtu", vtu(triangles, Vtu::base64))), 1e-12); }
  SUBCASE("VTU, deflated") { check_same(reference, model_from(folder.write("a.vtu", vtu(all, Vtu::deflated))), 1e-12); }
  SUBCASE("VTU that this program writes") {
    check_same(reference, model_from(folder.write("a.vtu", voussoir::io::mode_shapes_vtu(reference, {}))), 1e-9);
  }
  SUBCASE("inches") {
    std::vector<Named> small = all;
    for (Named& n : small) {
      for (Vec3& v : n.mesh.vertices) v = v / 0.0254;
    }
    check_same(reference, model_of(load(folder.write("a.obj", obj(small)), "", kBase, "in")), 1e-12);
  }
  SUBCASE("millimetres") {
    std::vector<Named> large = all;
    for (Named& n : large) {
      for (Vec3& v : n.mesh.vertices) v *= 1000.0;
    }
    check_same(reference, model_of(load(folder.write("a.obj", obj(large)), "", kBase, "mm")), 1e-12);
  }
}

TEST_CASE("names and groups of an OBJ file") {
  const TempFolder folder;
  const std::string cube = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";
  const std::string faces =
      "f -8//1 -5//1 -6//1 -7//1\nf -4 -3 -2 -1\nf -8 -7 -3 -4\nf -7/1 -6/2 \\\n-2/3 -3/4\nf -6 -5 -1 -2\nf -5 -8 -4 -1\n";
  const std::string file =
      folder.write("a.obj", "mtllib a.mtl\no left one\ng wall pier\n" + cube + faces + "o right\ng wall\n" + cube + faces);
  const auto c = load(file, "place = [3, 0, 0]\nname = \"A\"");
  REQUIRE(c.stones[0].stones.size() == 2);
  CHECK(c.stones[0].stones[0].name == "left one");
  CHECK(c.stones[0].stones[0].groups == std::vector<std::string>{"wall pier", "wall", "pier"});
  CHECK(c.stones[0].stones[1].groups == std::vector<std::string>{"wall"});
  CHECK(load(file, "only = [\"pier\"]").stones[0].stones.size() == 1);
  CHECK(load(file, "only = [\"wall pier\"]").stones[0].stones.size() == 1);
  const auto by_group = load(folder.write("g.obj", "g stone 1\n" + cube + faces + "g stone 2\n" + cube + faces), "");
  REQUIRE(by_group.stones[0].stones.size() == 2);  // a name with blanks, and not twice the group "stone"
  CHECK(by_group.stones[0].stones[1].name == "stone 2");
  CHECK(load(file, "supports = [\"right\"]").stones[0].stones[1].fixed);
  CHECK_FALSE(load(file, "supports = [\"right\"]").stones[0].stones[0].fixed);
  CHECK(refusal(file, "only = [\"nave\"]").find("\"nave\" is no stone or group") != std::string::npos);
  CHECK(refusal(file, "supports = [\"nave\"]").find("\"nave\" is no stone or group") != std::string::npos);
}

TEST_CASE("supports: what the file marks, the ground, below a height") {
  const TempFolder folder;
  const auto all = arch(7, 2.0, 2.4, 0.7);
  const auto fixed = [&](const std::string& file, const std::string& keys, const std::string& rest = "") {
    std::vector<int> out;
    const auto c = load(file, keys, rest);
    for (std::size_t i = 0; i < c.stones[0].stones.size(); ++i) {
      if (c.stones[0].stones[i].fixed) out.push_back(static_cast<int>(i));
    }
    return out;
  };
  const std::string marked = folder.write("marked.json", compas(all, true)), plain = folder.write("plain.json", compas(all, false));
  CHECK(fixed(marked, "") == std::vector<int>{0});
  CHECK(fixed(marked, "supports = \"none\"") == std::vector<int>{});
  CHECK(fixed(marked, "supports = \"ground\"") == std::vector<int>{0, 6});
  CHECK(fixed(plain, "") == std::vector<int>{0, 6});
  CHECK(fixed(plain, "", kBase) == std::vector<int>{});
  CHECK(fixed(plain, "supports = 0.9") == std::vector<int>{0, 1, 5, 6});
}

TEST_CASE("of elements of COMPAS with a hull and a simplified copy beside their geometry, the geometry alone is read") {
  const std::string solid = "{\"dtype\": \"compas.datastructures/Mesh\", \"value\": {\"vertex\": {\"0\": {\"x\": 0, \"y\": 0, \"z\": 0}, "
                            "\"1\": {\"x\": 1, \"y\": 0, \"z\": 0}, \"2\": {\"x\": 0, \"y\": 1, \"z\": 0}, \"3\": {\"x\": 0, \"y\": 0, \"z\": 1}}, "
                            "\"face\": {\"0\": [0, 2, 1], \"1\": [0, 1, 3], \"2\": [1, 2, 3], \"3\": [2, 0, 3]}}}";
  const auto element = [&](const std::string& geometry) {
    return "[{\"dtype\": \"compas_assembly2.element/Element\", \"value\": {\"convex_hull\": " + solid + ", \"geometry\": " + geometry +
           ", \"geometry_simplified\": []}}]";
  };
  const TempFolder folder;
  const auto both = load(folder.write("both.json", element("[" + solid + "]")), "", kBase);
  CHECK(both.stones[0].stones.size() == 1);
  CHECK(std::ranges::count(both.stones[0].notes, "passed over: 1 hulls or simplified copies of elements") == 1);
  CHECK(load(folder.write("hull.json", element("[]")), "", kBase).stones[0].stones.size() == 1);  // all that there is
}

TEST_CASE("damaged files are refused with the place") {
  const TempFolder folder;
  int n = 0;
  const auto fault = [&](const std::string& text) { return refusal(folder.write(std::to_string(n++) + ".dat", text)); };
  const auto says = [](const std::string& message, const std::string& words) { return message.find(words) != std::string::npos; };
  CHECK(says(fault(""), "is empty"));
  CHECK(says(fault("hello\n"), "is of no format"));
  CHECK(says(fault("v 0 0 x\n"), ":1: "));
  CHECK(says(fault("v 0 0 0\nf 1 2 3\n"), ":2: vertex 2 of a face is not there"));
  CHECK(says(fault("v 0 0 0\nf 1 1\n"), ":2: a face of 2 corners"));
  CHECK(says(fault("o a\nv 0 0 0\no a\n"), ":3: the name \"a\" stands twice, first in line 1"));
  CHECK(says(fault("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nend_header\n"), "have no y"));
  CHECK(says(fault("ply\nformat binary_little_endian 1.0\nelement vertex 300000\nproperty double x\nproperty double y\nproperty double "
                   "z\nend_header\nabc"),
             "ends within its numbers"));
  CHECK(says(fault("{\"a\": 1}"), "holds no mesh"));
  CHECK(says(fault("{\"a\": "), "is no JSON"));
  CHECK(says(fault("<VTKFile type=\"PolyData\">"), "wanted: UnstructuredGrid"));
  CHECK(says(refusal(folder.path("missing.obj")), "missing.obj"));
}
