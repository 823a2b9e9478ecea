// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/drawing/block_style.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace voussoir::io {

using cases::PartKind;

std::string Colour::text(double light) const {
  std::array<char, 8> out{};
  const auto part = [&](int v) { return static_cast<unsigned>(std::clamp(v * light, 0.0, 255.0)); };
  std::snprintf(out.data(), out.size(), "#%02x%02x%02x", part(r), part(g), part(b));
  return out.data();
}

Style style_of(const cases::Block& block, bool of_rubble) {
  if (block.ground >= 0) return {"ground", {150, 142, 128}};
  const auto colour = [&]() -> Colour {
    switch (block.kind) {
      case PartKind::brick:
      case PartKind::walling:
        return block.whole ? Colour{222, 188, 150} : Colour{201, 152, 106};
      case PartKind::voussoir:
      case PartKind::arch_stone:
        return {214, 170, 138};
      case PartKind::lintel:
        return {126, 90, 54};
      case PartKind::beam:
      case PartKind::floor_beam:
        return {168, 126, 80};
      case PartKind::column:
        return {92, 122, 84};
      case PartKind::ring_beam:
        return {62, 106, 106};
      case PartKind::block:
        break;
    }
    return block.fixed ? Colour{150, 150, 150} : Colour{200, 200, 190};
  };
  const std::string prefix = block.fixed ? "fixed " : block.whole ? "" : "cut ";
  const bool stone = block.kind == cases::PartKind::brick && of_rubble;
  return {prefix + (stone ? "stone of rubble" : cases::name(block.kind)), colour()};
}

}  // namespace voussoir::io
