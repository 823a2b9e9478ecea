// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "cases/model.h"
#include "cases/motion.h"
#include "io/input/files/sealed_file.h"
#include "io/output/results/checkpoint_stones.h"
#include "io/output/results/results_schema.h"
#include "solver/state/saved_state.h"

/// One checkpoint, one file: all that going on with a run needs. The files that the case was read from may be gone.
///
/// An HDF5 file behind a seal: see sealed_file.h.
namespace voussoir::io {

/// Version of the layout of a checkpoint.
inline constexpr std::int64_t kCheckpointSchema = 7;

/// Everything but the state.
struct CheckpointFacts {
  std::string case_toml;                        // resolved
  cases::GroundMotion motion;                   // as used: turned, scaled, at its intensity
  std::vector<cases::SupportHistory> supports;  // of the model, in order
  StoneTables stones;                           // of the files that the case names
  double step = 0.0;                            // s, Δt
  bool reference_kernels = false;
  std::string program;           // version, compiler and flags of the program that wrote it
  std::uint64_t model_hash = 0;  // see solver::model_hash
  double time = 0.0;             // s, of the next step
  RowCounts rows{};              // of the results up to here
};

struct Checkpoint {
  CheckpointFacts facts;
  solver::SavedState state;
};

/// Writes a checkpoint under its final name: whole and on disk, or not at all. \throw FileError
void write_checkpoint(const std::string& path, const CheckpointFacts& facts, std::span<const solver::Field> state);

/// \throw DamagedFile if it is cut off, changed or no checkpoint (an older one may serve); FileError if it cannot be read, or is of another
/// version of layout or physics, which it names
Checkpoint read_checkpoint(const std::string& path);

/// The same of a file in memory; `name` is for messages.
Checkpoint parse_checkpoint(const std::string& name, std::span<const std::byte> bytes);
/// Of what is behind the seal.
Checkpoint parse_sealed_checkpoint(const std::string& name, std::span<const std::byte> hdf5);

}  // namespace voussoir::io
