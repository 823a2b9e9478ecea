// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/world/travel.h"

#include <algorithm>

#include "solver/world/world.h"

namespace voussoir::solver {

namespace {

constexpr double kLook = -1.0;  // m, below every bound: the displacement is computed in the next step

std::size_t batch_of(std::int32_t element) { return static_cast<std::size_t>(element / kernels::kBatch); }

}  // namespace

Travel::Travel(const Elements& e, double skin, double ahead) : skin_(skin), ahead_(ahead) {
  const std::size_t rows = e.ux.size(), batches = rows / kernels::kBatch;
  reach_.assign(rows, 0.5 * skin);
  for (Array<double>* a : {&bound_, &safe_}) a->assign(rows, 0.0);
  for (Array<double>* a : {&batch_bound_, &batch_safe_, &largest_radius_}) a->assign(batches, 0.0);
  active_.assign(batches, 0);
  for (std::size_t i = 0; i < rows; ++i) {
    double& largest = largest_radius_[i / kernels::kBatch];
    largest = std::max(largest, e.radius[i]);
  }
}

kernels::SearchedPoses Travel::searched_poses(const Elements& e) const noexcept {
  return {ux_.data(), uy_.data(), uz_.data(), qw_.data(), qx_.data(), qy_.data(), qz_.data(), e.radius.data()};
}

double Travel::displacement(Elements& e, std::int32_t element) const noexcept {
  return kernels::displacement_since_search(e.view(), searched_poses(e), element);
}

double Travel::displacement_over_limit(Elements& e, std::int32_t element) const noexcept {
  if (!is_searched()) return 0.0;
  const double moved = displacement(e, element);
  return moved > reach(element) - margin_ ? moved : 0.0;
}

Travel::Pose Travel::searched_pose(std::int32_t element) const noexcept {
  const auto i = static_cast<std::size_t>(element);
  return {{ux_[i], uy_[i], uz_[i]}, rotation({qw_[i], qx_[i], qy_[i], qz_[i]})};
}

void Travel::remember(const Elements& e, std::int32_t element) noexcept {
  const auto i = static_cast<std::size_t>(element);
  ux_[i] = e.ux[i], uy_[i] = e.uy[i], uz_[i] = e.uz[i];
  qw_[i] = e.qw[i], qx_[i] = e.qx[i], qy_[i] = e.qy[i], qz_[i] = e.qz[i];
  bound_[i] = safe_[i] = 0.0;
  if (!looks_ahead()) return;
  const double speed = norm(Vec3{e.vx[i], e.vy[i], e.vz[i]}) + norm(Vec3{e.wx[i], e.wy[i], e.wz[i]}) * e.radius[i];
  reach_[i] = std::max(0.5 * skin_, std::min(kFarthest, ahead_ * speed));
}

void Travel::remember_all(const Elements& e) {
  for (Array<double>* a : state().poses) a->resize(e.ux.size());
  for (std::size_t i = 0; i < e.ux.size(); ++i) remember(e, static_cast<std::int32_t>(i));
}

kernels::TravelView Travel::view(const Elements& e, double dt) noexcept {
  return {.at = searched_poses(e),
          .dt = dt,
          .reach = reach_.data(),
          .margin = margin_,
          .element = {bound_.data(), safe_.data()},
          .active = active_.data(),
          .batch = {batch_bound_.data(), batch_safe_.data()},
          .largest_radius = largest_radius_.data()};
}

void Travel::activate_at_next_drift(std::int32_t element) noexcept {
  if (is_active(element)) return;
  const std::size_t batch = batch_of(element);
  active_[batch] = 1;
  std::fill_n(safe_.begin() + static_cast<std::ptrdiff_t>(batch * kernels::kBatch), kernels::kBatch, kLook);
}

void Travel::activate(Elements& e, std::int32_t element) noexcept {
  if (is_active(element)) return;
  const std::int32_t first = element / kernels::kBatch * kernels::kBatch;
  for (std::int32_t i = first; i < first + kernels::kBatch; ++i) e.store_velocity_row(i);
  activate_at_next_drift(element);
}

void Travel::ask_for_search(std::int32_t steps) noexcept {
  if (countdown_ == 0) countdown_ = steps;
}

bool Travel::search_due(double displacement) noexcept {
  const bool asked_for = countdown_ > 0 && --countdown_ == 0;
  return !is_searched() || asked_for || displacement > 0.0;
}

Travel::State Travel::state() noexcept { return {{&ux_, &uy_, &uz_, &qw_, &qx_, &qy_, &qz_}, &reach_, &due_at_once_, &countdown_}; }

void Travel::restart(std::size_t poses) {
  for (Array<double>* a : state().poses) a->assign(poses, 0.0);
  for (Array<double>* a : {&bound_, &safe_, &batch_bound_, &batch_safe_}) std::ranges::fill(*a, 0.0);
}

std::size_t Travel::bytes() const noexcept {
  std::size_t numbers = 0;
  for (const Array<double>* a :
       {&ux_, &uy_, &uz_, &qw_, &qx_, &qy_, &qz_, &reach_, &bound_, &safe_, &batch_bound_, &batch_safe_, &largest_radius_}) {
    numbers += a->size();
  }
  return numbers * sizeof(double) + active_.size();
}

}  // namespace voussoir::solver
