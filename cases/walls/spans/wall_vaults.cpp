// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/walls/spans/wall_vaults.h"

#include <algorithm>
#include <cmath>

#include "cases/house/house_parts.h"
#include "cases/names.h"
#include "cases/walls/spans/wall_bays.h"
#include "geometry/nth.h"

namespace voussoir::cases {
namespace {

std::string vault_key(std::size_t vault, const char* field = "") { return Spanning{"vault", vault}.key(field); }

/// A ring in the plane across the vault: joints are radial, feet level. The two halves are mirror images bit by bit.
class Ring {
 public:
  /// \param span  m, between the inner faces of the walls \param seat  m, height of their tops
  Ring(const WallVault& vault, std::size_t index, double span, double seat) : half_(0.5 * span), seat_(seat), voussoirs_(vault.voussoirs) {
    positive_length(vault.thickness, vault_key(index, "thickness")), positive_length(vault.ring, vault_key(index, "ring"));
    if (voussoirs_ < 3 || voussoirs_ > 1000)
      throw InputError(vault_key(index, "voussoirs"), std::to_string(voussoirs_) + " voussoirs in a ring; allowed: 3 to 1000");
    rise_ = vault.rise.value_or(half_);
    const double least = 0.05 * span;
    if (!(rise_ >= least && rise_ <= half_ + 1e-9))
      throw InputError(vault_key(index, "rise"), text(rise_) + " m over a span of " + text(std::round(span * 1e4) * 1e-4) +
                                                     " m; allowed: " + text(std::round(least * 1e4) * 1e-4) + " to " +
                                                     text(std::round(half_ * 1e4) * 1e-4) + " m");
    radius_ = (half_ * half_ + rise_ * rise_) / (2.0 * rise_), angle_ = 2.0 * std::atan2(rise_, half_), thickness_ = vault.thickness;
  }

  /// Width of a foot on its wall [m].
  [[nodiscard]] double foot() const noexcept { return thickness_ * std::sin(angle_); }
  /// The soffit, from wall to wall.
  [[nodiscard]] geometry::Polygon soffit() const {
    geometry::Polygon line;
    for (int k = 0; k <= voussoirs_; ++k) line.push_back(corner(k, 0.0));
    return line;
  }
  /// The section of a voussoir; corners in turn.
  [[nodiscard]] geometry::Polygon section(int k) const {
    geometry::Polygon p{corner(k, 0.0), corner(k + 1, 0.0), corner(k + 1, thickness_), corner(k, thickness_)};
    // The radial joint of a foot would stand on its edge: the foot goes down to the wall behind it.
    if (k == 0 && p[3].t > seat_ + kPlanTolerance) p.push_back({p[3].s, seat_});
    if (k + 1 == voussoirs_ && p[2].t > seat_ + kPlanTolerance) p.insert(p.begin() + 2, {p[2].s, seat_});
    return p;
  }
  /// Mean length of a voussoir along the ring [m].
  [[nodiscard]] double length() const noexcept { return 2.0 * angle_ * (radius_ + 0.5 * thickness_) / voussoirs_; }
  /// Length of the outer face over the area of the ring, feet included [1/m].
  [[nodiscard]] double face_over_area() const noexcept {
    const double half = angle_ / voussoirs_, outer = radius_ + thickness_;
    const double feet = thickness_ * thickness_ * std::sin(angle_) * std::max(0.0, std::cos(angle_));
    return voussoirs_ * 2.0 * outer * std::sin(half) /
           (voussoirs_ * std::sin(half) * std::cos(half) * (outer * outer - radius_ * radius_) + feet);
  }

 private:
  /// Joint k of the ring, `out` from the soffit.
  [[nodiscard]] geometry::Point2 corner(int k, double out) const noexcept {
    if (2 * k > voussoirs_) {
      const geometry::Point2 p = corner(voussoirs_ - k, out);
      return {2.0 * half_ - p.s, p.t};
    }
    const double a = angle_ * (1.0 - 2.0 * k / static_cast<double>(voussoirs_)), r = radius_ + out;
    if (k == 0 && out == 0.0) return {0.0, seat_};
    const bool level = k == 0 && rise_ > half_ - 1e-9;  // a half circle stands on its joint
    return {2 * k == voussoirs_ ? half_ : half_ - r * std::sin(a), level ? seat_ : seat_ + r * std::cos(a) - (radius_ - rise_)};
  }

