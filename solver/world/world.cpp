// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/world/world.h"

#include "geometry/nth.h"

namespace voussoir::solver {

World::World(const cases::Model& m) : model(m) {}
World::~World() = default;

kernels::ElementsView Elements::view() noexcept {
  const bool own = !inert.any();  // else those of a relaxation
  const double* round = inert.inv_inertia.data();
  const double* products = inert.zeros.data();
  return {.ux = ux.data(),
          .uy = uy.data(),
          .uz = uz.data(),
          .qw = qw.data(),
          .qx = qx.data(),
          .qy = qy.data(),
          .qz = qz.data(),
          .vx = vx.data(),
          .vy = vy.data(),
          .vz = vz.data(),
          .lx = lx.data(),
          .ly = ly.data(),
          .lz = lz.data(),
          .wx = wx.data(),
          .wy = wy.data(),
          .wz = wz.data(),
          .tally = tally.data(),
          .mass = mass.data(),
          .inert_mass = inert_mass().data(),
          .inv_mass = inert_inv_mass().data(),
          .alpha = alpha.data(),
          .ixx = own ? ixx.data() : round,
          .iyy = own ? iyy.data() : round,
          .izz = own ? izz.data() : round,
          .ixy = own ? ixy.data() : products,
          .ixz = own ? ixz.data() : products,
          .iyz = own ? iyz.data() : products,
          .principal = own ? principal.data() : inert.principal.data()};
}

void Elements::store_velocity_row(std::int32_t element) noexcept {
  const auto i = static_cast<std::size_t>(element);
  kernels::store_twist(twist.data(), element, {{vx[i], vy[i], vz[i]}, {wx[i], wy[i], wz[i]}});
}

void Elements::store_velocity_rows() noexcept {
  for (std::int32_t i = 0; i < count; ++i) store_velocity_row(i);
}

kernels::ElementRows World::element_rows() noexcept {
  Elements& e = elements;
  return {e.pose.data(), e.twist.data(), e.wrench.data(), e.dashpot.data(), travel.active().data(), out_of_cache};
}

const double* World::twist_rows(int level) const noexcept {
  return level == 0 ? elements.twist.data() : multirate.rows[static_cast<std::size_t>(level) - 1].twist.data();
}

kernels::Bodies World::bodies(int level) const noexcept {
  return {elements.pose.data(), twist_rows(level), elements.body.data(), travel.bounds()};
}

kernels::ContactOptions World::contact_of(int level) const noexcept {
  kernels::ContactOptions o = contact;
  o.step = step_of(level);
  return o;
}

kernels::PointsView PointSets::view(std::int32_t set) const noexcept {
  const auto i = static_cast<std::size_t>(set);
  const auto at = static_cast<std::size_t>(first[i]);
  return {s.data() + at, t.data() + at, area.data() + at, count[i]};
}

kernels::Rows World::rows(int level) noexcept {
  kernels::PairForces pairs;
  if (keep_pairs) pairs = {sides.pair_wrench.data(), sides.pair_on.data()};
  if (level == 0) return {elements.pose.data(), elements.twist.data(), elements.wrench.data(), elements.dashpot.data(), pairs};
  Multirate::Rows& of_level = multirate.rows[static_cast<std::size_t>(level) - 1];
  return {elements.pose.data(), of_level.twist.data(), of_level.wrench.data(), of_level.dashpot.data(), pairs};
}

void ByLevel::sort(const std::vector<std::uint8_t>& level, int levels) {
  list.clear(), end.clear();
  for (int l = 0; l < levels; ++l) {
    for (std::size_t i = 0; i < level.size(); ++i) {
      if (level[i] == l) list.push_back(static_cast<std::int32_t>(i));
    }
    end.push_back(static_cast<std::int64_t>(list.size()));
  }
}

kernels::Side Sides::side(std::int64_t id) const noexcept {
  const auto i = static_cast<std::size_t>(id);
  kernels::Side side = kernels::side_of(blocks[i / kernels::kLanes], static_cast<int>(i % kernels::kLanes), parts[i]);
  side.laws = &laws_of(i);
  return side;
}

const ZeroArray<double>* Sides::state_of_law(std::string_view name) const noexcept {
  for (const LawState& s : law_state) {
    if (s.name == name) return &s.values;
  }
  return nullptr;
}

kernels::ContactPoints Patches::points(std::int64_t p) noexcept {
  const auto at = static_cast<std::size_t>(nth(patch, p).first_point);
  const auto optional = [&](Array<double>& x) { return x.size() == 0 ? nullptr : x.data() + at; };
  return {partner.data() + at, face.data() + at, springs.data() + at / kernels::kWidth, optional(crushed), optional(pressed)};
}

}  // namespace voussoir::solver
