// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "cases/motion.h"

/// Records built into the program, by name.
namespace voussoir::io {

/// A three-component record; an absent component has no samples.
struct Record {
  std::string name;
  std::array<cases::Accelerogram, 3> ltv;
};

/// The names that `is_built_in_record` accepts, for messages.
std::string built_in_records();

/// Whether the name is "bam-like", "bam-like-1" or begins with "bam-like#".
bool is_built_in_record(std::string_view name);

/// The record "bam-like" or "bam-like-1", which are equal, or "bam-like#7", realisation 7 of the family.
/// \throw cases::InputError at `key` for a realisation that is no whole number from 1 to kMostRealisations.
Record built_in_record(const std::string& name, const std::string& key);

}  // namespace voussoir::io
