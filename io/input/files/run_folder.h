// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

/// The folder of one run, held by one process.
namespace voussoir::io {

/// How every case.toml begins that a run wrote.
inline constexpr std::string_view kResolvedHead = "# All keys of the case with their values, as used.";

/// The number in "checkpoint-000012.h5"; nothing for other names.
std::optional<long> checkpoint_number(const std::string& name);

/// A locked folder. Only one process can hold it; the lock goes with the process, however it ends.
class RunFolder {
 public:
  /// Makes the folder (and those above it) and locks it, for a new run.
  /// \param overwrite  use the folder whatever it holds (but for a case.toml that no run wrote), and remove the results of an earlier run:
  /// run.h5, parts/, checkpoint-*.h5, case.toml, and what was made of them under its usual name (report.html, run.xdmf, paraview.h5,
  /// stills/VIEW-TIMEs.png); nothing else \throw FileError if another process holds the folder (with its number), it holds results or other
  /// files that are not hidden and `overwrite` is false, it is a file, or it cannot be written to
  static RunFolder create(const std::string& path, bool overwrite);
  /// Locks a folder that holds an earlier run, to go on with it. \throw FileError
  static RunFolder open(const std::string& path);

  RunFolder(RunFolder&& other) noexcept;
  RunFolder& operator=(RunFolder&& other) = delete;
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;
  ~RunFolder();

  [[nodiscard]] const std::string& path() const noexcept { return path_; }
  /// Path of a file in the folder.
  [[nodiscard]] std::string file(const std::string& name) const { return path_ + "/" + name; }
  /// Writes the resolved case as case.toml. \throw FileError
  void write_case(const std::string& toml) const;

 private:
  explicit RunFolder(std::string path);

  std::string path_;
  int lock_ = -1;
};

}  // namespace voussoir::io
