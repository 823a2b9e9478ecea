// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

namespace voussoir::io {

class Hdf5File;

/// What a quasi-static analysis has found, for the report page: `capacity` (the figures of io/MEASURES.md), and its curves in `plots`:
/// those with `x` (name, unit, values) are drawn over it, with straight `lines` and `points` by name. Nothing of a time history.
void add_capacity(const Hdf5File& file, nlohmann::ordered_json& facts);

}  // namespace voussoir::io
