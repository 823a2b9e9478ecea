// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "io/output/report/pictures/film.h"

/// Output for viewing a run: the report page, pictures of it, files for ParaView.
namespace voussoir::io {

struct ReportOptions {
  std::vector<std::string> folders;  // one run, or two for a page side by side
  std::string output;                // file of the page, or folder of the pictures; empty: the folder of the first run
  bool paraview = false;             // files for ParaView instead of the page
  std::vector<std::string> times;    // s, of pictures instead of the page: words with numbers separated by commas
  std::vector<std::string> views;    // of the pictures or the film; empty: corner
  bool plain = false;                // pictures without a browser
  FilmOptions film;                  // with a file: writes a film instead of the page
  int modes = 0;                     // number of mode shapes shown by the page
  bool overwrite = false;
};

/// `voussoir report`: writes one HTML page that shows the run and needs no other files; or the other output selected by the options.
/// \throw FileError, before anything is read if a file exists and may not be replaced; cases::InputError for options that exclude each
/// other, and for times that are no numbers or outside the run
int report_command(const ReportOptions& o);

}  // namespace voussoir::io
