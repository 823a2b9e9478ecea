// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "io/input/case_file/case_file.h"

namespace voussoir::io {

struct ViewOptions {
  std::string output;  // file of the page; empty: CASE.html in the working folder
  bool overwrite = false;
  std::string still = {};       // file of a picture, FILE.png, instead of the page; empty: none
  std::string view = "corner";  // of the picture
  bool plain = false;           // without a browser
};

/// `voussoir view`: one HTML page of the model before any run, or a picture of it: stones by material, joints by law, supports, a section.
/// A refused model is shown without joints, elements at fault in red, stones that are open, warped, ... by their surfaces.
/// Reads the stones of the case if necessary. \throw FileError, cases::InputError of a case whose elements cannot be shown
int view_command(const LoadedCase& c, const ViewOptions& o, int threads = 1);

}  // namespace voussoir::io
