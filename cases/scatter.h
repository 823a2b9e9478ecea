// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cases/model.h"

/// Random strength of joints (Case::scatter): no two beds of mortar are alike.
///
/// A joint has one factor on f_t, c and f_m: what varies is the quality of its mortar, so the three go up and down together; the angle of
/// friction and the stiffness stay. The factor is the same all over a joint and independent from joint to joint. Its mean is 1, so the
/// strengths of the case are the means. It is drawn by a hash of the seed and of the two faces that meet, with nothing but IEEE sums,
/// products, quotients and roots: its bits depend neither on the order in which joints are visited nor on any library (but, as all bits,
/// on the instruction set of the build), and a joint keeps its factor when blocks are added behind those of the case.
namespace voussoir::cases {

/// Deviates of `normal` and `lognormal` are cut at this many standard deviations; it costs a normal one 0.2 % of the coefficient of
/// variation, a lognormal one of 0.3 some 0.6 %, of 0.5 1.6 % and of 1 5 %.
inline constexpr double kScatterCut = 3.0;

/// The factor of the joint of two faces (geometry::Joint: element_a, face_a, element_b, face_b).
/// \pre check_scatter(s) has passed
double strength_factor(const Scatter& s, const std::array<std::int32_t, 4>& joint) noexcept;

/// \throw InputError for a variation that the distribution cannot have without strengths below zero
void check_scatter(const Scatter& s);

/// The factor of every joint of the model, whose laws are there; 1 where the joint's law takes no part.
/// \throw InputError as check_scatter, and for a law that is not known
std::vector<double> strength_factors(const Scatter& s, const Model& model);

}  // namespace voussoir::cases
