// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>

#include "cases/case.h"

/// The paper's houses as case structs (its Tables 1 to 4; places and gaps as in the documentation of houses), for tests of
/// any layer.
namespace voussoir::testing {

inline cases::JointLaw mortar(double tension, double cohesion, double friction, double compression) {
  cases::JointLaw law;
  law.tension = tension;
  law.cohesion = cohesion;
  law.friction = friction;
  law.compression = compression;
  law.thickness = 0.01;
  law.young = 9.8e7;
  law.poisson = 0.25;
  return law;
}

/// Materials and laws of Tables 1 and 3, no house: "adobe", "wood"; "weak", "normal", "strong", "wood".
inline cases::Case paper_materials() {
  cases::Case c;
  c.materials["adobe"] = {1800.0, 9.8e7, 0.25};
  c.materials["wood"] = {700.0, 6.3e8, 0.3};
  c.joint_laws["weak"] = mortar(4.6e3, 2.9e3, 32.0, 4.9e5);
  c.joint_laws["normal"] = mortar(1.27e5, 3.04e4, 32.0, 4.9e5);
  c.joint_laws["strong"] = mortar(1.42e6, 1.19e6, 36.0, 2.66e7);
  c.joint_laws["wood"] = mortar(1.1e7, 9.0e6, 0.0, 4.5e7);
  c.joint_laws["wood"].thickness = 0.0;
  c.joints.default_law = "normal";
  c.damping.ratio = 0.02;
  return c;
}

/// These materials, and a stack of adobe blocks of one size [m] on the base: "block0" at the bottom, "block1" on it, ...
inline cases::Case stack_of_blocks(int count, Vec3 size) {
  cases::Case c = paper_materials();
  c.base = cases::Base{};
  for (int i = 0; i < count; ++i) {
    cases::BlockSpec block;
    block.name = "block" + std::to_string(i), block.material = "adobe";
    block.box = {Vec3{0.0, 0.0, i * size.z}, Vec3{size.x, size.y, (i + 1) * size.z}};
    c.blocks.push_back(block);
  }
  return c;
}

inline cases::Opening opening(std::string wall, double from, double width, double sill, double height, double lintel = 0.0) {
  cases::Opening o{std::move(wall), from, width, sill, height, {}, {}};
  if (lintel > 0.0) o.lintel = cases::Lintel{lintel, 0.1, 0.2};
  return o;
}

inline cases::HistoryPoint history(std::string name, double x, double y) { return {std::move(name), {x, y, 2.0}}; }

/// Flat20W, N or S by the name of the mortar.
inline cases::Case paper_flat20(const std::string& law = "normal") {
  cases::Case c = paper_materials();
  c.title = "Flat roof, bearing walls 0.2 m, " + law + " mortar";
  c.damping.frequency = 6.05;
  c.joints.default_law = law;
  c.base = cases::Base{};
  c.house = cases::House{};
  c.house->joint = law;
  c.house->wood.between_members = law;
  c.house->roof.kind = cases::RoofKind::flat;
  c.house->roof.between_beams = law;
  c.house->openings = {opening("front", 1.0, 1.2, 0.0, 2.0, 1.4), opening("front", 3.4, 1.0, 1.0, 1.0, 1.4)};
  c.output.history = {history("element1", 0.1, 1.7), history("element2", 2.8, 0.1), history("element3", 2.7, 3.3)};
  return c;
}

/// Flat40N.
inline cases::Case paper_flat40() {
  cases::Case c = paper_flat20();
  c.title = "Flat roof, bearing walls 0.4 m, normal mortar";
  c.damping.frequency = 6.08;
  c.house->bearing_wall = 0.4;
  c.output.history = {history("element1", 0.1, 1.9), history("element2", 2.8, 0.2), history("element3", 2.7, 3.6)};
  return c;
}

inline cases::Case with_vault(cases::Case c, double frequency) {
  c.damping.frequency = frequency;
  c.house->roof = {};
  c.house->roof.kind = cases::RoofKind::vault;
  return c;
}

/// Vault20W, N or S by the name of the mortar.
inline cases::Case paper_vault20(const std::string& law = "normal") { return with_vault(paper_flat20(law), 3.13); }

/// Vault40N.
inline cases::Case paper_vault40() { return with_vault(paper_flat40(), 3.32); }

/// Flat20R or Vault20R from the model without reinforcement.
inline cases::Case reinforced(cases::Case c) {
  c.house->reinforcement = cases::Reinforcement{};
  c.house->reinforcement->bearing = {0.25, 0.95, 2.25, 3.35, 4.45, 5.15};
  c.house->reinforcement->nonbearing = {1.2, 2.2};
  return c;
}

}  // namespace voussoir::testing
