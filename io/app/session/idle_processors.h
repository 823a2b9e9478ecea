// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <istream>

/// Number of idle processors among those that this program may use.
namespace voussoir::io {

/// Sums over some processors since the start of the machine.
struct ProcessorTimes {
  double idle = 0.0, all = 0.0;  // ticks
  int processors = 0;
};

/// Reads and sums processor times. \param stat  text of /proc/stat (proc(5))
/// \param counts  whether to include a processor, by its number
ProcessorTimes read_processor_times(std::istream& stat, const std::function<bool(int)>& counts);

/// Number of processors idle between two readings; 0 if no time has passed.
double idle_between(const ProcessorTimes& before, const ProcessorTimes& after);

/// Number of idle processors, measured over a tenth of a second. Processors that the program may not use (a job on a part of a node) are
/// excluded; 0 if the system gives no times.
double idle_processors();

}  // namespace voussoir::io
