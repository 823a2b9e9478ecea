// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "io/input/files/hdf5_file.h"
#include "io/output/replay/run_file.h"

/// The rows written by a run: one table for each group of run.h5, used by writer, index, merge and resume.
namespace voussoir::io {

/// The table NAME has the group /NAME: see table_name.
enum class RowTable : std::uint8_t { history, energy, forces, damage, cracks, frames, cuts, assessment };
inline constexpr std::size_t kRowTables = 8;

[[nodiscard]] const char* table_name(RowTable table) noexcept;

/// Number of rows of each table.
using RowCounts = std::array<std::uint64_t, kRowTables>;

/// A dataset extended row by row.
struct ColumnSpec {
  std::string name;  // path from the root
  Hdf5Type type = Hdf5Type::f64;
  Shape row;  // shape of one row; empty: a number
  Hdf5Note note;
  std::vector<std::string> names;  // meaning of the values 0, 1, ... of a choice

  /// Size of one row in bytes.
  [[nodiscard]] std::size_t row_bytes() const noexcept;
};

/// Columns of one table; the first is its time.
using TableSpec = std::vector<ColumnSpec>;
using RowSchema = std::array<TableSpec, kRowTables>;

/// The tables of a run.
/// \param history_names  of the followed elements, in the order of Recorder::history
/// \param cut_names  in the order of Recorder::cuts
/// \param ties, groups, loads  numbers in the model of separate ties, of decks and meshes, and of [[load]]s: their rows are in /ties,
/// /meshes and /loaded and belong to the table of histories
/// \throw std::invalid_argument if a name is empty, "time", a duplicate, contains '/' or a control character, or is "." or ".."
RowSchema row_schema(std::span<const std::string> history_names, std::uint64_t elements, std::span<const std::string> cut_names = {},
                     std::uint64_t ties = 0, std::uint64_t groups = 0, std::uint64_t loads = 0);

/// Rows of one table not yet on disk.
class RowBuffer {
 public:
  RowBuffer() = default;
  explicit RowBuffer(const TableSpec& columns);

  /// Begins a row and writes its time. Times must not decrease.
  /// \return false if a row of this time exists and the new row is to be left out (`repeats`: the table may have several rows of one time)
  /// \throw std::logic_error if `time` [s] is before the last row's
  bool begin(double time, bool repeats = false);
  /// Appends to a column; values have the type and number of the column's row.
  void put(std::size_t column, const void* data, std::size_t bytes);
  template <class T>
  void put(std::size_t column, const T& value) {
    put(column, &value, sizeof(T));
  }

  [[nodiscard]] std::uint64_t rows() const noexcept;
  [[nodiscard]] std::size_t bytes() const noexcept;
  [[nodiscard]] const std::byte* column(std::size_t i) const noexcept { return columns_[i].data(); }
  /// Time of the first buffered row [s]. \pre rows() > 0
  [[nodiscard]] double first_time() const noexcept;
  /// Time of the last row ever begun [s]; −infinity before the first.
  [[nodiscard]] double last_time() const noexcept { return last_; }
  /// Sets the time of the last row already on disk [s].
  void continue_after(double time) noexcept { last_ = time; }
  /// Removes the rows, keeps the memory.
  void clear() noexcept;

 private:
  std::vector<std::vector<std::byte>> columns_;
  std::size_t last_row_bytes_ = sizeof(double);  // in the last column
  double last_ = -std::numeric_limits<double>::infinity();
};

}  // namespace voussoir::io
