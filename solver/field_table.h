// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/world.h"

/// The one list of everything that makes up the state of a world. Whoever copies, compares or hashes a state walks it; a field that is not
/// in the table does not exist.
namespace voussoir::solver {

enum class FieldType : std::uint8_t { f64, i32, u8 };

/// One array of the state.
struct Field {
  const char* name;   // unique
  const char* unit;   // SI; "-": a number
  const char* shape;  // what one entry belongs to: element, side, segment, patch, point
  FieldType type;
  void* data;
  std::size_t count;  // entries

  [[nodiscard]] std::size_t bytes() const noexcept;
};

/// All fields, in a fixed order. Pointers are valid until a side retires (patches and points grow).
std::vector<Field> fields(World& w);

/// A 64-bit hash (FNV-1a) over names and bytes of all fields: equal bits, equal hash, on machines of one byte order.
std::uint64_t state_hash(World& w);

}  // namespace voussoir::solver
