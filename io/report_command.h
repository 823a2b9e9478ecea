// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace voussoir::io {

struct ReportOptions {
  std::string folder;  // of the run
  std::string page;    // file to write; empty: report.html in the folder
  bool overwrite = false;
};

/// `voussoir report`: one HTML page that shows the run, opens from a file and asks for nothing else.
/// \throw FileError, before anything is read if the page exists and may not be replaced
int report_command(const ReportOptions& o);

}  // namespace voussoir::io
