// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/session/tie_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace voussoir::io {

namespace {

constexpr std::size_t kMostLines = 20;  // of single ties: a mesh has thousands

void print_rest(std::size_t all) {
  if (all > kMostLines) std::printf("%20s ... and %zu more\n", "", all - kMostLines);
}

}  // namespace

void print_ties(const cases::Model& model) {
  for (std::size_t i = 0; i < std::min(model.ties.size(), kMostLines); ++i) {
    const cases::TieBar& t = model.ties[i];
    std::printf("%-24s %s: %.3f m, %.3g N/m, holds %zu and %zu elements", i == 0 ? "ties" : "", t.name.c_str(), t.length, t.stiffness,
                t.ends[0].size(), t.ends[1].size());
    if (std::isfinite(t.yield)) std::printf(", yields at %.3g kN", 1e-3 * t.yield);
    std::printf("\n");
  }
  print_rest(model.ties.size());
}

void print_bounded_ties(const solver::Ties& ties, const cases::Model& model) {
  std::size_t bounded = 0;
  for (std::size_t i = 0; i < ties.tie.size(); ++i) {
    const solver::Ties::Tie& t = ties.tie[i];
    if (t.law.stiffness == t.wanted || ++bounded > kMostLines) continue;
    std::fprintf(stderr, "voussoir: warning: tie \"%s\" has a stiffness of %.3g N/m; E A / length is %.3g N/m, more than the step bears\n",
                 model.ties[i].name.c_str(), t.law.stiffness, t.wanted);
  }
  if (bounded > kMostLines) std::fprintf(stderr, "voussoir: warning: so have %zu more ties\n", bounded - kMostLines);
}

void print_tie_outcome(const solver::Ties& ties, const cases::Model& model) {
  if (ties.state.empty()) return;
  const auto broken = std::ranges::count_if(ties.state, [](const kernels::TieState& s) { return s.broken != 0; });
  const auto yielded = std::ranges::count_if(ties.state, [](const kernels::TieState& s) { return s.broken == 0 && s.plastic != 0.0; });
  std::printf("ties                 %zu: %td have yielded, %td are broken\n", ties.state.size(), yielded, broken);
  for (std::size_t i = 0; i < std::min(ties.state.size(), kMostLines); ++i) {
    const kernels::TieState& s = ties.state[i];
    std::printf("%20s %s: %s", "", model.ties[i].name.c_str(), s.broken != 0 ? "broken" : "");
    if (s.broken == 0) std::printf("%.3g kN, plastic elongation %.3g mm", 1e-3 * s.force, 1e3 * s.plastic);
    std::printf("\n");
  }
  print_rest(ties.state.size());
}

}  // namespace voussoir::io
