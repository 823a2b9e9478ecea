// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/case.h"
#include "io/case_file/case_keys.h"

/// The option tables of the case file; `case_table` is the root and holds the others.
namespace voussoir::io {

Table<cases::Case> case_table();
Table<cases::House> house_table();
Table<cases::Motion> motion_table();
Table<cases::Output> output_table();
Table<cases::BlockSpec> block_table();
Table<cases::StonesSpec> stones_table();
Table<cases::Load> load_table();

}  // namespace voussoir::io
