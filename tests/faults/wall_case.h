// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sstream>
#include <string>

/// A case file, with its motion, of a small wall that settles, cracks and falls in a second or two of computing.
namespace voussoir::testing {

/// Courses of running bond, four bricks long.
inline std::string wall_toml() {
  std::ostringstream t;
  t << "title = \"a wall that falls\"\n"
       "[gravity]\nramp = 0.05\nsettle_limit = 0.05\n"
       "[time]\nstep = 2e-4\nduration = 1.2\n"
       "[damping]\nalpha = 1.5\n"
       "[materials.adobe]\ndensity = 1800.0\nyoung = 9.8e7\npoisson = 0.25\n"
       "[joint_laws.mortar]\ntension = 4.6e3\ncohesion = 2.9e3\nfriction = 32.0\ncompression = 4.9e5\n"
       "[joints]\ndefault = \"mortar\"\n[base]\nz = 0.0\n[segments]\nsize = 0.025\n"
       "[motion]\ny = \"y.csv\"\n"
       "[output]\nframe_interval = 0.005\n[[output.history]]\nname = \"top\"\npoint = [0.4, 0.05, 0.75]\n";
  for (int course = 0; course < 8; ++course) {
    const bool halves = course % 2 == 1;
    for (int from = 0; from < 8;) {  // in half bricks
      const int to = std::min(8, from + (halves && from == 0 ? 1 : 2));
      t << "[[block]]\nname = \"c" << course << "_" << from << "\"\nmaterial = \"adobe\"\nbox = [[" << 0.1 * from << ", 0.0, "
        << 0.1 * course << "], [" << 0.1 * to << ", 0.1, " << 0.1 * (course + 1) << "]]\n";
      from = to;
    }
  }
  return t.str();
}

/// A saw of 15 m/s2 across the wall.
inline std::string wall_motion() {
  std::ostringstream t;
  t << "t [s], a [m/s2]\n";
  for (int i = 0; i < 200; ++i) t << 0.01 * i << ", " << 15.0 * ((i * 8 % 40) / 20.0 - 1.0) << "\n";
  return t.str();
}

}  // namespace voussoir::testing
