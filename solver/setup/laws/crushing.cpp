// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <string>

#include "cases/case.h"
#include "cases/names.h"
#include "geometry/message.h"
#include "kernels/laws/closing.h"
#include "solver/setup/laws/optional_laws.h"
#include "solver/setup/setup.h"

namespace voussoir::solver {

namespace {

/// Pa/m, of the softest contact that the model can have: of its joints, and of any two faces.
/// \param pressure  Pa, the least at which it softens
double least_stiffness(const World& w, double pressure) {
  double least = std::numeric_limits<double>::infinity(), softest = 0.0;
  each_side(w.sides, [&](std::size_t id) {
    const kernels::Closing& closing = w.sides.laws_of(id).closing;
    least = std::min(least, closing.on() ? kernels::stiffness_at(pressure, closing) : w.sides.side(static_cast<std::int64_t>(id)).k.kn);
  });
  for (const kernels::Face& f : w.faces) softest = std::max(softest, f.compliance_n);
  return softest > 0.0 ? std::min(least, 0.5 / softest) : least;
}

/// Strength must fall no faster than the springs of a contact unload, or it would snap through.
void refuse_snap_through(const World& w, const cases::Contact& c) {
  const double fall = c.compression - c.residual_compression, least = 0.5 * fall * fall / least_stiffness(w, c.residual_compression);
  if (c.crushing_energy == 0.0 || c.crushing_energy > least) return;
  throw cases::InputError(
      "contact.crushing_energy",
      "= " + geometry::short_figure(c.crushing_energy) +
          " J/m2 is no more than (compression - residual_compression)^2 / (2 x stiffness) = " + geometry::short_figure(least) +
          " J/m2 in the softest contact of this model: it would snap through; allowed: 0 (no softening), or more "
          "than that");
}

constexpr const char* kCrushed = "segment_crushed";  // by segment

void set_up(World& w, const cases::Case& c) {
  if (!w.contact.crushing.on()) return;
  refuse_snap_through(w, c.contact);
  Sides& s = w.sides;
  double* crushed = keep(s, {.name = kCrushed, .unit = "m", .shape = "segment", .values = {}}, s.bond.size());
  each_side(s, [&](std::size_t id) {
    kernels::SideLaws& laws = own_laws(s, id);
    laws.crushing = &w.contact.crushing;
    laws.crushed = crushed + (s.parts[id].segments.bond - s.bond.data());
  });
}

std::vector<double> numbers(const World& w) {
  const kernels::Crushing& c = w.contact.crushing;
  if (!c.on()) return {};
  return {c.strength, c.residual, c.slope, c.depth};
}

std::vector<std::string> words(const cases::Case& c, const cases::Model& /*m*/) {
  const cases::Contact& a = c.contact;
  if (a.compression == 0.0) return {};
  std::string text = "of contacts: " + cases::text(a.compression) + " Pa";
  if (a.crushing_energy > 0.0)
    text += ", " + cases::text(a.crushing_energy) + " J/m2 down to " + cases::text(a.residual_compression) + " Pa";
  return {text + ", by " + cases::text(a.crushing_depth) + " m at most"};
}

void example(cases::Case& c, cases::JointLaw& /*law*/) {
  c.contact.compression = 2e4, c.contact.residual_compression = 4e3, c.contact.crushing_energy = 2.0, c.contact.crushing_depth = 2e-3;
}

}  // namespace

kernels::Crushing crushing_of(const cases::Contact& c) {
  const double fall = c.compression - c.residual_compression;
  return {.strength = c.compression,
          .residual = c.residual_compression,
          .slope = c.crushing_energy > 0.0 ? 0.5 * fall * fall / c.crushing_energy : 0.0,
          .depth = c.crushing_depth};
}

OptionalLaw crushing_law() {
  return {.name = "crushing", .place = 3, .set_up = set_up, .numbers = numbers, .words = words, .example = example};
}

}  // namespace voussoir::solver
