// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "io/case_file/case_file.h"

/// `voussoir bench`: how long a step takes, and where.
namespace voussoir::io {

struct BenchOptions {
  double after = 0.0;      // s of shaking until the measurement; 0: intact, under the first of gravity
  int batches = 0;         // a figure is the median of so many; 0: 15, or up to 60 on a machine that is seldom quiet
  int steps = 0;           // in a batch; 0: as many as take about 0.1 s
  std::string csv;         // also write the table here, if not empty
  std::string stages_csv;  // and that of the stages here
  bool overwrite = false;
};

/// Steps the case with 1, 2, 4, ... threads, up to those that use_threads has set, by colour and by gather, and prints tables: what a step
/// takes, where it goes, and, by colour, what a model of the schedule says of more cores. \throw cases::InputError, FileError before
/// anything runs
int bench_command(const LoadedCase& c, const BenchOptions& o);

/// The same at the state of a checkpoint. \throw FileError, and cases::InputError if o.after is given
int bench_checkpoint(const std::string& path, const BenchOptions& o);

}  // namespace voussoir::io
