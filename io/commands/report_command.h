// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "io/report/film.h"

/// What people look at after a run: the report page, pictures of it, files for ParaView.
namespace voussoir::io {

struct ReportOptions {
  std::vector<std::string> folders;  // of the run, or of two to see side by side
  std::string output;                // file of the page, or folder of the pictures; empty: in the folder of the first run
  bool paraview = false;             // files for ParaView instead of the page
  std::vector<std::string> times;    // s, of pictures instead of the page: words of numbers with commas
  std::vector<std::string> views;    // of the pictures, or of the film; empty: corner
  FilmOptions film;                  // with a file: a film instead of the page
  bool overwrite = false;
};

/// `voussoir report`: one HTML page that shows the run, opens from a file and asks for nothing else; or what else is asked for.
/// \throw FileError, before anything is read if a file exists and may not be replaced; cases::InputError for what does not go together, and
/// times that are no numbers or that the run does not have
int report_command(const ReportOptions& o);

/// What `run` and `resume` write once they are done.
struct Views {
  bool page = false, paraview = false;
  double page_every = 0;  // s of wall-clock between two pages while the run goes on; 0: only at the end, if at all
};
/// Replaces what an earlier run of the folder left. \throw FileError
void write_views(const std::string& folder, const Views& views);

/// Rewrites report.html in the folder of a run that goes on, every so many seconds of wall-clock, but so seldom that it takes no more than
/// a twentieth of the time. What cannot be written is a warning.
class LivePage {
 public:
  LivePage(std::string folder, double every) : folder_(std::move(folder)), every_(every) {}
  /// \param now  s of wall-clock since the start
  void look(double now);

 private:
  std::string folder_;
  double every_, next_ = 0;
};

}  // namespace voussoir::io
