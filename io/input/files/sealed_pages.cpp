// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/files/sealed_pages.h"

#include <sys/stat.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <functional>

#include "io/input/files/descriptor.h"

namespace voussoir::io {
namespace {

constexpr std::uint64_t kPage = 4096;
constexpr std::uint64_t kPieceBytes = 256 * kPage;  // of a file in memory at a time

std::uint64_t pages_of(std::uint64_t contents) { return (contents + kPage - 1) / kPage; }

std::uint32_t digest(const char* bytes, std::size_t count) {
  return static_cast<std::uint32_t>(::crc32(0, reinterpret_cast<const Bytef*>(bytes), static_cast<uInt>(count)));
}

void put_digest(std::string& to, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) to.push_back(static_cast<char>((value >> shift) & 0xffU));
}

std::uint32_t digest_at(const char* from) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i) value = (value << 8) | static_cast<unsigned char>(from[i]);
  return value;
}

std::string head_of(std::uint64_t contents, std::uint32_t seal) {
  std::array<char, kSealBytes + 1> text{};
  std::snprintf(text.data(), text.size(),
                "%s%llu bytes of HDF5 follow this header of %zu, then the CRC-32 of each %llu of them\nCRC-32 of these %08x\n", kSealedHdf5,
                static_cast<unsigned long long>(contents), kSealBytes, static_cast<unsigned long long>(kPage), seal);
  std::string head(text.data());
  head.resize(kSealBytes, '\n');
  return head;
}

std::uint64_t regular_size(int file, const std::string& path) {
  struct stat is {};
  if (::fstat(file, &is) != 0) throw FileError(path, "cannot open: " + system_words(errno));
  if (!S_ISREG(is.st_mode)) throw FileError(path, "is no regular file");
  return static_cast<std::uint64_t>(is.st_size);
}

void read_at(int file, const std::string& path, std::uint64_t at, std::size_t bytes, char* to) {
  while (bytes > 0) {
    const ssize_t n = ::pread(file, to, bytes, static_cast<off_t>(at));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) throw FileError(path, "cannot read: " + system_words(errno));
    if (n == 0) throw DamagedFile(path, "is truncated");
    to += n, at += static_cast<std::uint64_t>(n), bytes -= static_cast<std::size_t>(n);
  }
}

}  // namespace

std::uint32_t seal_pages(const std::string& path) {
  const Descriptor file(path, O_RDWR);
  const std::uint64_t end = regular_size(file.id(), path);
  std::string digests;
  std::vector<char> piece(kPieceBytes);
  for (std::uint64_t at = kSealBytes; at < end; at += kPieceBytes) {
    const std::uint64_t n = std::min(kPieceBytes, end - at);
    read_at(file.id(), path, at, n, piece.data());
    for (std::uint64_t p = 0; p < n; p += kPage) put_digest(digests, digest(piece.data() + p, std::min(kPage, n - p)));
  }
  const auto put = [&](std::uint64_t at, const std::string& bytes) {
    if (::lseek(file.id(), static_cast<off_t>(at), SEEK_SET) < 0) throw FileError(path, "cannot write: " + system_words(errno));
    write_all(file.id(), bytes.data(), bytes.size(), path);
  };
  put(end, digests);
  const std::uint32_t seal = digest(digests.data(), digests.size());
  put(0, head_of(end - kSealBytes, seal));
  return seal;
}

std::string seal_text(std::uint32_t seal) {
  std::array<char, 9> text{};
  std::snprintf(text.data(), text.size(), "%08x", seal);
  return text.data();
}

// Not blocking, since a pipe would wait for a writer.
PagedFile::PagedFile(const std::string& path) : path_(path), id_(-1) {
  Descriptor file(path, O_RDONLY | O_NONBLOCK);
  const std::uint64_t size = regular_size(file.id(), path);
  id_ = file.id();
  read_head(size);
  file.release();
}

PagedFile::~PagedFile() {
  if (id_ >= 0) ::close(id_);
}

