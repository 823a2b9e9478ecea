// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "io/output/report/pictures/film.h"

/// What people look at after a run: the report page, pictures of it, files for ParaView.
namespace voussoir::io {

struct ReportOptions {
  std::vector<std::string> folders;  // of the run, or of two to see side by side
  std::string output;                // file of the page, or folder of the pictures; empty: in the folder of the first run
  bool paraview = false;             // files for ParaView instead of the page
  std::vector<std::string> times;    // s, of pictures instead of the page: words of numbers with commas
  std::vector<std::string> views;    // of the pictures, or of the film; empty: corner
  FilmOptions film;                  // with a file: a film instead of the page
  int modes = 0;                     // how many mode shapes the page shows, too
  bool overwrite = false;
};

/// `voussoir report`: one HTML page that shows the run, opens from a file and asks for nothing else; or what else is asked for.
/// \throw FileError, before anything is read if a file exists and may not be replaced; cases::InputError for what does not go together, and
/// times that are no numbers or that the run does not have
int report_command(const ReportOptions& o);

}  // namespace voussoir::io
