// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "cases/model.h"
#include "cases/tables/contact.h"

/// Friction of contacts without a bond.
namespace voussoir::cases {

/// Angles of friction [degrees] of all pairs: a symmetric table of (materials + 1)², row after row; the last material is the base. A
/// material made from another has the angles of the latter.
/// \throw InputError at contact.between[i] for an unknown material, an angle out of range, or a duplicate pair.
std::vector<double> contact_friction(const Contact& contact, std::span<const NamedMaterial> materials);

/// Angle of friction [degrees] of a joint without its bond: that of its law, else that of its two materials.
double friction_without_bond(const Model& model, std::size_t joint);

}  // namespace voussoir::cases
