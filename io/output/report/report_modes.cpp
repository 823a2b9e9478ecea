// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/report_modes.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/input/files/packed_text.h"

namespace voussoir::io {
namespace {

double largest(const std::vector<Vec3>& vectors) {
  double most = 0;
  for (const Vec3 v : vectors) most = std::max({most, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return most;
}

void append(std::vector<std::int16_t>& to, Vec3 v, double unit) {
  for (const double x : {v.x, v.y, v.z}) to.push_back(quantised(x, unit));
}

}  // namespace

ReportModes report_modes(const std::vector<solver::Mode>& modes) {
  ReportModes out;
  nlohmann::json list = nlohmann::json::array();
  for (const solver::Mode& m : modes) {
    const double most = largest(m.displacement), size = most > 0 ? 1 / most : 1,
                 turn = std::max(size * largest(m.rotation) / kQuantaOfASide, 1e-9);
    list.push_back({{"frequency", m.frequency},
                    {"share", {m.mass_share.x, m.mass_share.y, m.mass_share.z}},
                    {"move", 1 / kQuantaOfASide},
                    {"turn", turn}});
    for (std::size_t e = 0; e < m.displacement.size(); ++e) {
      append(out.shape, size * m.displacement[e], 1 / kQuantaOfASide);
      append(out.shape, size * m.rotation[e], turn);
    }
  }
  out.json = list.dump();
  return out;
}

}  // namespace voussoir::io
