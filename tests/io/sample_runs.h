// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// A small run.h5 of each schema_version, written by the program of its time (tests/io/samples/README.md).
namespace voussoir::io::test {

inline constexpr int kSampleSchemas = 6;

/// Whether there is one: schemas whose programs could not be had have none.
bool has_sample(int schema);

/// The bytes of a file that gzip has made. \throw std::runtime_error
std::vector<std::byte> unpacked(const std::string& path);

/// The bytes of a sample's run.h5. \throw std::runtime_error
std::vector<std::byte> sample_run(int schema);

}  // namespace voussoir::io::test
