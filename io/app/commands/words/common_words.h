// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/app/session/views.h"
#include "io/output/results/checkpoints.h"

namespace CLI {
class App;
}

/// Options common to several commands.
namespace voussoir::io {

/// Adds -j, --threads. \param threads  unchanged without the option
void add_threads(CLI::App& command, int& threads);

/// Adds --format text|json.
void add_format(CLI::App& command, bool& json);

/// Adds --checkpoint-every, --checkpoint-simulated.
void add_checkpoints(CLI::App& command, CheckpointSchedule& schedule);

/// Adds --report, --report-every, --paraview: output at the end of a run.
void add_views(CLI::App& command, Views& views);

}  // namespace voussoir::io