void PagedFile::read_head(std::uint64_t size) {
  constexpr std::string_view kHdf5 = "\x89HDF\r\n\x1a\n";
  std::string head(std::min<std::uint64_t>(size, kSealBytes), '\0');
  read_raw(0, head.size(), head.data());
  end_ = size;
  // A checkpoint has a seal of its own, over the whole file (check_seal).
  if (head.starts_with(kHdf5) || head.starts_with(kSealedCheckpoint)) return;
  if (head.empty()) throw DamagedFile(path_, "is empty");
  unsigned long long contents = 0;
  if (!head.starts_with(kSealedHdf5)) throw DamagedFile(path_, "is no HDF5 file, or its first bytes are damaged");
  const int found = std::sscanf(head.c_str() + std::strlen(kSealedHdf5),
                                "%llu bytes of HDF5 follow this header of %*u, then the CRC-32 of each %*u of them CRC-32 of these %x",
                                &contents, &seal_);
  // Writing the header again checks all of its bytes.
  if (found != 2 || head != head_of(contents, seal_)) throw DamagedFile(path_, "is damaged: its header makes no sense");
  if (contents > size || kSealBytes + contents + 4 * pages_of(contents) != size)
    throw DamagedFile(path_, "is damaged: it has " + std::to_string(size) + " bytes; " +
                                 std::to_string(kSealBytes + contents + 4 * pages_of(contents)) + " were written");
  end_ = kSealBytes + contents;
  std::string list(4 * pages_of(contents), '\0');
  read_raw(end_, list.size(), list.data());
  if (digest(list.data(), list.size()) != seal_) throw DamagedFile(path_, "is damaged: its digests are not those that were written");
  for (std::size_t i = 0; i < list.size(); i += 4) digests_.push_back(digest_at(list.data() + i));
  checked_.assign(digests_.size(), false);
  sealed_ = true;
}

void PagedFile::read_raw(std::uint64_t at, std::size_t bytes, char* to) const { read_at(id_, path_, at, bytes, to); }

void PagedFile::check_pages(std::uint64_t first, std::uint64_t count, const char* bytes) {
  for (std::uint64_t p = first; p < first + count; ++p) {
    const std::uint64_t at = kSealBytes + p * kPage, n = std::min(kPage, end_ - at);
    if (digest(bytes + (p - first) * kPage, n) != digests_[p])
      throw DamagedFile(
          path_, "is damaged: bytes " + std::to_string(at) + " to " + std::to_string(at + n - 1) + " are not those that were written");
    checked_[p] = true;
  }
}

void PagedFile::read(std::uint64_t at, std::size_t bytes, char* to) {
  if (at > end_ || bytes > end_ - at) throw DamagedFile(path_, "is damaged: it refers to bytes behind its end");
  if (!sealed_) return read_raw(at, bytes, to);
  if (bytes == 0) return;
  if (at < kSealBytes) {  // HDF5 looks for its signature from the first byte on; the header was checked
    const std::size_t n = std::min<std::uint64_t>(bytes, kSealBytes - at);
    read_raw(at, n, to);
    return read(at + n, bytes - n, to + n);
  }
  const std::uint64_t first = (at - kSealBytes) / kPage, last = (at + bytes - 1 - kSealBytes) / kPage;
  bool known = true;
  for (std::uint64_t p = first; p <= last; ++p) known = known && checked_[p];
  if (known) return read_raw(at, bytes, to);
  const std::uint64_t from = kSealBytes + first * kPage;
  std::vector<char> pages(std::min(end_, kSealBytes + (last + 1) * kPage) - from);
  read_raw(from, pages.size(), pages.data());
  check_pages(first, last - first + 1, pages.data());
  std::copy_n(pages.data() + (at - from), bytes, to);
}

void PagedFile::check_all() {
  if (std::ranges::all_of(checked_, std::identity{})) return;
  std::vector<char> piece(kPieceBytes);
  for (std::uint64_t at = kSealBytes; at < end_; at += kPieceBytes) read(at, std::min(kPieceBytes, end_ - at), piece.data());
}

}  // namespace voussoir::io
