// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/app/session/views.h"
#include "io/output/results/checkpoints.h"

namespace CLI {
class App;
}

/// Options that several commands have.
namespace voussoir::io {

/// -j, --threads. \param threads  stays as it is without the option
void add_threads(CLI::App& command, int& threads);

/// --format text|json.
void add_format(CLI::App& command, bool& json);

/// --checkpoint-every, --checkpoint-simulated.
void add_checkpoints(CLI::App& command, CheckpointSchedule& schedule);

/// --report, --report-every, --paraview: what is written at the end of a run.
void add_views(CLI::App& command, Views& views);

}  // namespace voussoir::io
