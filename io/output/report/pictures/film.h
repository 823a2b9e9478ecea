// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace voussoir::io {

struct FilmOptions {
  std::string file;             // .mp4, .webm or .gif; empty: no film
  double speed = 1.0;           // simulated time over film time: 0.25 is four times slower
  int rate = 25;                // frames per second, at most 50
  std::string view = "corner";  // one of kViews
  bool overwrite = false;
};

/// Writes a film of a run, or of two side by side, as the report page shows it, 1280 by 720 pixels, with title, time and legend: drawn by
/// Chromium (browser.h) and encoded by ffmpeg, the program named by the environment variable FFMPEG, else of the PATH.
/// \param runs  one or two run.h5
/// \throw cases::InputError for another kind of file; FileError if the file exists and may not be replaced, or there is no frame (before
/// anything is drawn), if Chromium or ffmpeg is missing, and for errors of ffmpeg
void write_film(const std::vector<std::string>& runs, const FilmOptions& o);

}  // namespace voussoir::io
