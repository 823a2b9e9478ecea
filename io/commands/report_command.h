// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "io/report/stills.h"

/// What people look at after a run: the report page, pictures of it, files for ParaView.
namespace voussoir::io {

struct ReportOptions {
  std::string folder;     // of the run
  std::string output;     // file of the page, or folder of the pictures; empty: report.html or stills/ in the folder
  bool paraview = false;  // files for ParaView instead of the page
  StillsOptions stills;   // with times: pictures instead of the page; its folder is `output`
  bool overwrite = false;
};

/// `voussoir report`: one HTML page that shows the run, opens from a file and asks for nothing else; or what else is asked for.
/// \throw FileError, before anything is read if a file exists and may not be replaced; cases::InputError for times that the run does not
/// have
int report_command(const ReportOptions& o);

/// What `run` and `resume` write once they are done.
struct Views {
  bool page = false, paraview = false;
};
/// Replaces what an earlier run of the folder left. \throw FileError
void write_views(const std::string& folder, const Views& views);

}  // namespace voussoir::io
