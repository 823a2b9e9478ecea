// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/assess/case_of_run.h"

#include <string>

#include "io/case_file/case_file.h"
#include "io/files/errors.h"

namespace voussoir::io {

cases::Case case_of_run(const Hdf5File& run) {
  try {
    return read_case({run.path() + ", /case", run.attribute_text("/case", "toml")}).value;
  } catch (const cases::InputError& e) {
    throw FileError(run.path(), std::string("its case cannot be read: ") + e.what());
  }
}

}  // namespace voussoir::io
