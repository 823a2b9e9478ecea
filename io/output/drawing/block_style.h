// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cases/model.h"

/// Colours of blocks in drawings.
namespace voussoir::io {

struct Colour {
  int r, g, b;
  /// "#rrggbb". \param light  factor
  [[nodiscard]] std::string text(double light) const;
};

/// Name of a block in the legend, and its colour.
struct Style {
  std::string name;
  Colour colour;
};

/// \param of_rubble  whether the walls of the house are of rubble
Style style_of(const cases::Block& block, bool of_rubble);

}  // namespace voussoir::io
