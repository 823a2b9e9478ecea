// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "cases/model.h"
#include "geometry/solids/mesh.h"
#include "io/input/case_file/case_file.h"
#include "io/input/stones/stones.h"
#include "tests/io/temp_folder.h"

/// Cases of stones, and files of them as others would write them.
namespace stones {

using voussoir::Vec3;
using voussoir::geometry::Mesh;

struct Named {
  std::string name;
  Mesh mesh;
};

inline const std::string kMaterial = "[materials.stone]\ndensity = 2000.0\nyoung = 1e9\npoisson = 0.2\n";

/// A case with its stones. `keys`: of [[stones]] beside file and unit.
inline voussoir::cases::Case load(const std::string& file, const std::string& keys = "", const std::string& rest = "",
                                  const std::string& unit = "m") {
  auto c =
      voussoir::io::read_case({"test.toml", kMaterial + rest + "\n[[stones]]\nfile = \"" + file + "\"\nunit = \"" + unit + "\"\n" + keys})
          .value;
  voussoir::io::load_stones(c);
  return c;
}
inline voussoir::cases::Model model_of(const voussoir::cases::Case& c) { return voussoir::cases::build_model(c); }

/// The message of what a file is refused with; "" if it is taken, up to the model.
inline std::string refusal(const std::string& file, const std::string& keys = "", const std::string& rest = "") {
  try {
    model_of(load(file, keys, rest));
  } catch (const std::exception& e) {
    return e.what();
  }
  return "";
}

inline std::string number(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}

inline Mesh box(Vec3 a, Vec3 b) {
  const auto p = voussoir::geometry::make_box(a, b);
  return {p.vertices, p.faces};
}

inline std::string obj(const std::vector<Named>& all) {
  std::string text = "# by a test\n";
  int first = 1;
  for (const Named& n : all) {
    text += "o " + n.name + "\n";
    for (const Vec3& v : n.mesh.vertices) text += "v " + number(v.x) + " " + number(v.y) + " " + number(v.z) + "\n";
    for (const auto& loop : n.mesh.faces) {
      text += "f";
      for (const int v : loop) text += " " + std::to_string(first + v);
      text += "\n";
    }
    first += static_cast<int>(n.mesh.vertices.size());
  }
  return text;
}

}  // namespace stones
