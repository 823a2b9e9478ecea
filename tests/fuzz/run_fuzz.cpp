// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

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

// Results of a run behind a seal that holds: a sample, changed by the input (run_image.h), sealed again and read by one of the readers. The
// first byte chooses the sample and the reader; an input of that byte alone changes nothing and is read by all.

namespace {

using namespace voussoir;

/// A folder in memory.
class Folder {
 public:
  Folder() {
    std::string name = "/dev/shm/voussoir-fuzz-XXXXXX";
    if (::mkdtemp(name.data()) == nullptr) std::abort();
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] std::filesystem::path path() const { return path_; }

 private:
  std::filesystem::path path_;
};

void write(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  std::filesystem::create_directories(path.parent_path());
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

/// A run to spoil, with a good one to compare it with.
class Sample {
 public:
  /// \param part  bytes of parts/0000.h5, empty: all rows are in run.h5 \param spoils_part  inputs change the part, not run.h5
  Sample(const std::filesystem::path& folder, std::span<const std::byte> run, std::span<const std::byte> part = {},
         bool spoils_part = false)
      : bad_(folder / "bad"), good_(folder / "good/run.h5"), spoils_part_(spoils_part) {
    for (const char* name : {"bad", "good"}) {
      write(folder / name / "run.h5", run);
      if (!part.empty()) write(folder / name / kPart, part);
    }
    run_.emplace(good_);
    if (spoils_part) part_.emplace(folder / "good" / kPart);
    summary_ = summary(io::open_run(good_));
  }

  void spoil(std::span<const std::uint8_t> edits) const {
    const std::string run = bad_ / "run.h5", part = bad_ / kPart;
    if (spoils_part_)
      write_sealed(*run_, run, {}, std::string(kPart) + " " + write_sealed(*part_, part, edits, {}) + "\n");
    else
      write_sealed(*run_, run, edits, {});
  }

  static constexpr unsigned kReaders = 6;
  /// \param reader  below kReaders
  void read(unsigned reader) const {
    const std::string run = bad_ / "run.h5";
    switch (reader) {
      case 0:
        return tried([&] { io::measures_beside(summary(io::open_run(bad_)), summary_); });
      case 1:
        return tried([&] { assess(io::open_run(run)); });
      case 2:
        return tried([&] { io::report_data(run); });
      case 3:
        return tried([&] { io::compare_files(run, good_); });
      case 4:
        return tried([&] { io::check_run(bad_); });
      default:
        return tried([&] { io::write_paraview(bad_, true); });
    }
  }
  void open() const { io::open_run(bad_); }

 private:
  static constexpr const char* kPart = "parts/0000.h5";

  /// \return the seal
  static std::string write_sealed(const fuzz::RunImage& image, const std::string& path, std::span<const std::uint8_t> edits,
                                  const std::string& part_seals) {
    image.write_edited(path, edits, part_seals);
    return image.sealed() ? io::seal_text(io::seal_pages(path)) : std::string();
  }

  std::filesystem::path bad_;
  std::string good_;
  bool spoils_part_;
  std::optional<fuzz::RunImage> run_, part_;
  std::string summary_;
};

/// One of each schema, the newest last; then a pushover, a cyclic test, a run whose rows are in a part, and that part.
std::vector<Sample> samples(const Folder& folder) {
  std::vector<Sample> all;
  const auto next = [&] { return folder.path() / std::to_string(all.size()); };
  for (int schema = io::kOldestSchema; schema <= io::test::kSampleSchemas; ++schema) all.emplace_back(next(), io::test::sample_run(schema));
  const auto kept = [](const std::string& name) {
    return io::test::unpacked(VOUSSOIR_SOURCE_DIR "/tests/fuzz/samples/" + name + ".h5.gz");
  };
  for (const char* name : {"pushover", "cyclic"}) all.emplace_back(next(), kept(name));
  for (const bool spoils_part : {false, true}) all.emplace_back(next(), kept("parted"), kept("parted-0000"), spoils_part);
  return all;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Folder folder;
  static const std::vector<Sample> all = samples(folder);
  if (size < 1) return 0;
  const Sample& sample = all[data[0] % all.size()];
  sample.spoil({data + 1, size - 1});
  if (size > 1) return sample.read(static_cast<unsigned>(data[0] / all.size()) % Sample::kReaders), 0;
  sample.open();  // unchanged: whatever is thrown ends this, since nothing would be read otherwise
  for (unsigned reader = 0; reader < Sample::kReaders; ++reader) sample.read(reader);
  return 0;
}
