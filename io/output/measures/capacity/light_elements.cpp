// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/capacity/light_elements.h"

#include <array>
#include <cstdio>

#include "cases/case.h"
#include "cases/model.h"

namespace voussoir::io {

std::string light_elements_warning(const solver::World& world, const cases::Case& c) {
  const cases::Analysis& analysis = c.analysis;
  if (!cases::finds_rest(analysis) || c.gravity.acceleration == Vec3{}) return "";
  const solver::Elements& e = world.elements;
  double all = 0.0, count = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(e.count); ++i) {
    if (!e.fixed[i]) all += e.mass[i], count += 1.0;
  }
  const double mean = all / count;
  std::int64_t light = 0;
  std::size_t lightest = 0;
  double least = mean;
  for (std::size_t i = 0; i < static_cast<std::size_t>(e.count); ++i) {
    if (e.fixed[i]) continue;
    if (e.mass[i] < analysis.tolerance * mean) ++light;
    if (e.mass[i] < least) least = e.mass[i], lightest = i;
  }
  if (light == 0) return "";
  std::array<char, 400> text{};
  std::snprintf(
      text.data(), text.size(),
      "analysis.tolerance = %g: %lld element%s less than this share of the mean weight of an element, so a state counts as one of "
      "rest though one of them falls alone. The lightest, %s, has %.2g of the mean: %.0e would show it within 1 %%",
      analysis.tolerance, static_cast<long long>(light), light == 1 ? " weighs" : "s weigh",
      cases::describe(world.model.blocks[lightest], lightest).c_str(), least / mean, 0.01 * least / mean);
  return text.data();
}

}  // namespace voussoir::io
