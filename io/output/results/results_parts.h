// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/output/results/results_schema.h"

/// Rows on disk: the files parts/NNNN.h5, each self-contained, written once and never opened for writing again.
namespace voussoir::io {

/// A file of rows. It contains the datasets of tables with rows, under the names of run.h5 (which has the units), and the attributes of its
/// root rows_<table>, time_first and time_last [s], schema_version.
struct Part {
  std::string file;  // relative to the folder of the run
  RowCounts rows{};
  double first_time = 0, last_time = 0;  // s, over all tables
  std::string seal;                      // of the file; empty: not sealed, of an earlier version
};

/// File name as "parts/0012.h5".
[[nodiscard]] std::string part_name(std::size_t number);

/// Bytes of the rows of a part.
[[nodiscard]] std::uint64_t row_bytes(const RowSchema& schema, const Part& part) noexcept;

/// Total numbers of rows of the parts.
[[nodiscard]] RowCounts rows_of(std::span<const Part> parts) noexcept;

/// Creates a file under a temporary name by `fill`, seals it (sealed_pages.h), and renames it once it is complete and on disk (see
/// replace_file). \param temporary  none: PATH.tmp, unique since only one process uses the locked folder of a run \return the seal \throw
/// FileError, or the exception of `fill`; the existing file with this name is then unchanged
std::string write_file(const std::string& path, const std::function<void(Hdf5File&)>& fill, std::string temporary = {});

/// Writes the buffered rows as the file `folder`/`file`, and returns its description. \throw FileError
Part write_part(const std::string& folder, const std::string& file, const RowSchema& schema,
                std::span<const RowBuffer, kRowTables> buffers);

/// Adds all rows of the parts as virtual datasets that refer to the parts, and names these with their seals.
void link_rows(Hdf5File& file, const RowSchema& schema, std::span<const Part> parts);
/// Copies all rows of the parts.
void copy_rows(Hdf5File& file, const std::string& folder, const RowSchema& schema, std::span<const Part> parts);

/// Adjacent parts: `count` of them from number `first` of a list on.
struct PartRange {
  std::size_t first = 0, count = 0;
};
/// Which parts to make one, so that they become few while their rows are seldom copied: those with the least bytes over the square of the
/// number of parts that go. None: any two adjacent ones have more bytes than `limit`.
[[nodiscard]] std::optional<PartRange> parts_to_merge(const RowSchema& schema, std::span<const Part> parts, std::uint64_t limit);
/// Writes all rows of adjacent parts as the file `folder`/`file`, and returns its description. The parts stay. \throw FileError
Part merge_parts(const std::string& folder, const std::string& file, const RowSchema& schema, std::span<const Part> parts);

/// Rows of an earlier run to be kept.
struct EarlierRows {
  double until = 0.0;             // s; rows at or before this time are kept, later ones are dropped
  std::optional<RowCounts> rows;  // number of rows that must exist up to then; absent: any
};

/// Cuts the results of an earlier run at a time: keeps the parts that run.h5 names (an unsealed one names none: parts/0000.h5, 0001, ...),
/// without later rows. A merged run.h5 becomes the first part. Files of other parts are not removed: see remove_parts.
/// \throw FileError, also if the results are of another model, have other histories or fewer rows than required; no row is lost in this
/// case
std::vector<Part> keep_parts(const std::string& folder, const RowSchema& schema, const EarlierRows& earlier);

/// Removes the files of all parts but those kept, temporary ones too, and the folder parts/ if empty. Never throws, since remaining files
/// are not referred to.
void remove_parts(const std::string& folder, std::span<const Part> kept) noexcept;

/// Number of a file as part_name gives it; none: another name. \param file  without folder
[[nodiscard]] std::optional<std::size_t> part_number(const std::string& file);

/// Time of the last row of a table [s], −infinity without rows. \throw FileError
double last_time(const std::string& folder, RowTable table, std::span<const Part> parts);

}  // namespace voussoir::io
