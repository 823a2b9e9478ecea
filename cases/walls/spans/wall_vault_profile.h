// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "cases/walls/wall_case.h"
#include "geometry/polygon.h"

/// The section of a vault across its courses. Internal to cases/.
namespace voussoir::cases {

/// "vault[1].rise".
std::string vault_key(std::size_t vault, const char* field = "");

/// An arch of two parallel circles from wall to wall: joints are radial, feet level. The two halves are mirror images bit by bit. Its
/// points: s from the inner face of the first wall, t above the base [m].
class VaultProfile {
 public:
  /// \param span  m, between the inner faces of the walls \param seat  m, height of their tops \throw InputError
  VaultProfile(const WallVault& vault, std::size_t index, double span, double seat);

  /// Voussoirs from the first wall to the middle, without one in it.
  [[nodiscard]] int courses() const noexcept { return voussoirs_ / 2; }
  [[nodiscard]] double seat() const noexcept { return seat_; }
  [[nodiscard]] double half() const noexcept { return half_; }
  /// Width of a foot on its wall [m].
  [[nodiscard]] double foot() const noexcept;
  /// The soffit, from wall to wall.
  [[nodiscard]] geometry::Polygon soffit() const;
  /// The section of a voussoir; corners in turn: soffit, joint, outer face, joint.
  [[nodiscard]] geometry::Polygon section(int k) const;
  /// Mean length of a voussoir along the arch [m].
  [[nodiscard]] double length() const noexcept;
  /// Length of the outer face over the area of the arch, feet included [1/m].
  [[nodiscard]] double face_over_area() const noexcept;

 private:
  /// Joint k of the arch, `out` from the soffit.
  [[nodiscard]] geometry::Point2 corner(int k, double out) const noexcept;
  /// The angle of joint k from the middle [rad]. \pre it is not behind the middle
  [[nodiscard]] double angle_of(int k) const noexcept;

  double half_, seat_, rise_ = 0.0, radius_ = 0.0, angle_ = 0.0, thickness_ = 0.0;  // m, rad
  double open_ = 0.0;                                                               // rad, from the middle to the rim of an opening
  int voussoirs_;
};

}  // namespace voussoir::cases
