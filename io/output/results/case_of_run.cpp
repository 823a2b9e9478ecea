// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/results/case_of_run.h"

#include <string>

#include "cases/case.h"
#include "cases/solids/origin.h"
#include "io/input/case_file/case_file.h"
#include "io/input/files/errors.h"
#include "io/input/motion/motion_files.h"
#include "io/output/replay/frame_reader.h"

namespace voussoir::io {

cases::Case case_of_run(const Hdf5File& run) {
  try {
    cases::Case c = read_case({run.path() + ", /case", run.attribute_text("/case", "toml")}).value;
    cases::move_origin(c, origin_of_run(run));
    return c;
  } catch (const cases::InputError& e) {
    throw FileError(run.path(), std::string("its case cannot be read: ") + e.what());
  }
}

cases::GroundMotion base_of_run(const Hdf5File& run, const cases::Case& c) {
  if (!run.exists("/motion/acceleration")) return ground_motion(c);
  const auto time = run.read<double>("/motion/time"), a = run.read<double>("/motion/acceleration");
  if (time.size() < 2 || a.size() != 3 * time.size()) throw FileError(run.path(), "/motion does not fit together");
  cases::GroundMotion base;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    base.axis[axis] = {std::string(1, "xyz"[axis]), (time.back() - time.front()) / static_cast<double>(time.size() - 1), {}};
    for (std::size_t i = 0; i < time.size(); ++i) base.axis[axis].acceleration.push_back(a[3 * i + axis]);
  }
  return base;
}

}  // namespace voussoir::io
