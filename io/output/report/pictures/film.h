// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace voussoir::io {

struct FilmOptions {
  std::string file;             // .mp4, .webm or .gif; empty: no film
  double speed = 1.0;           // simulated time over that of the film: 0.25 is four times slower
  int rate = 25;                // pictures a second, at most 50
  std::string view = "corner";  // as StillsOptions::views
  bool overwrite = false;
};

/// The film of a run, or of two side by side, as the report page shows it, 1280 by 720 pixels, with title, time and legend burnt in: drawn
/// by Chromium (browser.h) and put together by ffmpeg, the program that the environment variable FFMPEG names, else of the PATH. \param
/// runs  one or two run.h5 \throw cases::InputError for a file of another kind; FileError if it exists and may not be replaced, or there is
/// no frame (before anything is drawn), if there is no Chromium or no ffmpeg, and for what ffmpeg says
void write_film(const std::vector<std::string>& runs, const FilmOptions& o);

}  // namespace voussoir::io
