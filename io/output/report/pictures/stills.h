// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace voussoir::io {

/// From where the page can show a house.
inline const std::vector<std::string> kViews{"corner", "rearcorner", "front", "rear", "left", "side", "top", "plan"};
/// "corner, rearcorner, ...", for people.
std::string view_names();

struct StillsOptions {
  std::vector<double> times;                 // s; of each the nearest frame is drawn
  std::vector<std::string> views{"corner"};  // names of kViews
  std::string folder;                        // for the pictures
  bool overwrite = false;
};

/// Pictures of a run, or of two side by side, as its report page shows it, with title, time, scale and legend: FOLDER/VIEW-TIMEs.png, as
/// "front-2.8s.png", for every view and time. \param runs  one or two run.h5
/// \throw cases::InputError for a time that the first run does not have; FileError if a picture exists and may not be replaced (both before
/// anything is drawn), or if there is no Chromium
void write_stills(const std::vector<std::string>& runs, const StillsOptions& o);

/// A picture of the one moment that a page has, as the model of a case. \param html  the page \throw FileError if there is no Chromium
void write_still(const std::string& html, const std::string& view, const std::string& file);

}  // namespace voussoir::io
