// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "io/input/files/output_path.h"

namespace voussoir::io {

/// "page (HTML)", for messages.
std::string name_of(FileKind kind);

/// Whether a file that begins with `head` (some kB, or all of it) is of that kind. An empty file is of any kind.
bool is_of_kind(FileKind kind, std::string_view head);

}  // namespace voussoir::io
