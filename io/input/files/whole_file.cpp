// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/files/whole_file.h"

#include <sys/stat.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

#include "io/input/files/descriptor.h"
#include "io/input/files/output_path.h"

namespace voussoir::io {
namespace fs = std::filesystem;
namespace {

constexpr std::chrono::hours kLeftOver{1};  // much longer than writing of any file takes

void sync(const std::string& path) {
  const Descriptor file(path, O_RDONLY);
  // Some file systems cannot sync a folder and return EINVAL, which is ignored.
  if (::fsync(file.id()) != 0 && errno != EINVAL) throw FileError(path, "cannot write: " + system_words(errno));
}

/// Whether `name` is that of another process's temporary file for `of`.
bool is_temporary(const std::string& name, const std::string& of) {
  constexpr std::string_view kTail = ".tmp";
  if (!name.starts_with(of + ".") || !name.ends_with(kTail) || name.size() < of.size() + 2 + kTail.size()) return false;
  const std::string process = name.substr(of.size() + 1, name.size() - of.size() - 1 - kTail.size());
  return process.find_first_not_of("0123456789") == std::string::npos;
}

/// Removes temporary files of killed processes for this file. Judged by age only, since the other process may be on another machine.
void remove_leftovers(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path(), name = fs::path(path).filename();
  std::error_code ignored;
  std::vector<fs::path> old;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, ignored)) {
    if (!is_temporary(entry.path().filename().string(), name.string())) continue;
    const fs::file_time_type written = entry.last_write_time(ignored);
    if (!ignored && fs::file_time_type::clock::now() - written > kLeftOver) old.push_back(entry.path());
  }
  for (const fs::path& leftover : old) fs::remove(leftover, ignored);
}

}  // namespace

std::string own_temporary(const std::string& path) {
  remove_leftovers(path);
  return cleared(path + "." + std::to_string(::getpid()) + ".tmp");
}

void replace_file(const std::string& temporary, const std::string& path) {
  try {
    sync(temporary);
    refuse_odd_file(path);
    if (::rename(temporary.c_str(), path.c_str()) != 0) throw FileError(path, "cannot replace: " + system_words(errno));
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
  const std::string folder = fs::path(path).parent_path().string();
  sync(folder.empty() ? "." : folder);
}

void write_whole_file(const std::string& path, std::span<const std::byte> bytes) {
  const std::string temporary = own_temporary(path);
  try {
    const Descriptor file(temporary, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW);
    write_all(file.id(), reinterpret_cast<const char*>(bytes.data()), bytes.size(), path);
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
  replace_file(temporary, path);
}

void write_text_file(const std::string& path, const std::string& text) { write_whole_file(path, std::as_bytes(std::span(text))); }

void claim_room(const std::string& path, std::uint64_t bytes) {
  const Descriptor file(path, O_WRONLY);
  if (::fallocate(file.id(), FALLOC_FL_KEEP_SIZE, 0, static_cast<off_t>(bytes)) == 0) return;
  if (errno == ENOSPC || errno == EFBIG || errno == EDQUOT)
    throw FileError(path, "no room for " + std::to_string(bytes) + " bytes: " + system_words(errno));
}

void give_back_room(const std::string& path) {
  const Descriptor file(path, O_WRONLY);
  struct stat is {};
  if (::fstat(file.id(), &is) != 0 || ::ftruncate(file.id(), is.st_size) != 0)
    throw FileError(path, "cannot give back room: " + system_words(errno));
}

}  // namespace voussoir::io
