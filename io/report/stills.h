// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace voussoir::io {

struct StillsOptions {
  std::vector<double> times;                 // s; of each the nearest frame is drawn
  std::vector<std::string> views{"corner"};  // of the page: corner, front, rear, side, top
  std::string folder;                        // for the pictures
  bool overwrite = false;
};

/// Pictures of a run as its report page shows it, on white: FOLDER/VIEW-TIMEs.png, as "front-2.8s.png", for every view and time.
/// \param run  a run.h5
/// \throw cases::InputError for a time that the run does not have; FileError if a picture exists and may not be replaced (both before
/// anything is drawn), or if there is no Chromium
void write_stills(const std::string& run, const StillsOptions& o);

}  // namespace voussoir::io
