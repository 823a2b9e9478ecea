// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/session/words/tie_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>
#include <string>

#include "cases/model.h"
#include "cases/ties/ties.h"
#include "geometry/message.h"
#include "io/app/session/progress.h"
#include "io/input/messages/messages.h"

namespace voussoir::io {

namespace {

constexpr std::size_t kMostLines = 10;  // single ties that are printed: a mesh has thousands

void print_rest(std::size_t all) {
  if (all > kMostLines) std::printf("%20s ... and %zu more\n", "", all - kMostLines);
}

/// "ties 4: none has yielded, 1 is broken" of the bars from `first` to before `last`.
void print_counts(const std::string& name, const solver::Ties& ties, std::size_t first, std::size_t last) {
  const std::span states = std::span(ties.state).subspan(first, last - first);
  const auto broken = std::ranges::count_if(states, [](const kernels::TieState& s) { return s.broken != 0; });
  const auto yielded = std::ranges::count_if(states, [](const kernels::TieState& s) { return s.broken == 0 && s.plastic != 0.0; });
  std::printf("%-20s %zu: %td have yielded, %td are broken\n", name.c_str(), states.size(), yielded, broken);
}

}  // namespace

void print_ties(const cases::Model& model) {
  const std::size_t own = cases::own_ties(model);
  for (std::size_t i = 0; i < std::min(own, kMostLines); ++i) {
    const cases::TieBar& t = model.ties[i];
    std::printf("%-24s %s: %.3f m, %.3g N/m, anchored in %zu and %zu elements", i == 0 ? "ties" : "", t.name.c_str(), t.length, t.stiffness,
                t.ends[0].size(), t.ends[1].size());
    if (std::isfinite(t.yield)) std::printf(", yields at %.3g kN", 1e-3 * t.yield);
    std::printf("\n");
  }
  print_rest(own);
}

void print_tie_bill(const cases::Model& model) {
  if (model.tie_bill.empty()) return;
  std::printf("\n%-52s %10s %12s %12s %10s\n", "bill of ties", "count", "rod [m]", "surface [m2]", "anchors");
  for (const cases::TieBill& b : model.tie_bill) {
    std::printf("%-52s %10s %12.2f %12.2f %10s\n", b.name.c_str(), format_count(b.ties).c_str(), b.length, b.area,
                format_count(b.anchors).c_str());
  }
}

void print_bounded_ties(const solver::Ties& ties, const cases::Model& model) {
  std::size_t bounded = 0;
  double least = 1.0;
  for (std::size_t i = 0; i < ties.tie.size(); ++i) {
    const solver::Ties::Tie& t = ties.tie[i];
    if (t.law.stiffness == t.wanted) continue;
    least = std::min(least, t.law.stiffness / t.wanted);
    if (++bounded > kMostLines) continue;
    say_warning(geometry::printed("tie \"%s\" has a stiffness of %.3g N/m; E A / length is %.3g N/m, more than the step bears",
                                  model.ties[i].name.c_str(), t.law.stiffness, t.wanted));
  }
  if (bounded > kMostLines)
    say_warning(geometry::printed("so have %zu more ties, of %zu; the least has %.3g of E A / length", bounded - kMostLines,
                                  ties.tie.size(), least));
}

void print_tie_outcome(const solver::Ties& ties, const cases::Model& model) {
  if (ties.state.empty()) return;
  const std::size_t own = cases::own_ties(model);
  if (own > 0) print_counts("ties", ties, 0, own);
  for (std::size_t i = 0; i < std::min(own, kMostLines); ++i) {
    const kernels::TieState& s = ties.state[i];
    std::printf("%20s %s: %s", "", model.ties[i].name.c_str(), s.broken != 0 ? "broken" : "");
    if (s.broken == 0) std::printf("%.3g kN, plastic elongation %.3g mm", 1e-3 * s.force, 1e3 * s.plastic);
    std::printf("\n");
  }
  print_rest(own);
  for (const cases::TieGroup& g : cases::tie_groups(model)) print_counts(g.name, ties, g.first, g.last);
}

}  // namespace voussoir::io
