// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/commands/words/check_json.h"

#include <nlohmann/json.hpp>

#include "cases/case.h"
#include "cases/names.h"
#include "geometry/nth.h"

namespace voussoir::io {
namespace {

using Json = nlohmann::ordered_json;

Json bill(const cases::Census& n, const cases::Model& model) {
  Json out = Json::array();
  for (const cases::BillLine& line : n.bill) {
    const bool box = line.edges[0] > 0.0;
    out.push_back({{"material", nth(model.materials, line.material).name},
                   {"kind", cases::name(line.kind)},
                   {"whole", line.whole},
                   {"edges", box ? Json(line.edges) : Json(nullptr)},
                   {"count", line.count},
                   {"volume", line.volume}});
  }
  return out;
}

Json parts(const cases::Census& n) {
  Json out = Json::array();
  for (const cases::CensusGroup& g : n.groups)
    out.push_back({{"name", g.name}, {"whole", g.whole}, {"cut", g.cut}, {"volume", g.volume}, {"mass", g.mass}});
  return out;
}

}  // namespace

std::string check_json(const cases::Case& c, const cases::Model& model, const CheckFigures& figures) {
  const cases::Census& n = figures.census;
  Json out{{"title", c.title},
           {"elements", n.elements},
           {"joints", n.joints},
           {"base_joints", n.base_joints},
           {"volume", n.volume},
           {"mass", n.mass},
           {"step_bound", n.step_bound},
           {"step", figures.step},
           {"run_seconds", figures.run_seconds ? Json(*figures.run_seconds) : Json(nullptr)},
           {"parts", parts(n)},
           {"bill", bill(n, model)},
           {"faults", figures.faults},
           {"findings", figures.findings}};
  if (n.units > 0) out["units_in_cells"] = {{"units", n.units}, {"cells", n.cells}, {"joints", n.cell_joints}};
  return out.dump(1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace voussoir::io
