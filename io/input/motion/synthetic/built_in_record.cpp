// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/motion/synthetic/built_in_record.h"

#include <charconv>

#include "cases/input_error.h"
#include "io/input/motion/synthetic/bam_like.h"

namespace voussoir::io {
namespace {

constexpr std::string_view kFamily = "bam-like#";

}  // namespace

std::string built_in_records() { return "\"bam-like\", \"bam-like#N\" with N from 1 to " + std::to_string(kMostRealisations); }

bool is_built_in_record(std::string_view name) { return name == "bam-like" || name == "bam-like-1" || name.starts_with(kFamily); }

Record built_in_record(const std::string& name, const std::string& key) {
  if (!name.starts_with(kFamily)) return {name, bam_like_1()};
  const std::string number = name.substr(kFamily.size());
  int realisation = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), realisation);
  const bool whole = error == std::errc() && end == number.data() + number.size() && std::to_string(realisation) == number;
  if (!whole || realisation < 1 || realisation > kMostRealisations) {
    throw cases::InputError(key, "\"" + name + "\" names no realisation; allowed: " + built_in_records());
  }
  return {name, bam_like(realisation)};
}

}  // namespace voussoir::io
