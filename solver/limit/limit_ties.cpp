// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/limit/limit_ties.h"

#include <algorithm>
#include <cstddef>

#include "cases/model.h"
#include "geometry/nth.h"
#include "solver/limit/contacts.h"

namespace voussoir::solver {
namespace {

Vec3 middle(const std::vector<LimitTie::Hold>& end) {
  Vec3 at;
  for (const LimitTie::Hold& h : end) at += h.share * h.at;
  return at;
}

/// Whether all holds are of one body, so that the tie can do nothing.
bool holds_one_body(const LimitTie& tie) {
  const std::int32_t first = tie.ends[0].front().body;
  return std::ranges::all_of(tie.ends, [&](const auto& end) { return std::ranges::all_of(end, [&](const auto& h) { return h.body == first; }); });
}

Vec3 speed(const LimitTie::Hold& h, const LimitContacts& contacts, const std::vector<kernels::Twist>& motion) {
  if (h.body < 0) return {};
  const kernels::Twist& m = nth(motion, h.body);
  return m.v + cross(m.w, h.at - nth(contacts.bodies, h.body).centre);
}

}  // namespace

std::vector<LimitTie> limit_ties(const cases::Model& model, const std::vector<std::int32_t>& body_of) {
  std::vector<LimitTie> all;
  for (std::size_t i = 0; i < model.ties.size(); ++i) {
    const cases::TieBar& bar = model.ties[i];
    LimitTie tie;
    tie.number = static_cast<std::int32_t>(i);
    for (std::size_t k = 0; k < 2; ++k)
      for (const cases::TieHold& h : bar.ends[k])
        tie.ends[k].push_back({h.element == geometry::kBase ? -1 : nth(body_of, h.element), h.share, h.point});
    if (holds_one_body(tie)) continue;
    tie.along = normalised(middle(tie.ends[1]) - middle(tie.ends[0]));
    tie.most = bar.yield;
    tie.least = bar.compression ? -bar.yield : 0.0;
    all.push_back(std::move(tie));
  }
  return all;
}

std::vector<TiePull> pulls_of(const LimitTie& tie, const LimitContacts& contacts) {
  std::vector<TiePull> all;
  for (std::size_t k = 0; k < 2; ++k) {
    for (const LimitTie::Hold& h : tie.ends[k]) {
      if (h.body < 0) continue;
      const Vec3 force = (k == 0 ? h.share : -h.share) * tie.along;
      auto pull = std::ranges::find(all, h.body, &TiePull::body);
      if (pull == all.end()) pull = all.insert(all.end(), TiePull{h.body, {}, {}});
      pull->force += force;
      pull->moment += cross(h.at - nth(contacts.bodies, h.body).centre, force);
    }
  }
  return all;
}

double stretching(const LimitTie& tie, const LimitContacts& contacts, const std::vector<kernels::Twist>& motion) {
  Vec3 apart;
  for (const LimitTie::Hold& h : tie.ends[1]) apart += h.share * speed(h, contacts, motion);
  for (const LimitTie::Hold& h : tie.ends[0]) apart -= h.share * speed(h, contacts, motion);
  return dot(apart, tie.along);
}

}  // namespace voussoir::solver
