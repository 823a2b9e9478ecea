// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/report_model.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>

#include "geometry/nth.h"
#include "io/input/files/errors.h"
#include "io/output/replay/cells.h"
#include "io/output/replay/joint_cracks.h"

namespace voussoir::io {

ReportModel report_model(const Hdf5File& run, const std::string& fault, const std::vector<std::int32_t>& faults) {
  ReportModel out;
  out.fixed = run.read<std::uint8_t>("/model/element/fixed");
  const auto law = run.read<std::int32_t>("/model/joint/law");
  const std::vector<std::string> names = run.read_strings("/model/law/name");
  std::vector<int> joints(names.size(), 0);
  for (const std::int32_t l : law) {
    if (l < 0 || static_cast<std::size_t>(l) >= names.size()) throw FileError(run.path(), "/model/joint/law names no law");
    ++nth(joints, l);
  }
  nlohmann::json laws = nlohmann::json::array();
  for (std::size_t i = 0; i < names.size(); ++i) laws.push_back({{"name", names[i]}, {"joints", joints[i]}});
  out.json = nlohmann::json{{"laws", laws}, {"fault", fault}, {"faults", faults}}.dump(-1, ' ', true);

  std::vector<std::size_t> all(law.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const auto edges = joint_edges(run, all, DryJoints::cover);
  for (std::size_t j = 0; j < edges.size(); ++j) {
    for (const JointEdge& e : edges[j]) {
      for (const Vec3& v : {e.from, e.to}) {
        for (const double x : {v.x, v.y, v.z}) out.joint_ends.push_back(static_cast<float>(x));
      }
      out.edge_law.push_back(static_cast<std::uint8_t>(std::min(law[j], 255)));
    }
  }
  return out;
}

std::vector<std::int32_t> polyhedron_loops(const Hdf5File& run) {
  std::vector<std::int32_t> out;
  if (!run.exists("/model/face/corners")) return out;
  const auto type = run.read<std::uint8_t>("/model/cell_type");
  const auto of_cell = run.read<std::int32_t>("/model/cell_element");
  const auto element = run.read<std::int32_t>("/model/face/element"), first = run.read<std::int32_t>("/model/face/first_corner");
  const auto corner = run.read<std::int32_t>("/model/face/corners");
  if (type.size() != of_cell.size() || first.size() != element.size()) throw FileError(run.path(), "/model/face does not fit together");
  std::vector<std::int32_t> polyhedra;
  for (std::size_t c = 0; c < type.size(); ++c) {
    const bool another = c > 0 && of_cell[c - 1] == of_cell[c];  // a prism of several wedges: each of its ends is one face, not triangles
    if (type[c] == kTetrahedron || another) polyhedra.push_back(of_cell[c]);
  }
  std::ranges::sort(polyhedra);
  for (std::size_t f = 0; f < element.size(); ++f) {
    if (!std::binary_search(polyhedra.begin(), polyhedra.end(), element[f])) continue;
    const std::size_t from = static_cast<std::size_t>(first[f]),
                      end = f + 1 < first.size() ? static_cast<std::size_t>(first[f + 1]) : corner.size();
    if (first[f] < 0 || end < from || end > corner.size()) throw FileError(run.path(), "/model/face/corners does not fit together");
    out.push_back(element[f]);
    out.push_back(static_cast<std::int32_t>(end - from));
    out.insert(out.end(), corner.begin() + static_cast<std::ptrdiff_t>(from), corner.begin() + static_cast<std::ptrdiff_t>(end));
  }
  return out;
}

}  // namespace voussoir::io
