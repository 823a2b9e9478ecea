// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "solver/analysis/modes.h"

/// Pages and files for viewing a run's results: report.html, and files for ParaView.
namespace voussoir::io {

/// Writes the report page of one run, or of two side by side, and prints its path. \param modes  as in report_html \throw FileError if it
/// exists and may not be replaced
void write_page(const std::vector<std::string>& runs, const std::string& page, bool overwrite, const std::vector<solver::Mode>& modes = {});

/// Writes run.xdmf into the folder of a run and prints its path. \throw FileError
void write_for_paraview(const std::string& folder, bool overwrite);

/// Output of `run` and `resume` at the end of a run.
struct Views {
  bool page = false, paraview = false;
  double page_every = 0;  // s of wall-clock time between two pages during the run; 0: only at the end, if at all
};
/// Writes the views, replacing those of an earlier run in the folder. \throw FileError
void write_views(const std::string& folder, const Views& views);

/// Rewrites report.html in the folder of an unfinished run at intervals of wall-clock time, long enough to use at most a twentieth of the
/// time. Failure to write is a warning.
class LivePage {
 public:
  LivePage(std::string folder, double every) : folder_(std::move(folder)), every_(every) {}
  /// Writes the page if due. \param now  wall-clock time since the start [s]
  void look(double now);

 private:
  std::string folder_;
  double every_, next_ = 0;
};

}  // namespace voussoir::io
