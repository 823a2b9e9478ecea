// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cases/house/house_case.h"
#include "cases/input_error.h"
#include "cases/solids/stones.h"
#include "cases/tables/analysis.h"
#include "cases/tables/base.h"
#include "cases/tables/blocks.h"
#include "cases/tables/contact.h"
#include "cases/tables/joint_laws.h"
#include "cases/tables/joints.h"
#include "cases/tables/loads.h"
#include "cases/tables/materials.h"
#include "cases/tables/motion.h"
#include "cases/tables/output.h"
#include "cases/tables/time.h"
#include "cases/walls/wall_case.h"
#include "geometry/segments/segment_rule.h"
#include "geometry/vec3.h"

/// The input of a simulation as plain data: the parsed case file. SI units, z up; angles in degrees, as in the file.
namespace voussoir::cases {

/// The contents of a case file.
struct Case {
  Case();  // this and the next five are in compiled_once.cpp
  Case(const Case&);
  Case(Case&&) noexcept;
  Case& operator=(const Case&);
  Case& operator=(Case&&) noexcept;
  ~Case();

  std::string title, source;
  Gravity gravity;
  Time time;
  Damping damping;
  std::map<std::string, Material> materials;
  std::map<std::string, JointLaw> joint_laws;
  Scatter scatter;
  Failure failure;
  Joints joints;
  Contact contact;
  Analysis analysis;
  std::optional<Motion> motion;
  std::optional<double> segment_size;                                   // m; key segments.size
  geometry::SegmentRule segment_rule = geometry::SegmentRule::centres;  // key segments.rule
  geometry::Torsion segment_torsion = geometry::Torsion::paper;         // key segments.torsion
  Output output;
  std::optional<House> house;
  std::vector<WallSpec> walls;      // key: wall
  std::vector<WallFloor> floors;    // key: floor, between walls
  std::vector<WallRoof> roofs;      // key: roof, between walls
  std::vector<WallVault> vaults;    // key: vault, between walls
  std::vector<HouseTie> wall_ties;  // key: wall_tie, by sides of walls
  std::vector<BlockSpec> blocks;    // key: block
  std::vector<StonesSpec> stones;
  std::vector<Load> loads;  // key: load
  std::vector<Tie> ties;    // key: tie
  std::optional<Base> base;
  std::string folder;  // folder of the case file; relative paths in the case start here (not a key)
  /// Not a key: the point of the file's axes [m] that all coordinates here are relative to; none: not chosen, they are those of the file
  /// (cases/solids/origin.h).
  std::optional<Vec3> origin;

  /// `time.multirate` of a time history; an analysis has one rate.
  [[nodiscard]] int multirate() const noexcept { return is_assessment(analysis) ? 1 : time.multirate; }
  /// Time of shaking, or of a quasi-static analysis, at which the run ends at the latest [s].
  [[nodiscard]] double end() const noexcept { return is_assessment(analysis) ? analysis.longest : time.duration; }
  void set_end(double t) noexcept { (is_assessment(analysis) ? analysis.longest : time.duration) = t; }
};

}  // namespace voussoir::cases
