// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/files/sealed_file.h"

#include <array>
#include <cinttypes>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "io/files/run_folder.h"
#include "solver/state/hash.h"

namespace voussoir::io {
namespace {

// What is said of the contents counts with them.
std::uint64_t hash_of(const std::string& what, long long version, std::span<const std::byte> bytes) {
  solver::Hash hash;
  const std::string said = what + " " + std::to_string(version);
  hash.add(said.data(), said.size());
  hash.add(bytes.data(), bytes.size());
  return hash.value();
}

/// What the header of a file says.
struct Seal {
  long long version = 0;
  unsigned long long bytes = 0;
  std::uint64_t hash = 0;
};

std::string text_of(const std::string& what, const Seal& s) {
  std::array<char, kSealBytes + 1> text{};
  std::snprintf(text.data(), text.size(), "%s %lld\n%llu bytes of HDF5 follow this header of %zu\nFNV-1a %016" PRIx64 "\n", what.c_str(),
                s.version, s.bytes, kSealBytes, s.hash);
  std::string header(text.data());
  header.resize(kSealBytes, '\n');
  return header;
}

bool read_seal(const std::string& what, const std::string& header, Seal& s) {
  if (!header.starts_with(what + " ")) return false;
  const char* rest = header.c_str() + what.size() + 1;
  return std::sscanf(rest, "%lld %llu bytes of HDF5 follow this header of %*u FNV-1a %" SCNx64, &s.version, &s.bytes, &s.hash) == 3;
}

}  // namespace

std::string seal(const std::string& what, std::int64_t version, std::span<const std::byte> contents) {
  return text_of(what, {version, contents.size(), hash_of(what, version, contents)});
}

std::span<const std::byte> unsealed(const std::string& name, const std::string& what, std::int64_t version,
                                    std::span<const std::byte> bytes) {
  if (bytes.empty()) throw DamagedFile(name, "is empty");
  Seal s;
  const std::string header(reinterpret_cast<const char*>(bytes.data()), std::min(bytes.size(), kSealBytes));
  if (!header.starts_with(what + " ")) throw DamagedFile(name, "is no " + what);
  // The header itself is checked by writing it again.
  if (!read_seal(what, header, s) || text_of(what, s) != header) throw DamagedFile(name, "is damaged: its header makes no sense");
  const std::span<const std::byte> contents = bytes.subspan(kSealBytes);
  if (contents.size() != s.bytes) {
    throw DamagedFile(name, "is damaged: it has " + std::to_string(contents.size()) + " bytes behind its header; " +
                                std::to_string(s.bytes) + " were written");
  }
  if (hash_of(what, s.version, contents) != s.hash) throw DamagedFile(name, "is damaged: its bytes are not those that were written");
  if (s.version != version) {
    throw FileError(name, "has version " + std::to_string(s.version) + " of the layout; this program goes on from version " +
                              std::to_string(version) + " only");
  }
  return contents;
}

void write_sealed(const std::string& path, const std::string& what, std::int64_t version, std::span<const std::byte> contents) {
  const std::string header = seal(what, version, contents);
  const std::array<std::span<const std::byte>, 2> pieces{std::as_bytes(std::span(header)), contents};
  write_whole_file(path, pieces);
}

std::vector<std::byte> read_bytes(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (!fs::is_regular_file(path, error)) throw FileError(path, fs::exists(path, error) ? "is no regular file" : "no such file");
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) throw FileError(path, error.message());
  std::vector<std::byte> bytes(size);
  std::ifstream in(path, std::ios::binary);
  if (!in || !in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size))) throw FileError(path, "cannot be read");
  return bytes;
}

}  // namespace voussoir::io
