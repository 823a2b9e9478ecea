// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "solver/analysis/modes.h"

/// Pages and files of a run's results for people: report.html, and files for ParaView.
namespace voussoir::io {

/// Writes the report page of one run, or of two side by side, and says where. \param modes  see report_html \throw FileError if it exists
/// and may not be replaced
void write_page(const std::vector<std::string>& runs, const std::string& page, bool overwrite, const std::vector<solver::Mode>& modes = {});

/// Writes run.xdmf into the folder of a run and says so. \throw FileError
void write_for_paraview(const std::string& folder, bool overwrite);

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
