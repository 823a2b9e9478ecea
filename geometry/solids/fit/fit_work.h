// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "geometry/polyhedron.h"

namespace voussoir::geometry {

/// The work of fitting stones, and its bound: so much as all stones of that many faces may take together, whatever a file holds.
class FitWork {
 public:
  /// \param faces  of all stones
  explicit FitWork(std::size_t faces) noexcept : most_(kLeast + kEach * static_cast<double>(faces)) {}

  /// Adds to the work, in about nanoseconds. \throw ModelError with the stone as subject: the bound is reached
  void add(double work, std::int32_t stone) {
    done_ += work;
    if (done_ > most_)
      throw ModelError("has so many faces, or so many neighbours near to them, that the stones cannot be fitted within reasonable time", stone);
  }

 private:
  static constexpr double kLeast = 1e9, kEach = 2e6;  // of a file, and of a face in it
  double most_, done_ = 0.0;
};

}  // namespace voussoir::geometry
