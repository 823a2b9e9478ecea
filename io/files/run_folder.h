// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

/// The folder of one run, held by one process.
namespace voussoir::io {

/// How every case.toml begins that a run wrote.
inline constexpr std::string_view kResolvedHead = "# All keys of the case with their values, as used.";

/// Makes `temporary` (closed, complete) take the place of `path`: its bytes reach the disk first, so after a crash `path` is the old
/// file or the new one, never a part. \throw FileError; then `temporary` is gone
void replace_file(const std::string& temporary, const std::string& path);
/// Writes these bytes under `path` as replace_file does: whatever happens, `path` is the old file or the whole new one. \throw FileError
void write_whole_file(const std::string& path, std::span<const std::byte> bytes);
/// The same of a text. \throw FileError
void write_text_file(const std::string& path, const std::string& text);

/// Has the disk set aside so many bytes for a file, whose size does not change; nothing where the file system cannot.
/// \throw FileError if there are not as many
void claim_room(const std::string& path, std::uint64_t bytes);
/// Gives back what lies behind the file's end.
void give_back_room(const std::string& path);

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
  void write_case(const std::string& toml) const { write_text_file(file("case.toml"), toml); }

 private:
  explicit RunFolder(std::string path);

  std::string path_;
  int lock_ = -1;
};

}  // namespace voussoir::io
