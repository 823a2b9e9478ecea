// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "io/input/files/output_path.h"

namespace voussoir::io {

/// Views of the page.
inline const std::vector<std::string> kViews{"corner", "rearcorner", "front", "rear", "left", "side", "top", "plan"};
/// "corner, rearcorner, ...", for messages.
std::string view_names();

struct StillsOptions {
  std::vector<double> times;                 // s; the nearest frame of each is drawn
  std::vector<std::string> views{"corner"};  // names of kViews
  std::string folder;                        // for the pictures
  bool overwrite = false;
};

/// Writes pictures of a run, or of two side by side, as its report page shows it, with title, time, scale and legend:
/// FOLDER/VIEW-TIMEs.png, as "front-2.8s.png", for every view and time. \param runs  one or two run.h5
/// \throw cases::InputError for a time outside the first run; FileError if a picture exists and may not be replaced (both before anything
/// is drawn), or if Chromium is missing
void write_stills(const std::vector<std::string>& runs, const StillsOptions& o);

/// Writes a picture of a page with a single frame, as of the model of a case. \param html  the page \throw FileError if Chromium is missing
void write_still(const std::string& html, const std::string& view, const Output& picture);

}  // namespace voussoir::io
