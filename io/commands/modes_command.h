// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "io/case_file/case_file.h"

namespace voussoir::io {

struct ModesOptions {
  int count = 6;
  std::string shapes;       // file for ParaView; empty: none
  bool no_impulse = false;  // eigenvalues only: seconds instead of minutes
  bool closed = false;      // joints without a bond count as if bonded, in the eigenvalues
  bool overwrite = false, quiet = false;
};

/// `voussoir modes`: first natural frequencies from the eigenvalues of the assembled stiffness, and from the impulse and Fourier transform
/// of the paper's section 3.5 at the points that the case follows (without any: the element that the mode with the largest share of mass
/// moves most).
/// \throw cases::InputError, FileError, solver::NumericalError
int modes_command(const LoadedCase& c, const ModesOptions& o);

}  // namespace voussoir::io
