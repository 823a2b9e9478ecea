// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <istream>

/// How many of the processors that this program may use have nothing to do.
namespace voussoir::io {

/// Of some processors together, since the machine was started.
struct ProcessorTimes {
  double idle = 0.0, all = 0.0;  // ticks
  int processors = 0;
};

/// \param stat  text of /proc/stat (proc(5))
/// \param counts  whether a processor is to be counted, by its number
ProcessorTimes read_processor_times(std::istream& stat, const std::function<bool(int)>& counts);

/// Between two readings; 0 if no time has passed.
double idle_between(const ProcessorTimes& before, const ProcessorTimes& after);

/// Looks for a tenth of a second. Processors that the program may not use (a job on a part of a node) do not count; 0 if the system does
/// not say.
double idle_processors();

}  // namespace voussoir::io
