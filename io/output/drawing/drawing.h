// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cases/forward.h"

/// A drawing of a model: four elevations, plans of two courses or of all storeys, vaults between walls from above and in two sections
/// each, every block with its edges, as SVG.
namespace voussoir::io {

/// Elevations are seen from outside; parts behind an opening are darker. The plans are horizontal sections, for a house through the course
/// that meets most openings and the course above; for walls of any plan through all openings, with the names of their sides; else at half
/// the model's height. Openings and thicknesses of a single house, and of walls of any plan, have dimensions (m); every view has axes, the
/// sheet a scale bar. The elements that the case follows (output.history) are blue and named. Ties are green lines; straps of meshes are
/// drawn in the elevations only, on the visible faces. \pre the model has an element
std::string draw(const cases::Case& c, const cases::Model& model);

}  // namespace voussoir::io
