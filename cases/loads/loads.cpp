// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/loads/loads.h"

#include <algorithm>

#include "cases/names.h"
#include "cases/solids/stone_blocks.h"

namespace voussoir::cases {

void check_loads(const Case& c) {
  for (std::size_t i = 0; i < c.loads.size(); ++i) {
    const Load& load = c.loads[i];
    const auto named = std::find_if(c.blocks.begin(), c.blocks.end(), [&](const BlockSpec& b) { return b.name == load.block; });
    if (named == c.blocks.end() && !is_stone_or_group(c, load.block)) {
      throw InputError(indexed_key("load", i, "block"),
                       "there is no [[block]]" + std::string(c.stones.empty() ? "" : ", stone or group") + " named " + quoted(load.block));
    }
    if (named != c.blocks.end() && named->halves) {
      throw InputError(indexed_key("load", i, "block"), quoted(load.block) + " is in halves; allowed: a block in one piece");
    }
    if (named != c.blocks.end() && named->fixed) {
      throw InputError(indexed_key("load", i, "block"), quoted(load.block) + " is fixed, a load cannot move it");
    }
    if (!(load.ramp[0] <= load.ramp[1])) {
      throw InputError(indexed_key("load", i, "ramp"),
                       "begins at " + text(load.ramp[0]) + " s, after its end at " + text(load.ramp[1]) + " s");
    }
  }
}

std::vector<std::int32_t> loaded_elements(const Model& model, const Load& load, std::size_t index) {
  std::vector<std::int32_t> elements = elements_named(model, load.block);
  const std::string key = indexed_key("load", index, "block");
  if (elements.empty()) throw InputError(key, "= " + quoted(load.block) + " is the name of no block");
  std::erase_if(elements, [&](std::int32_t e) { return model.blocks[static_cast<std::size_t>(e)].fixed; });
  if (elements.empty()) throw InputError(key, quoted(load.block) + " is fixed, a load cannot move it");
  return elements;
}

}  // namespace voussoir::cases
