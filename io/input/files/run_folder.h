// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

/// The folder of one run, locked by one process.
namespace voussoir::io {

/// First line of every case.toml written by a run.
inline constexpr std::string_view kResolvedHead = "# All keys of the case with their values, as used.";

/// The number in "checkpoint-000012.h5"; nothing for other names.
std::optional<long> checkpoint_number(const std::string& name);

/// What holds the folder of a run, as "process 12"; empty: nothing does. None: there is no lock file, as in a copy, or it cannot be read.
std::optional<std::string> holder_of(const std::string& folder);

/// A locked folder. Only one process can hold the lock, which ends with the process.
class RunFolder {
 public:
  /// Creates the folder (and its parents) and locks it, for a new run.
  /// \param overwrite  accept a folder with contents (but not with a case.toml that no run wrote), and remove the results of an earlier
  /// run: run.h5, parts/, checkpoint-*.h5, case.toml, and files made from them under their default names (report.html, run.xdmf,
  /// paraview.h5, stills/VIEW-TIMEs.png); nothing else
  /// \throw FileError if another process (named by its number) holds the folder, if it contains results or other files that are not hidden
  /// and `overwrite` is false, if it is a file, or if it is not writable
  static RunFolder create(const std::string& path, bool overwrite);
  /// Locks a folder with an earlier run, to continue the run. \throw FileError
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
