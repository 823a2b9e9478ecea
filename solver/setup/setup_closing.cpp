// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/setup/setup.h"

namespace voussoir::solver {

void set_up_closing(World& w) {
  Sides& s = w.sides;
  for (std::size_t id = 0; id < s.joint.size(); ++id) {
    if (s.joint[id] < 0) continue;
    const auto law_index = static_cast<std::size_t>(w.model.joint_law[static_cast<std::size_t>(s.joint[id])]);
    const cases::JointLaw& law = w.model.laws[law_index].value;
    if (!law.stiffens()) continue;
    if (s.closing.empty()) s.closing.resize(s.joint.size());
    const double compliance =  // m/Pa; none of the base
        w.faces[static_cast<std::size_t>(s.master_face[id])].compliance_n +
        w.faces[static_cast<std::size_t>(s.slave_face[id])].compliance_n;
    s.closing[id] = {.most = *law.maximum_closure, .scale = *law.normal_stiffness * *law.maximum_closure, .blocks = 1.0 / compliance};
  }
}

}  // namespace voussoir::solver
