// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "cases/model.h"

/// Friction of any two materials that touch without a bond. Internal to cases/.
namespace voussoir::cases {

/// Angles of friction [degrees] of all pairs: a symmetric table of (materials + 1)², row after row; the last material is the base.
/// A material made from another has that one's.
/// \throw InputError at contact.between[i] for a material that is not known, an angle out of range, or a pair that stands there twice.
std::vector<double> contact_friction(const Contact& contact, std::span<const NamedMaterial> materials);

}  // namespace voussoir::cases
