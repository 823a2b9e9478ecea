// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
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
  bool plain = false;  // drawn by the program itself (plain/plain_scene.h), though there may be a Chromium
};

/// Writes pictures of a run, or of two side by side, as its report page shows it, with title, time, scale and legend:
/// FOLDER/VIEW-TIMEs.png, as "front-2.8s.png", for every view and time. Where Chromium is missing those of one run are plain.
/// \param runs  one or two run.h5 \throw cases::InputError for a time outside the first run, or plain ones of two; FileError if a picture
/// exists and may not be replaced (all before anything is drawn), or NoBrowser for two runs
void write_stills(const std::vector<std::string>& runs, const StillsOptions& o);

/// What is seen of a model before any run.
struct ModelPicture {
  std::string run;                   // a run.h5 without frames
  std::string text;                  // as the page has it: why the model is refused, and findings
  std::vector<std::int32_t> faults;  // elements at fault
  std::string view = "corner";       // one of kViews
  bool plain = false;                // as in StillsOptions
};
/// Writes a picture of a model, plain where Chromium is missing. \throw FileError
void write_still(const ModelPicture& picture, const Output& output);

}  // namespace voussoir::io
