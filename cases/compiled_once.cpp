// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/case.h"
#include "cases/house/house_case.h"
#include "cases/input_error.h"
#include "cases/model.h"
#include "cases/tables/blocks.h"

// Constructors, copies and destructors of the large structs and of errors. If they were implicit, each source that copies such a struct
// would compile the copying of all its members anew, which took a third of the compiler's time for it.
namespace voussoir::cases {

Case::Case() = default;
Case::Case(const Case&) = default;
Case::Case(Case&&) noexcept = default;
Case& Case::operator=(const Case&) = default;
Case& Case::operator=(Case&&) noexcept = default;
Case::~Case() = default;

House::House() = default;
House::House(const House&) = default;
House::House(House&&) noexcept = default;
House& House::operator=(const House&) = default;
House& House::operator=(House&&) noexcept = default;
House::~House() = default;

BlockSpec::BlockSpec() = default;
BlockSpec::BlockSpec(const BlockSpec&) = default;
BlockSpec::BlockSpec(BlockSpec&&) noexcept = default;
BlockSpec& BlockSpec::operator=(const BlockSpec&) = default;
BlockSpec& BlockSpec::operator=(BlockSpec&&) noexcept = default;
BlockSpec::~BlockSpec() = default;

Model::Model() = default;
Model::Model(const Model&) = default;
Model::Model(Model&&) noexcept = default;
Model& Model::operator=(const Model&) = default;
Model& Model::operator=(Model&&) noexcept = default;
Model::~Model() = default;

Block::Block() = default;
Block::Block(const Block&) = default;
Block::Block(Block&&) noexcept = default;
Block& Block::operator=(const Block&) = default;
Block& Block::operator=(Block&&) noexcept = default;
Block::~Block() = default;

InputError::InputError(std::string key, const std::string& problem)
    : std::runtime_error(key.empty() ? problem : key + ": " + problem), key_(std::move(key)), problem_(problem) {}
InputError::InputError(const InputError&) = default;
InputError& InputError::operator=(const InputError&) = default;
InputError::~InputError() = default;

void Faults::add(const InputError& e) {
  for (const InputError& known : all_) {
    if (known.key() == e.key() && known.problem() == e.problem()) return;
  }
  all_.push_back(e);
}

void Faults::raise() const {
  if (all_.size() == 1) throw all_.front();
  if (!all_.empty()) throw InputErrors(all_);
}

}  // namespace voussoir::cases
