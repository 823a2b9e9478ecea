// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/files/sealed_file.h"

#include <array>
#include <cinttypes>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <utility>
#include <vector>

#include "io/input/files/output_path.h"
#include "io/input/files/whole_file.h"
#include "solver/state/hash.h"

namespace voussoir::io {
namespace {

/// Hash of kind and version, to which the contents are then added.
solver::Hash hash_of(const std::string& what, long long version) {
  solver::Hash hash;
  const std::string said = what + " " + std::to_string(version);
  hash.add(said.data(), said.size());
  return hash;
}

/// Contents of the header of a file.
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

namespace {

/// Checks a header. \param hash  gives the hash of the contents; called last
void check(const std::string& name, const std::string& what, SealedVersions versions, const std::string& header, std::uint64_t contents,
           const std::function<std::uint64_t(long long)>& hash) {
  Seal s;
  if (!header.starts_with(what + " ")) throw DamagedFile(name, "is no " + what);
  // Writing the header again checks all of its bytes.
  if (!read_seal(what, header, s) || text_of(what, s) != header) throw DamagedFile(name, "is damaged: its header makes no sense");
  if (contents != s.bytes) {
    throw DamagedFile(
        name, "is damaged: it has " + std::to_string(contents) + " bytes behind its header; " + std::to_string(s.bytes) + " were written");
  }
  if (hash(s.version) != s.hash) throw DamagedFile(name, "is damaged: its bytes are not those that were written");
  if (s.version < versions.oldest || s.version > versions.newest) {
    throw FileError(name, "has version " + std::to_string(s.version) + " of the layout; this program goes on from versions " +
                              std::to_string(versions.oldest) + " to " + std::to_string(versions.newest) + " only");
  }
}

/// Hash of the contents behind the header, read in pieces.
std::uint64_t hash_of_file(const std::string& path, const std::string& what, long long version) {
  std::ifstream in(path, std::ios::binary);
  in.seekg(kSealBytes);
  solver::Hash hash = hash_of(what, version);
  std::vector<char> piece(std::size_t{1} << 20);
  while (in) {
    in.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    hash.add(piece.data(), static_cast<std::size_t>(in.gcount()));
  }
  if (!in.eof()) throw FileError(path, "cannot be read");
  return hash.value();
}

std::uint64_t size_of_file(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (!fs::is_regular_file(path, error)) throw FileError(path, fs::exists(path, error) ? "is no regular file" : "no such file");
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) throw FileError(path, error.message());
  return size;
}

}  // namespace

std::span<const std::byte> unsealed(const std::string& name, const std::string& what, SealedVersions versions,
                                    std::span<const std::byte> bytes) {
  if (bytes.empty()) throw DamagedFile(name, "is empty");
  const std::span<const std::byte> head = bytes.first(std::min(bytes.size(), kSealBytes)), contents = bytes.subspan(head.size());
  check(name, what, versions, {reinterpret_cast<const char*>(head.data()), head.size()}, contents.size(), [&](long long said) {
    solver::Hash hash = hash_of(what, said);
    hash.add(contents.data(), contents.size());
    return hash.value();
  });
  return contents;
}

void check_seal(const std::string& path, const std::string& what, SealedVersions versions) {
  const std::uint64_t size = size_of_file(path);
  if (size == 0) throw DamagedFile(path, "is empty");
  std::string header(std::min<std::uint64_t>(size, kSealBytes), '\0');
  std::ifstream in(path, std::ios::binary);
  if (!in || !in.read(header.data(), static_cast<std::streamsize>(header.size()))) throw FileError(path, "cannot be read");
  check(path, what, versions, header, size - header.size(), [&](long long said) { return hash_of_file(path, what, said); });
}

SealedFile::SealedFile(std::string path, std::uint64_t room)
    : path_(std::move(path)), temporary_(path_ + ".tmp"), contents_(Hdf5File::create(cleared(temporary_), kSealBytes)) {
  try {
    claim_room(temporary_, kSealBytes + room);
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(temporary_, ignored);
    throw;
  }
}

SealedFile::~SealedFile() {
  std::error_code ignored;
  if (!sealed_) std::filesystem::remove(temporary_, ignored);
}

void SealedFile::seal(const std::string& what, std::int64_t version) {
  contents_.close();
  give_back_room(temporary_);
  const std::string header = text_of(what, {version, size_of_file(temporary_) - kSealBytes, hash_of_file(temporary_, what, version)});
  std::fstream out(temporary_, std::ios::binary | std::ios::in | std::ios::out);
  if (!out.write(header.data(), static_cast<std::streamsize>(header.size())).flush()) throw FileError(path_, "cannot write its header");
  out.close();
  replace_file(temporary_, path_);
  sealed_ = true;
}

}  // namespace voussoir::io
