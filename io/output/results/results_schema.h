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

/// The rows that a run writes: one table for each group of run.h5, walked by writer, index, merge and resume.
namespace voussoir::io {

/// Version of the layout of run.h5, its attribute `schema_version`.
inline constexpr std::int64_t kResultsSchema = 4;

/// The group of a table is "/" and its name: see table_name.
enum class RowTable : std::uint8_t { history, energy, forces, damage, cracks, frames, cuts, assessment };
inline constexpr std::size_t kRowTables = 8;

[[nodiscard]] const char* table_name(RowTable table) noexcept;

/// Rows of each table.
using RowCounts = std::array<std::uint64_t, kRowTables>;

/// A dataset that grows by rows.
struct ColumnSpec {
  std::string name;  // path from the root
  Hdf5Type type = Hdf5Type::f64;
  Shape row;  // of one row; empty: a number
  Hdf5Note note;
  std::vector<std::string> names;  // of the values 0, 1, ... where they are choices

  /// Bytes of one row.
  [[nodiscard]] std::size_t row_bytes() const noexcept;
};

/// Columns of one table; the first is its time.
using TableSpec = std::vector<ColumnSpec>;
using RowSchema = std::array<TableSpec, kRowTables>;

/// \param history_names  of the followed elements, in the order of Recorder::history
/// \param cut_names  in the order of Recorder::cuts
/// \param ties  of the model: their rows stand in /ties and belong to the table of histories
/// \throw std::invalid_argument if a name is empty, "time", given twice, or holds '/' or a control character, or is "." or ".."
RowSchema row_schema(std::span<const std::string> history_names, std::uint64_t elements, std::span<const std::string> cut_names = {},
                     std::uint64_t ties = 0);

/// Rows of one table that are not yet on disk.
class RowBuffer {
 public:
  RowBuffer() = default;
  explicit RowBuffer(const TableSpec& columns);

  /// Starts a row and writes its time. Times may not run backwards.
  /// \return false if a row of this time is there already: leave this one out (`repeats`: the table may have many rows of one time)
  /// \throw std::logic_error if `time` [s] is before the last row's
  bool begin(double time, bool repeats = false);
  /// Appends to a column; values in the type and number of its row.
  void put(std::size_t column, const void* data, std::size_t bytes);
  template <class T>
  void put(std::size_t column, const T& value) {
    put(column, &value, sizeof(T));
  }

  [[nodiscard]] std::uint64_t rows() const noexcept;
  [[nodiscard]] std::size_t bytes() const noexcept;
  [[nodiscard]] const std::byte* column(std::size_t i) const noexcept { return columns_[i].data(); }
  /// Of the first row here, s. \pre rows() > 0
  [[nodiscard]] double first_time() const noexcept;
  /// Of the last row ever begun, s; −infinity before.
  [[nodiscard]] double last_time() const noexcept { return last_; }
  /// Says which rows are on disk already.
  void continue_after(double time) noexcept { last_ = time; }
  /// Drops the rows, keeps the memory.
  void clear() noexcept;

 private:
  std::vector<std::vector<std::byte>> columns_;
  std::size_t last_row_bytes_ = sizeof(double);  // of the last column
  double last_ = -std::numeric_limits<double>::infinity();
};

}  // namespace voussoir::io
