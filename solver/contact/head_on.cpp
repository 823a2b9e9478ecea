// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/contact/head_on.h"

#include <algorithm>
#include <cmath>

#include "cases/model.h"

namespace voussoir::solver {

namespace {

constexpr int kInstants = 16;           // of contact, evenly over a step
constexpr int kMostSteps = 10'000'000;  // of a contact: ends one that never parts

/// Speed of parting [m/s] after an impact at 1 m/s. \param inside  penetration at the end of the step of contact, over the path of a step
double once(const HeadOn& h, double inside) noexcept {
  double u = inside * h.step, v = -1.0;  // m and m/s, of the gap
  for (int i = 0; i < kMostSteps; ++i) {
    u += h.step * v;
    if (u >= 0.0) {
      if (v > 0.0) return v;
      continue;
    }
    const double spring = h.stiffness * u, dash = h.dashpot * v;
    v -= 2.0 * h.step / h.mass * (spring + (h.bounded ? std::min(dash, -spring) : dash));  // both bodies are pushed
  }
  return 0.0;
}

}  // namespace

HeadOn head_on(const World& w, std::int32_t element, std::int32_t face) {
  const auto e = static_cast<std::size_t>(element), f = static_cast<std::size_t>(w.elements.first_face[e] + face);
  const kernels::Face& own = w.faces[f];
  HeadOn h;
  h.mass = w.elements.mass[e] / w.model.assembly.faces[f].area;
  h.stiffness = 1.0 / (2.0 * own.compliance_n);
  h.dashpot = 2.0 * w.contact.damping * std::sqrt(2.0 * own.mass * h.stiffness) / (1.0 + w.dt * 2.0 * w.dashpot_bounds.face[f]);
  h.step = w.dt;
  h.bounded = w.contact.dashpot_excess == kernels::kBounded;
  return h;
}

double restitution_of(const HeadOn& h) noexcept {
  double sum = 0.0;
  for (int k = 0; k < kInstants; ++k) sum += once(h, (k + 0.5) / kInstants);
  return sum / kInstants;
}

}  // namespace voussoir::solver
