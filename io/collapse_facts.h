// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace voussoir::io {

class FrameReader;
class Hdf5File;

/// How a building fell, from the frames of its run. What "fallen" and "collapsed" mean stands in solver/collapse.h.
struct CollapseFacts {
  /// Of the first frame in which the building is collapsed, s: late by less than the interval of frames. Absent if there is none, or if the
  /// run does not say what is roof (results without /model/element/kind).
  std::optional<double> time;
  /// How far beyond the building's footprint what has fallen lies in the last frame: the largest horizontal distance of a fallen element's
  /// centroid, and the distance within which 95 % of the fallen mass lies, m; 0 if nothing has fallen or all of it inside. The footprint is
  /// the rectangle along x and y about the houses in the reference configuration (without a house: about all elements that are not fixed).
  double reach = 0, reach_95 = 0;
};

/// \param base  height of the base, m \throw FileError
CollapseFacts collapse_facts(const Hdf5File& run, const FrameReader& frames, double base);

}  // namespace voussoir::io
