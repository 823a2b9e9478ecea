// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "solver/run/simulation.h"

/// The complete list of the arrays and numbers that form the state of a run. Writing, reading, copying, comparing and hashing of a state
/// all use this table; data outside it are not state.
namespace voussoir::solver {

struct RunState;

enum class FieldType : std::uint8_t { f64, i64, i32, u8 };

/// Size of one value in bytes.
std::size_t size_of(FieldType type) noexcept;

/// An array of the state.
struct Field {
  const char* name;   // unique
  const char* unit;   // SI; "-": a number
  const char* shape;  // owner of an entry: element, side, segment, patch, point, active patch, slot, load, ..., run (a single entry)
  FieldType type;
  void* data;
  std::size_t count;        // number of entries
  std::size_t columns = 1;  // values per entry
  // Valid range of integers. Indices of other things (elements, faces) must also exist.
  std::int64_t low = std::numeric_limits<std::int64_t>::min(), high = std::numeric_limits<std::int64_t>::max();

  // Layout of entries that are not contiguous: number of contiguous entries, and distance in bytes from one group to the next; 0:
  // contiguous.
  std::size_t together = 1, stride = 0;

  [[nodiscard]] std::size_t bytes() const noexcept { return count * columns * size_of(type); }
};

/// The values of a field in one contiguous array.
std::vector<std::byte> packed(const Field& f);
/// Writes values back to a field. Writes only where a value differs, so that memory that was never written to stays unallocated
/// (ZeroArray).
/// \pre the number of values is that of the field
void unpack(std::span<const std::byte> values, const Field& f);

/// Fields of a world, in fixed order. Pointers are valid until a side retires (patches and points grow) or contacts are searched.
std::vector<Field> fields(World& w);

/// All fields of a run between two steps: those of the world, then clock, counts, ledger and histories, then the progress of the plan.
std::vector<Field> fields(Simulation& sim, RunState& plan);

/// A 64-bit hash (FNV-1a) over names and bytes of the fields of a world: equal bits give an equal hash, on machines of one byte order.
std::uint64_t state_hash(World& w);

}  // namespace voussoir::solver
