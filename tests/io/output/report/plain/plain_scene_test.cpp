// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/pictures/plain/plain_scene.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "io/input/files/errors.h"
#include "io/output/replay/run_file.h"
#include "tests/io/sample_runs.h"
#include "tests/io/temp_folder.h"

namespace voussoir::io {
namespace {

/// A sample of fuzzing, as the results of a run.
std::string run_of(const TempFolder& folder, const std::string& sample) {
  const std::vector<std::byte> bytes = test::unpacked(VOUSSOIR_SOURCE_DIR "/tests/fuzz/samples/" + sample + ".h5.gz");
  std::filesystem::create_directories(folder.path(sample));
  const std::string file = folder.path(sample + "/run.h5");
  std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return file;
}

/// Shares of the picture's pixels that are of the red of cracks and broken faces, and of a colour of wood or adobe.
struct Seen {
  double red = 0.0, brown = 0.0;
};
Seen seen(const Image& image) {
  Seen s;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    const int r = image.rgb[i], g = image.rgb[i + 1], b = image.rgb[i + 2];
    s.red += r > 3 * g && r > 3 * b ? 1.0 : 0.0;
    s.brown += r > g + 8 && g > b + 8 && r < 3 * g ? 1.0 : 0.0;
  }
  const double all = static_cast<double>(image.rgb.size()) / 3.0;
  return {s.red / all, s.brown / all};
}

}  // namespace

TEST_CASE("A picture of a run shows its elements, and red where joints have opened by then") {
  const TempFolder folder;
  const Hdf5File run = open_run(run_of(folder, "storeys"));
  const PlainScene scene(run);
  for (const char* view : {"corner", "rearcorner", "front", "rear", "left", "side", "top"}) {
    CAPTURE(view);
    const Seen before = seen(scene.picture(view, 0.0, 320, 200)), after = seen(scene.picture(view, 0.2, 320, 200));
    CHECK(before.brown > 0.05);
    CHECK(before.red == 0.0);
    CHECK(after.red > 0.01);
    CHECK(after.brown > 0.02);
  }
}

TEST_CASE("A picture shows what is at fault in red") {
  const TempFolder folder;
  const Hdf5File run = open_run(run_of(folder, "level"));
  CHECK(seen(PlainScene(run, {0, 1, 2, 3}).picture("corner", 0.0, 320, 200)).red >
        seen(PlainScene(run).picture("corner", 0.0, 320, 200)).red);
}

}  // namespace voussoir::io
