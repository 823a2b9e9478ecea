// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "io/input/files/hdf5_file.h"

/// What each command does with a run that others have written, up to where it would print or write a file.
namespace voussoir::fuzz {

/// `voussoir summary`: its JSON, of a copy without its parts what is left of it. \throw io::FileError, cases::InputError, as all here
std::string summary(const io::Hdf5File& run);

/// `voussoir assess`, with crack maps and spectra of floors.
void assess(const io::Hdf5File& run);

/// `voussoir assess --demand`, of a pushover. \param which  chooses one of some spectra; 0: all of them
void assess_demand(const io::Hdf5File& run, std::size_t which);

/// `voussoir report`. \param modes  elements of the modes that it shows, which the command computes
void report(const std::string& run, std::size_t modes);

/// `voussoir report` of a run that has limit.json beside it. \param edits  change that file's text (run_image.h, kEdit)
void report_with_limit(const std::string& run, std::span<const std::uint8_t> edits);

/// `voussoir compare`. \param summary_of_good  of a run to compare with
void compare(const std::string& run, const std::string& good, const std::string& summary_of_good);

/// `voussoir resume`, as far as it reads results: which rows stay, in a copy of the folder. Done again, as after a kill, the same rows
/// stay. \param good  a run of the same model \param when  chooses up to which time
void go_on(const std::filesystem::path& folder, const std::string& good, std::size_t when);

}  // namespace voussoir::fuzz
