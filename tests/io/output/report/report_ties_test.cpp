// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/damage/report_ties.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "io/input/files/hdf5_file.h"
#include "tests/io/temp_folder.h"

namespace voussoir::io {

TEST_CASE("the page draws each tie until it breaks") {
  const TempFolder folder;
  const std::vector<std::string> names{"a", "b", "c"};
  const std::vector<double> time{-0.1, 0.0, 0.1, 0.2, 0.3};
  const std::vector<std::uint8_t> broken{0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 1};
  {
    Hdf5File file = Hdf5File::create(folder.path("run.h5"));
    file.write_strings("/model/tie", names);
    file.close();
  }
  const float never = std::numeric_limits<float>::infinity();
  CHECK(tie_ends_of_life(Hdf5File::open(folder.path("run.h5"))) == std::vector<float>{never, never, never});
  {
    Hdf5File file = Hdf5File::create(folder.path("run.h5"));
    file.write_strings("/model/tie", names);
    file.write_dataset("/history/time", Hdf5Type::f64, {5}, time.data());
    file.write_dataset("/ties/broken", Hdf5Type::u8, {5, 3}, broken.data());
    file.close();
  }
  CHECK(tie_ends_of_life(Hdf5File::open(folder.path("run.h5"))) == std::vector<float>{never, 0.1F, 0.3F});
}

}  // namespace voussoir::io
