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

/// A checkpoint in one file: all data needed to continue a run, even if the input files of the case no longer exist.
///
/// The file is HDF5 behind a seal: see sealed_file.h.
namespace voussoir::io {

/// Version of the layout of a checkpoint.
inline constexpr std::int64_t kCheckpointSchema = 8;
inline constexpr std::int64_t kOldestCheckpointSchema = 7;  // without the rotation of supports

/// All data of a checkpoint except the state.
struct CheckpointFacts {
  std::string case_toml;                        // resolved
  cases::GroundMotion motion;                   // as used: rotated, scaled, at its intensity
  std::vector<cases::SupportHistory> supports;  // of the model, in order
  Vec3 origin;                                  // m, of the model and of the stones, in the axes of the case
  StoneTables stones;                           // from the files named in the case
  double step = 0.0;                            // s, Δt
  bool reference_kernels = false;
  std::string program;           // version, compiler and flags of the writing program
  std::uint64_t model_hash = 0;  // see solver::model_hash
  double time = 0.0;             // s, of the next step
  RowCounts rows{};              // of the results up to this checkpoint
};

struct Checkpoint {
  CheckpointFacts facts;
  solver::SavedState state;
};

/// Writes a checkpoint under its final name: complete and on disk, or not at all. \throw FileError
void write_checkpoint(const std::string& path, const CheckpointFacts& facts, std::span<const solver::Field> state);

/// Reads a checkpoint. \throw DamagedFile if it is truncated, changed or no checkpoint (an older one may be used instead); FileError if it
/// cannot be read, or has another version of layout or physics, which the message names
Checkpoint read_checkpoint(const std::string& path);

/// Reads a checkpoint from memory; `name` is for messages. \throw as read_checkpoint
Checkpoint parse_checkpoint(const std::string& name, std::span<const std::byte> bytes);
/// Reads the HDF5 contents behind the seal. \throw as read_checkpoint
Checkpoint parse_sealed_checkpoint(const std::string& name, std::span<const std::byte> hdf5);

}  // namespace voussoir::io
