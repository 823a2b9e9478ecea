// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "cases/forward.h"
#include "cases/model.h"

/// Counts, masses and the step bound of a model, for `voussoir check`.
namespace voussoir::cases {

/// Blocks of one kind, a unit in cells as one: a wall, all lintels, all roof beams, or all free blocks of a material.
struct CensusGroup {
  std::string name;
  std::int64_t whole = 0, cut = 0;
  double volume = 0.0;  // m3
  double mass = 0.0;    // kg
};

/// Blocks of equal shape and material, a unit in cells as one: one line of the bill.
struct BillLine {
  PartKind kind = PartKind::block;
  std::int32_t material = 0;      // index into Model::materials
  bool whole = true;              // false: cut
  std::array<double, 3> edges{};  // m, of a box, descending; all zero for any other shape
  std::int32_t corners = 0;       // of a prism other than a box: corners of its section
  std::int32_t faces = 0;         // of any other shape
  std::int64_t count = 0;
  double volume = 0.0;  // m3, of all blocks of the line
};

struct Census {
  std::int64_t elements = 0, faces = 0;
  std::int64_t units = 0, cells = 0, cell_joints = 0;  // units in cells, these cells, and joints between cells of one unit
  std::int64_t joints = 0;                             // of two elements
  std::int64_t base_joints = 0;                        // of an element and the base
  std::int64_t merged_joints = 0;                      // those of `joints` with one spring for both sides
  std::int64_t joint_sides = 0;     // segment sides in all joints; a merged segment counts two, a segment against the base one
  std::int64_t free_segments = 0;   // segments in no joint
  double joint_area = 0.0;          // m2, including joints with the base
  double volume = 0.0, mass = 0.0;  // m3, kg; without fixed blocks
  double fixed_mass = 0.0;          // kg
  std::vector<CensusGroup> groups;  // in order of their first block in building order
  std::vector<BillLine> bill;       // by kind, material, whole before cut, larger before smaller

  double step_bound = 0.0;  // s, Eq. 19: least l / sqrt(E / (1 - nu^2) / rho) of all faces of moving elements; infinite if none moves
  std::int32_t step_element = -1;  // the first element with this bound
  std::int32_t step_face = -1;     // its face, counted from the element's first face
};

Census census(const Model& model);

/// Interval between frames [s]: that of the case, or for "auto" 0.02 s; for large models the least of 0.05, 0.1, 0.2, 0.5, 1, ... s at
/// which elements times frames are at most 40 million (1.3 GB), but no more than a tenth of the duration; 0.02 s for an assessment, whose
/// duration is not known beforehand.
double frame_interval(const Case& c, std::size_t elements);

/// Bound on the time step [s] by one face (Eq. 19). \param distance  from the centroid to the face [m]
double step_bound(const Material& material, double distance) noexcept;

/// The least bound of all faces of a block, and the face that has it.
struct StepBound {
  double step = 0.0;  // s
  std::int32_t face = -1;
};
StepBound step_bound(const Model& model, std::size_t block);

}  // namespace voussoir::cases
