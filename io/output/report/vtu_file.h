// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "cases/forward.h"
#include "solver/analysis/modes.h"

namespace voussoir::io {

/// Mode shapes on the model as a VTK unstructured grid (XML, text) for ParaView: per vertex a vector "mode 1 (5.750 Hz)" and so on, per
/// cell "element" and "material". Elements that are neither hexahedra nor prisms are polyhedra (VTK's cell type 42). To view, warp by a
/// vector.
std::string mode_shapes_vtu(const cases::Model& model, std::span<const solver::Mode> modes);

}  // namespace voussoir::io
