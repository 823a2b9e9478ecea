// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "solver/run/simulation.h"

/// The one list of everything that makes up the state of a run. Whoever writes, reads, copies, compares or hashes a state walks it; a field
/// that is not in the table does not exist.
namespace voussoir::solver {

struct RunState;

enum class FieldType : std::uint8_t { f64, i64, i32, u8 };

/// Bytes of one value.
std::size_t size_of(FieldType type) noexcept;

/// One array of the state.
struct Field {
  const char* name;   // unique
  const char* unit;   // SI; "-": a number
  const char* shape;  // what one entry belongs to: element, side, segment, patch, point, active patch, slot, load, ..., run (a single one)
  FieldType type;
  void* data;
  std::size_t count;        // entries
  std::size_t columns = 1;  // values of an entry
  // Of integers: what the program can work with. Numbers of other things (elements, faces) must exist.
  std::int64_t low = std::numeric_limits<std::int64_t>::min(), high = std::numeric_limits<std::int64_t>::max();

  // Where entries do not follow one another in memory: how many lie together, and bytes from there to where the next do; 0: they follow.
  std::size_t together = 1, stride = 0;

  [[nodiscard]] std::size_t bytes() const noexcept { return count * columns * size_of(type); }
};

/// The values of a field one after another.
std::vector<std::byte> packed(const Field& f);
/// Puts them back. Writes only where something differs: memory that was never written to stays with the system (ZeroArray).
/// \pre  as many as the field has
void unpack(std::span<const std::byte> values, const Field& f);

/// Fields of a world, in a fixed order. Pointers are valid until a side retires (patches and points grow) or contacts are searched.
std::vector<Field> fields(World& w);

/// All fields of a run between two steps: the world's, then clock, counts, ledger and histories, then where the plan is.
std::vector<Field> fields(Simulation& sim, RunState& plan);

/// A 64-bit hash (FNV-1a) over names and bytes of the fields of a world: equal bits, equal hash, on machines of one byte order.
std::uint64_t state_hash(World& w);

}  // namespace voussoir::solver
