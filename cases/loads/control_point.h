// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cases/forward.h"

/// The control point of a quasi-static analysis: the element whose displacement is that of the capacity curve.
namespace voussoir::cases {

/// The elements that the name of a control point stands for: a block, a stone or a group of stones, else the part of a house with this
/// name ("front wall, storey 2", "roof beam 12"). Empty if nothing has the name.
std::vector<std::int32_t> elements_called(const Model& model, const std::string& name);

/// Checks that `analysis.control`, if it is a name, names something that can move, in one house. \throw InputError
void check_control(const Case& c, const Model& model);

}  // namespace voussoir::cases
