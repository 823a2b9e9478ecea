// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cases/model.h"
#include "cases/tables/joints.h"

/// Random strength of joints (Case::scatter).
///
/// A joint has one factor on f_t, c and f_m: the quality of its mortar varies, so all three vary together; the angle of friction and the
/// stiffness do not vary. The factor is constant over a joint and independent between joints. Its mean is 1, so the strengths of the case
/// are the means. It is computed by a hash of the seed and of the two faces of the joint, with IEEE sums, products, quotients and roots
/// only: its bits depend neither on the order in which joints are visited nor on any library (but, as all bits, on the instruction set of
/// the build), and a joint keeps its factor when blocks are appended to the case.
namespace voussoir::cases {

/// Standard deviations at which `normal` and `lognormal` deviates are cut. The cut reduces the coefficient of variation by 0.2 % for a
/// normal distribution; for a lognormal one of 0.3 by some 0.6 %, of 0.5 by 1.6 %, of 1 by 5 %.
inline constexpr double kScatterCut = 3.0;

/// The strength factor of the joint of two faces (geometry::Joint: element_a, face_a, element_b, face_b).
/// \pre check_scatter(s) has passed
double strength_factor(const Scatter& s, const std::array<std::int32_t, 4>& joint) noexcept;

/// Checks a scatter. \throw InputError for a variation at which the distribution would have negative strengths
void check_scatter(const Scatter& s);

/// The factor of every joint of the model; 1 where scatter does not apply to the joint's law. \pre the laws of joints are set
/// \throw InputError as check_scatter, and for an unknown law
std::vector<double> strength_factors(const Scatter& s, const Model& model);

}  // namespace voussoir::cases
