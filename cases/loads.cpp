// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/loads.h"

#include <algorithm>

#include "cases/names.h"

namespace voussoir::cases {

std::vector<std::int32_t> loaded_elements(const Model& model, const Load& load, std::size_t index) {
  std::vector<std::int32_t> elements = elements_named(model, load.block);
  const std::string key = indexed_key("load", index, "block");
  if (elements.empty()) throw InputError(key, "= " + quoted(load.block) + " is the name of no block");
  std::erase_if(elements, [&](std::int32_t e) { return model.blocks[static_cast<std::size_t>(e)].fixed; });
  if (elements.empty()) throw InputError(key, quoted(load.block) + " is fixed, a load cannot move it");
  return elements;
}

}  // namespace voussoir::cases