  double half_, seat_, rise_ = 0.0, radius_ = 0.0, angle_ = 0.0, thickness_ = 0.0;  // m, rad
  int voussoirs_;
};

/// A vault over its bay.
struct LaidVault {
  LaidVault(const std::vector<WallSpec>& walls, const WallsPlan& plan, const WallVault& vault, std::size_t index)
      : axes(plan, plan.vaults[index]), ring(vault, index, axes.span(), metres(eaves(walls[plan.legs[axes.bay().faces[0].leg].wall]))) {
    for (const WallFace& face : axes.bay().faces) {
      const WallSpec& wall = walls[plan.legs[face.leg].wall];
      if (ring.foot() > wall.thickness + 1e-9)
        throw InputError(vault_key(index, "thickness"), text(vault.thickness) + " m makes feet of " +
                                                            text(std::round(ring.foot() * 1e4) * 1e-4) + " m, wider than the " +
                                                            plan.legs[face.leg].tag + ", " + text(wall.thickness) + " m");
    }
    element_length(vault.ring, ticks(axes.length()), vault_key(index, "ring"));
  }
  BayAxes axes;
  Ring ring;
};

std::string surcharged_name(const WallVault& vault) {
  return vault.material + " of vault " + vault.name + " with " + text(vault.surcharge) + " kg/m2";
}

}  // namespace

void plan_wall_vaults(const std::vector<WallSpec>& walls, const std::vector<WallVault>& vaults, WallsPlan& plan) {
  Faults faults;
  plan.vaults.resize(vaults.size());
  for (std::size_t i = 0; i < vaults.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (vaults[k].name == vaults[i].name)
        faults.add({vault_key(i, "name"), quoted(vaults[i].name) + " is already the name of " + vault_key(k)});
    }
    const bool lies = faults.attempt([&] {
      plan.vaults[i] = find_bay(walls, plan, {"vault", i}, vaults[i].walls, std::nullopt, {});
      reach_to_ends(plan, plan.vaults[i]);
      if (!vaults[i].corners.empty()) bound(plan, {"vault", i}, vaults[i].corners, 0.0, plan.vaults[i]);
      check_level_pair(walls, plan, {"vault", i}, plan.vaults[i],
                       {"a barrel vault spans between two that are", "the feet of a barrel vault rest at one height"});
      LaidVault(walls, plan, vaults[i], i);
    });
    for (std::size_t g = 0; lies && g < vaults[i].gables.size(); ++g) {
      faults.attempt([&] {
        const LaidVault laid(walls, plan, vaults[i], i);
        raise_to(walls, vaults[i].gables[g], indexed_key(vault_key(i, "gables"), g, ""), laid.axes, laid.ring.soffit(), {"vault", i}, plan);
      });
    }
  }
  faults.raise();
}

std::vector<NamedMaterial> loaded_vault_materials(const std::vector<WallSpec>& walls, const WallsPlan& plan,
                                                  const std::vector<WallVault>& vaults, std::span<const NamedMaterial> materials) {
  std::vector<NamedMaterial> all;
  for (std::size_t i = 0; i < vaults.size(); ++i) {
    if (vaults[i].surcharge == 0.0) continue;
    const std::int32_t bare = find_material(materials, vaults[i].material, vault_key(i, "material"));
    all.push_back({surcharged_name(vaults[i]), nth(materials, bare).value, bare});
    all.back().value.density += vaults[i].surcharge * LaidVault(walls, plan, vaults[i], i).ring.face_over_area();
  }
  return all;
}

void add_vault_rings(const std::vector<WallSpec>& walls, const WallsPlan& plan, const std::vector<WallVault>& vaults,
                     std::span<const NamedMaterial> materials, std::vector<Block>& blocks) {
  for (std::size_t i = 0; i < vaults.size(); ++i) {
    const WallVault& vault = vaults[i];
    const LaidVault laid(walls, plan, vault, i);
    Block block;
    block.kind = PartKind::voussoir;
    block.vault = static_cast<std::int32_t>(i);
    block.material = vault.surcharge > 0.0 ? find_material(materials, surcharged_name(vault), vault_key(i, "surcharge"))
                                           : find_material(materials, vault.material, vault_key(i, "material"));
    const Tick length = ticks(laid.axes.length()), ring = ticks(vault.ring);
    block.segment_size = 0.25 * std::min({laid.ring.length(), vault.thickness, metres(std::min(ring, length))});
    int number = 0;
    for (const Interval x : cut_member({0, length}, ring)) {
      block.tag = vault.name + " ring " + std::to_string(number++);
      block.whole = x.length() == ring;
      for (int k = 0; k < vault.voussoirs; ++k) {
        std::vector<std::array<double, 2>> corners;
        for (const geometry::Point2 p : laid.ring.section(k)) corners.push_back({p.s, p.t});
        block.shape = laid.axes.in_case(geometry::make_prism(corners, metres(x.low), metres(x.high)));
        blocks.push_back(block);
      }
    }
  }
}

}  // namespace voussoir::cases
