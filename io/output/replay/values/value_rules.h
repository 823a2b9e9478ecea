// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// What the numbers in run.h5 may be (io/RESULTS.md), for readers of files that a forger made, or a program of before the seals.
namespace voussoir::io {

enum class Values : std::uint8_t {
  any,  // also NaN
  finite,
  positive,
  row,        // finite; in a run that was lost, also NaN: what was wrong with it
  time,       // finite, each after the one before
  late_time,  // finite, none before the one before
  unit,       // the last four are a unit quaternion
  index,      // of an item: `least` to the number of items, exclusive
  start       // of items that follow each other: ascending, from 0 to the number of items
};

struct ValueRule {
  /// Its name; that of a group, with '/' at its end: of each dataset in it that has no rule of its own.
  std::string_view dataset;
  /// Each extent: a number, the dataset that has so many rows, or "*", any number.
  std::vector<std::string_view> shape;
  Values values = Values::finite;
  /// Of an index or a start: how many items there are, a number or the dataset that has so many rows.
  std::string_view items = {};
  std::int64_t least = 0;
};

const std::vector<ValueRule>& value_rules();

/// The rule of a dataset, none if anything goes.
const ValueRule* rule_of(const std::string& dataset);

}  // namespace voussoir::io
