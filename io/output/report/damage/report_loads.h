// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace voussoir::io {

class FrameReader;
class Hdf5File;

/// Forces of the [[load]] tables for the report page, from /loads of a run.
/// \return JSON list, a load an entry: name ("load 2"), frames: for each frame of the reader null (no force) or seven numbers: the element
/// that it acts on, the point (m, in the reference configuration), the force (N, as it points then). Of a load that moves between two
/// places the place is between them, and the element that of the larger share. Empty without forces.
/// \throw FileError
std::string report_loads(const Hdf5File& run, const FrameReader& frames);

}  // namespace voussoir::io
