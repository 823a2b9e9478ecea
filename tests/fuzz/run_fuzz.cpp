// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "cases/case.h"
#include "io/input/files/errors.h"
#include "io/input/files/sealed_pages.h"
#include "io/output/assess/assess_words.h"
#include "io/output/assess/crack_map.h"
#include "io/output/measures/capacity/capacity_file.h"
#include "io/output/measures/compared_measures.h"
#include "io/output/measures/measures_file.h"
#include "io/output/measures/place_in_run.h"
#include "io/output/replay/run_file.h"
#include "io/output/report/paraview_files.h"
#include "io/output/report/report_data.h"
#include "io/output/results/case_of_run.h"
#include "io/output/results/comparison.h"
#include "tests/fuzz/run_image.h"
#include "tests/io/sample_runs.h"

// Results of a run behind a seal that holds: a sample of each schema, changed by the input (run_image.h), sealed again and read by all
// readers. The first byte chooses the sample.

namespace {

using namespace voussoir;

/// A folder in memory, with a run.h5 to spoil and a good one to compare it with.
class Folder {
 public:
  Folder() {
    std::string name = "/dev/shm/voussoir-fuzz-XXXXXX";
    if (::mkdtemp(name.data()) == nullptr) std::abort();
    path_ = name;
    std::filesystem::create_directory(path_ / "bad");
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] std::string bad() const { return (path_ / "bad").string(); }
  [[nodiscard]] std::string run() const { return (path_ / "bad/run.h5").string(); }
  [[nodiscard]] std::string good(int schema) const { return (path_ / ("good-" + std::to_string(schema) + ".h5")).string(); }

 private:
  std::filesystem::path path_;
};

void write(const std::string& path, std::span<const std::byte> bytes) {
  std::ofstream out(path, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!out.flush()) std::abort();
}

/// Runs a reader, which may refuse a file, but in the program's own words.
template <class Read>
void tried(Read read) {
  try {
    read();
  } catch (const io::FileError&) {
  } catch (const cases::InputError&) {
  }
}

std::string summary(const io::Hdf5File& run) {
  const io::Measures m = io::measure(run);
  const auto capacity = io::capacity_of(run);
  auto out = nlohmann::json::parse(io::measures_json(m));
  if (capacity) out["capacity"] = nlohmann::json::parse(io::capacity_json(*capacity, true)), io::capacity_text(*capacity);
  if (!m.series.time.empty()) io::place_in_run(io::case_of_run(run), m.series.time.back());
  return out.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void assess(const io::Hdf5File& run) {
  const cases::Case c = io::case_of_run(run);
  const io::Building building = io::building_of(run);
  const io::Assessment a = io::assess(run, c, building, std::nullopt, {});
  const cases::GroundMotion base = io::base_of_run(run, c);
  std::vector<std::string> names;
  for (const cases::HistoryPoint& h : c.output.history) names.push_back(h.name);
  const auto points = io::floor_accelerations(run, names, base);
  if (nlohmann::json::parse(io::assessment_json(a, points, base)).empty()) std::abort();
  io::assessment_text(a, points, base);
  for (std::size_t w = 0; w < building.walls.size(); ++w)
    io::crack_map(run, c.title, building, static_cast<std::int32_t>(w), a.time, a.joints, a.fallen, a.cracks);
}

void read_all(const Folder& at, const std::string& good, const std::string& good_summary) {
  tried([&] { io::measures_beside(summary(io::open_run(at.bad())), good_summary); });
  tried([&] { assess(io::open_run(at.run())); });
  tried([&] { io::report_data(at.run()); });
  tried([&] { io::compare_files(at.run(), good); });
  tried([&] { io::check_run(at.bad()); });
  tried([&] { io::write_paraview(at.bad(), true); });
}

/// The samples in order of their schema, the newest last.
struct Samples {
  Folder folder;
  std::vector<fuzz::RunImage> images;
  std::vector<int> schemas;
  std::vector<std::string> summaries;

  Samples() {
    for (int schema = io::kOldestSchema; schema <= io::test::kSampleSchemas; ++schema) {
      schemas.push_back(schema);
      write(folder.good(schema), io::test::sample_run(schema));
      images.emplace_back(folder.good(schema));
      summaries.push_back(summary(io::open_run(folder.good(schema))));
    }
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Samples samples;
  if (size < 1) return 0;
  const std::size_t which = data[0] % samples.images.size();
  const fuzz::RunImage& image = samples.images[which];
  image.write_edited(samples.folder.run(), {data + 1, size - 1});
  if (image.sealed()) io::seal_pages(samples.folder.run());
  if (size == 1) io::open_run(samples.folder.run());  // unchanged: whatever is thrown ends this, since nothing would be read otherwise
  read_all(samples.folder, samples.folder.good(samples.schemas[which]), samples.summaries[which]);
  return 0;
}
