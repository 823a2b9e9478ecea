// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/replay/values/value_rules.h"

namespace voussoir::io {
namespace {

constexpr std::string_view kElements = "/model/element/mass", kVertices = "/model/vertex", kFaces = "/model/face/element",
                           kCorners = "/model/face/corners", kJoints = "/model/joint/area", kMaterials = "/model/material/density",
                           kLaws = "/model/law/tension", kCells = "/model/cell_type", kFrames = "/frames/time", kCracks = "/cracks/time",
                           kWalls = "/summary/wall/name", kTies = "/model/tie", kMeshes = "/model/mesh", kLoads = "/loads/element",
                           kMeshBars = "/model/mesh_bar_breaking", kTieGroups = "/summary/tie/name";

std::vector<ValueRule> rules_of_model() {
  using enum Values;
  return {{"/model/origin", {"3"}},
          {"/model/element/material", {kElements}, index, kMaterials},
          {"/model/element/kind", {kElements}, index, "10"},
          {"/model/element/mass", {kElements}, positive},
          {"/model/element/inertia", {kElements, "3"}},
          {"/model/element/position0", {kElements, "3"}},
          {"/model/element/fixed", {kElements}, index, "2"},
          {"/model/element/house", {kElements}, index, kElements, -1},
          {"/model/element/first_vertex", {kElements}, start, kVertices},
          {"/model/element/first_face", {kElements}, start, kFaces},
          {"/model/element/", {kElements}},
          {"/model/vertex", {kVertices, "3"}},
          {"/model/cells", {kCells, "8"}, index, kVertices, -1},
          {"/model/cell_type", {kCells}, index, "14", 10},
          {"/model/cell_element", {kCells}, index, kElements},
          {"/model/face/element", {kFaces}, index, kElements},
          {"/model/face/normal", {kFaces, "3"}},
          {"/model/face/first_corner", {kFaces}, start, kCorners},
          {"/model/face/corners", {kCorners}, index, kVertices},
          {"/model/face/", {kFaces}},
          {"/model/joint/element_a", {kJoints}, index, kElements},
          {"/model/joint/element_b", {kJoints}, index, kElements, -1},
          {"/model/joint/face_a", {kJoints}, index, kFaces},
          {"/model/joint/face_b", {kJoints}, index, kFaces, -1},
          {"/model/joint/law", {kJoints}, index, kLaws},
          {"/model/joint/centre", {kJoints, "3"}},
          {"/model/joint/normal", {kJoints, "3"}},
          {"/model/joint/", {kJoints}},
          {"/model/material/", {kMaterials}},
          {"/model/law/", {kLaws}},
          {"/model/tie_ends", {kTies, "6"}},
          {"/model/tie_element", {kTies, "2"}, index, kElements, -1},
          {"/model/tie_strength", {kTies}, any},
          {"/model/mesh_bars", {kMeshes}, positive},
          {"/model/mesh_bar_ends", {kMeshBars, "6"}},
          {"/model/mesh_bar_element", {kMeshBars, "2"}, index, kElements, -1},
          {"/model/mesh_bar_breaking", {kMeshBars}, any}};
}

std::vector<ValueRule> rules_of_rows() {
  using enum Values;
  return {{"/frames/time", {kFrames}, time},
          {"/frames/displacement", {kFrames, kElements, "3"}},
          {"/frames/position", {kFrames, kElements, "3"}},
          {"/frames/quaternion", {kFrames, kElements, "4"}, unit},
          {"/frames/broken", {kFrames, kElements}},
          {"/cracks/time", {kCracks}, late_time},
          {"/cracks/joint", {kCracks}, index, kJoints},
          {"/cracks/element_a", {kCracks}, index, kElements},
          {"/cracks/element_b", {kCracks}, index, kElements, -1},
          {"/cracks/position", {kCracks, "3"}, row},
          {"/cracks/normal", {kCracks, "3"}, row},
          {"/cracks/mode", {kCracks}, index, "4"},
          {"/cracks/first_mode", {kCracks}, index, "4"},
          {"/cracks/", {kCracks}, row},
          {"/history/time", {"/history/time"}, time},
          {"/history/", {"/history/time", "3"}, row},
          {"/ties/force", {"/history/time", kTies}, row},
          {"/ties/elongation", {"/history/time", kTies}, row},
          {"/ties/plastic", {"/history/time", kTies}, row},
          {"/ties/broken", {"/history/time", kTies}, row},
          {"/meshes/force", {"/history/time", kMeshes}, row},
          {"/meshes/elongation", {"/history/time", kMeshes}, row},
          {"/meshes/utilisation", {"/history/time", kMeshes}, any},
          {"/meshes/yielded", {"/history/time", kMeshes}, row},
          {"/meshes/broken", {"/history/time", kMeshes}, row},
          {"/loaded/", {"/history/time", "*", "3"}, any},
          {"/acceleration/time", {"/acceleration/time"}, time},
          {"/acceleration/", {"/acceleration/time", "3"}, row},
          {"/energy/time", {"/energy/time"}, time},
          {"/energy/", {"/energy/time"}, row},
          {"/forces/time", {"/forces/time"}, time},
          {"/forces/", {"/forces/time", "3"}, row},
          {"/cuts/time", {"/cuts/time"}, time},
          {"/cuts/", {"/cuts/time", "3"}, row},
          {"/damage/time", {"/damage/time"}, time},
          {"/damage/", {"/damage/time"}, row},
          {"/assessment/time", {"/assessment/time"}, time},
          {"/assessment/unbalanced", {"/assessment/time"}, any},
          {"/assessment/", {"/assessment/time"}, row},
          {"/motion/factors", {"3"}},
          {"/motion/factor", {"1"}},
          {"/motion/time", {"/motion/time"}, time},
          {"/motion/", {"/motion/time", "3"}},
          {"/loads/load", {kLoads}, index, "1000000000"},
          {"/loads/element", {kLoads}, index, kElements},
          {"/loads/point", {kLoads, "3"}},
          {"/loads/follows", {kLoads}, index, "2"},
          {"/loads/grows", {kLoads}, index, "2"},
          {"/loads/first_row", {kLoads}, start, "/loads/time"},
          {"/loads/time", {"/loads/time"}},
          {"/loads/force", {"/loads/time", "3"}},
          {"/measures/time", {"/measures/time"}, time},
          {"/measures/damage_grade", {"/measures/time"}, index, "6", -1},
          {"/measures/drift", {"/measures/time", kWalls}, any},
          {"/measures/in_plane_drift", {"/measures/time", kWalls}, any},
          {"/measures/storey_drift", {"/measures/time", kWalls}, any},
          {"/measures/", {"/measures/time"}, any},
          {"/summary/wall/", {kWalls}, any},
          {"/summary/tie/", {kTieGroups}, any},
          {"/summary/load/", {"/summary/load/name"}, any}};
}

}  // namespace

const std::vector<ValueRule>& value_rules() {
  static const std::vector<ValueRule> all = [] {
    std::vector<ValueRule> rules = rules_of_model();
    for (ValueRule& r : rules_of_rows()) rules.push_back(std::move(r));
    return rules;
  }();
  return all;
}

const ValueRule* rule_of(const std::string& dataset) {
  for (const ValueRule& r : value_rules())
    if (r.dataset.ends_with('/') ? dataset.starts_with(r.dataset) : dataset == r.dataset) return &r;
  return nullptr;
}

}  // namespace voussoir::io
