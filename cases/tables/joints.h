// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

/// Tables of the case file about joints as a whole: [scatter], [failure] and [joints].
namespace voussoir::cases {

/// Random strength of joints: one factor per joint on f_t, c and f_m of its law (cases/rules/scatter.h).
enum class Distribution { lognormal, normal, uniform };
struct Scatter {
  int seed = 0;
  double variation = 0.0;  // coefficient of variation; 0: none
  Distribution distribution = Distribution::lognormal;
  std::vector<std::string> laws;  // names of joint_laws; empty: all
};

enum class PostShear { plastic, brittle };
enum class ShearInTension { cohesion, none, coulomb };
struct Failure {
  bool shear = true;  // "on" | "off"
  PostShear post_shear = PostShear::plastic;
  ShearInTension shear_in_tension = ShearInTension::cohesion;
};

struct JointRule {
  std::array<std::string, 2> materials;  // "base" counts as a material
  std::string law;                       // name in joint_laws, or "dry"
};
struct Joints {
  std::string default_law = "dry";  // key: default
  std::vector<JointRule> between;
};

}  // namespace voussoir::cases
