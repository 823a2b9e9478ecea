// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

/// Tables [materials.NAME] of the case file.
namespace voussoir::cases {

struct Material {
  double density = 0.0;  // kg/m3
  double young = 0.0;    // Pa
  double poisson = 0.0;
  std::optional<std::string> inside{};  // law between the convex pieces of a stone that is not convex (none: pieces
                                        // never separate), and between the cells of a unit
};

}  // namespace voussoir::cases
