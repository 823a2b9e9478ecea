// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/walls/spans/wall_vault_profile.h"

#include <algorithm>
#include <cmath>

#include "cases/house/house_plan.h"
#include "cases/input_error.h"
#include "cases/names.h"
#include "cases/walls/spans/wall_bays.h"

namespace voussoir::cases {
namespace {

void check_range(double value, double least, double most, double span, const std::string& key) {
  if (value >= least && value <= most + 1e-9) return;
  const auto shown = [](double m) { return text(std::round(m * 1e4) * 1e-4); };
  throw InputError(key, text(value) + " m over a span of " + shown(span) + " m; allowed: " + shown(least) + " to " + shown(most) + " m");
}

}  // namespace

std::string vault_key(std::size_t vault, const char* field) { return Spanning{"vault", vault}.key(field); }

VaultProfile::VaultProfile(const WallVault& vault, std::size_t index, double span, double seat)
    : half_(0.5 * span), seat_(seat), voussoirs_(vault.voussoirs) {
  positive_length(vault.thickness, vault_key(index, "thickness")), positive_length(vault.ring, vault_key(index, "ring"));
  if (voussoirs_ < 3 || voussoirs_ > 1000)
    throw InputError(vault_key(index, "voussoirs"), std::to_string(voussoirs_) + " voussoirs in a ring; allowed: 3 to 1000");
  rise_ = vault.rise.value_or(half_);
  check_range(rise_, 0.05 * span, half_, span, vault_key(index, "rise"));
  radius_ = (half_ * half_ + rise_ * rise_) / (2.0 * rise_), angle_ = 2.0 * std::atan2(rise_, half_), thickness_ = vault.thickness;
  if (!vault.oculus) return;
  check_range(*vault.oculus, 0.05 * span, 0.5 * span, span, vault_key(index, "oculus"));
  open_ = std::asin(0.5 * *vault.oculus / radius_);
}

double VaultProfile::foot() const noexcept { return thickness_ * std::sin(angle_); }

geometry::Polygon VaultProfile::soffit() const {
  geometry::Polygon line;
  for (int k = 0; k <= voussoirs_; ++k) line.push_back(corner(k, 0.0));
  return line;
}

geometry::Polygon VaultProfile::section(int k) const {
  geometry::Polygon p{corner(k, 0.0), corner(k + 1, 0.0), corner(k + 1, thickness_), corner(k, thickness_)};
  // The radial joint of a foot would stand on its edge: the foot goes down to the wall behind it.
  if (k == 0 && p[3].t > seat_ + kPlanTolerance) p.push_back({p[3].s, seat_});
  if (k + 1 == voussoirs_ && p[2].t > seat_ + kPlanTolerance) p.insert(p.begin() + 2, {p[2].s, seat_});
  return p;
}

double VaultProfile::length() const noexcept { return 2.0 * angle_ * (radius_ + 0.5 * thickness_) / voussoirs_; }

double VaultProfile::face_over_area() const noexcept {
  const double half = angle_ / voussoirs_, outer = radius_ + thickness_;
  const double feet = thickness_ * thickness_ * std::sin(angle_) * std::max(0.0, std::cos(angle_));
  return voussoirs_ * 2.0 * outer * std::sin(half) /
         (voussoirs_ * std::sin(half) * std::cos(half) * (outer * outer - radius_ * radius_) + feet);
}

double VaultProfile::angle_of(int k) const noexcept {
  if (open_ > 0.0) return angle_ + (open_ - angle_) * k / courses();
  return angle_ * (1.0 - 2.0 * k / static_cast<double>(voussoirs_));
}

geometry::Point2 VaultProfile::corner(int k, double out) const noexcept {
  if (2 * k > voussoirs_) {
    const geometry::Point2 p = corner(voussoirs_ - k, out);
    return {2.0 * half_ - p.s, p.t};
  }
  const double a = angle_of(k), r = radius_ + out;
  if (k == 0 && out == 0.0) return {0.0, seat_};
  const bool level = k == 0 && rise_ > half_ - 1e-9;  // a half circle stands on its joint
  return {2 * k == voussoirs_ ? half_ : half_ - r * std::sin(a), level ? seat_ : seat_ + r * std::cos(a) - (radius_ - rise_)};
}

}  // namespace voussoir::cases
