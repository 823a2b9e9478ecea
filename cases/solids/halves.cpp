// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/solids/halves.h"

#include <utility>

#include "geometry/prism.h"

namespace voussoir::cases {

std::array<Block, 2> in_halves(const Block& whole, std::int32_t unit) {
  const auto [low, high] = geometry::bounds(whole.shape);
  const Vec3 size = high - low;
  Vec3 first_high = high, second_low = low;
  double& cut = size.x >= size.y ? first_high.x : first_high.y;
  cut = size.x >= size.y ? low.x + 0.5 * size.x : low.y + 0.5 * size.y;
  (size.x >= size.y ? second_low.x : second_low.y) = cut;
  std::array<Block, 2> halves{whole, whole};
  halves[0].shape = geometry::make_box(low, first_high);
  halves[1].shape = geometry::make_box(second_low, high);
  for (std::size_t i = 0; i < 2; ++i) {
    halves[i].unit = unit;
    halves[i].whole = false;
    if (!whole.name.empty()) halves[i].name = halves[i].tag = whole.name + "/" + std::to_string(i + 1);
  }
  return halves;
}

void halve_bricks(std::vector<Block>& blocks) {
  std::vector<Block> out;
  out.reserve(2 * blocks.size());
  std::int32_t unit = 0;
  for (Block& block : blocks) {
    if (block.kind != PartKind::brick || !block.whole) {
      out.push_back(std::move(block));
      continue;
    }
    for (Block& half : in_halves(block, unit++)) out.push_back(std::move(half));
  }
  blocks = std::move(out);
}

}  // namespace voussoir::cases
