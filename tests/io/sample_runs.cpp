// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/io/sample_runs.h"

#include <zlib.h>

#include <array>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace voussoir::io::test {
namespace {

std::string path_of(int schema) {
  return std::string(VOUSSOIR_SOURCE_DIR) + "/tests/io/samples/schema-" + std::to_string(schema) + ".h5.gz";
}

}  // namespace

bool has_sample(int schema) { return std::filesystem::exists(path_of(schema)); }

std::vector<std::byte> unpacked(const std::string& path) {
  const gzFile file = ::gzopen(path.c_str(), "rb");
  if (file == nullptr) throw std::runtime_error(path + " cannot be read");
  std::vector<std::byte> bytes;
  std::array<std::byte, 65536> piece{};
  for (int n = 0; (n = ::gzread(file, piece.data(), static_cast<unsigned>(piece.size()))) > 0;)
    bytes.insert(bytes.end(), piece.begin(), piece.begin() + n);
  ::gzclose(file);
  return bytes;
}

std::vector<std::byte> sample_run(int schema) { return unpacked(path_of(schema)); }

}  // namespace voussoir::io::test
