// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/files/whole_file.h"

#include <sys/stat.h>

#include <cstdio>
#include <filesystem>

#include "io/files/descriptor.h"

namespace voussoir::io {
namespace fs = std::filesystem;
namespace {

void sync(const std::string& path) {
  const Descriptor file(path, O_RDONLY);
  // Some file systems cannot sync a folder and say so with EINVAL; there is nothing more to do there.
  if (::fsync(file.id()) != 0 && errno != EINVAL) throw FileError(path, "cannot write: " + system_words(errno));
}

}  // namespace

void replace_file(const std::string& temporary, const std::string& path) {
  try {
    sync(temporary);
    if (::rename(temporary.c_str(), path.c_str()) != 0) throw FileError(path, "cannot replace: " + system_words(errno));
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
  const std::string folder = fs::path(path).parent_path().string();
  sync(folder.empty() ? "." : folder);
}

void write_whole_file(const std::string& path, std::span<const std::byte> bytes) {
  const std::string temporary = path + ".tmp";
  try {
    const Descriptor file(temporary, O_WRONLY | O_CREAT | O_TRUNC);
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
