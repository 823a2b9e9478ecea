// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cases/case.h"
#include "io/input/files/errors.h"
#include "io/input/files/sealed_pages.h"
#include "io/output/replay/run_file.h"
#include "io/output/report/paraview_files.h"
#include "tests/fuzz/run_image.h"
#include "tests/fuzz/run_readers.h"
#include "tests/io/bytes_of.h"
#include "tests/io/sample_runs.h"

// Results of a run behind a seal that holds: a sample, changed by the input (run_image.h), sealed again and read by one of the readers
// (run_readers.h). The first byte chooses: four bits the sample, three the reader; above 127 bytes of the sealed file are changed in place
// of what is in it. An input of that byte alone changes nothing and is read by all.

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

enum class Parts : std::uint8_t { none, kept, spoilt, lost };

/// A run to spoil, with a good one to compare it with.
class Sample {
 public:
  /// \param part  bytes of parts/0000.h5, empty: all rows are in run.h5 \param parts  spoilt: inputs change the part, not run.h5; lost: it
  /// is not beside the run to spoil
  Sample(const std::filesystem::path& folder, std::span<const std::byte> run, std::span<const std::byte> part = {},
         Parts parts = Parts::none)
      : bad_(folder / "bad"), good_(folder / "good/run.h5"), spoils_part_(parts == Parts::spoilt) {
    for (const char* name : {"bad", "good"}) {
      write(folder / name / "run.h5", run);
      if (!part.empty()) write(folder / name / kPart, part);
    }
    write(bad_ / ".lock", std::as_bytes(std::span("1\n", 2)));  // as a run leaves it; the good one is a copy
    run_.emplace(good_);
    if (spoils_part_) part_.emplace(folder / "good" / kPart);
    if (parts == Parts::lost) std::filesystem::remove(bad_ / kPart);
    const io::Hdf5File good = io::open_run(good_);
    summary_ = fuzz::summary(good);
    bad_summary_ = fuzz::summary(io::open_run(bad_));
    modes_ = good.shape("/model/element/mass").at(0);
  }

  void spoil(std::span<const std::uint8_t> edits) const {
    const std::string run = bad_ / "run.h5", part = bad_ / kPart;
    if (spoils_part_)
      write_sealed(*run_, run, {}, std::string(kPart) + " " + write_sealed(*part_, part, edits, {}) + "\n");
    else
      write_sealed(*run_, run, edits, {});
  }

  /// Changes bytes of the sealed file. \return whether it is another one then
  [[nodiscard]] bool damage(std::span<const std::uint8_t> edits) const {
    spoil({});
    const std::filesystem::path file = spoils_part_ ? bad_ / kPart : bad_ / "run.h5";
    std::vector<std::byte> bytes = io::test::bytes_of(file);
    const std::vector<std::byte> good = bytes;
    for (; edits.size() >= fuzz::kEdit; edits = edits.subspan(fuzz::kEdit)) {
      const std::size_t place = edits[3] + 256U * edits[4] + 65536U * edits[5];
      bytes[place % bytes.size()] ^= std::byte{edits[6]};
    }
    write(file, bytes);
    return bytes != good;
  }
  [[nodiscard]] bool sealed() const { return run_->sealed(); }

  static constexpr unsigned kReaders = 8;
  /// \param reader  below kReaders \param edits  of limit.json
  void read(unsigned reader, std::span<const std::uint8_t> edits) const {
    const std::string run = bad_ / "run.h5";
    switch (reader) {
      case 0:
        return tried([&] { fuzz::summary(io::open_run(bad_)); });
      case 1:
        return tried([&] { fuzz::assess(io::open_run(run)); });
      case 2:
        return tried([&] { fuzz::report(run, modes_); });
      case 3:
        return tried([&] { fuzz::compare(run, good_, summary_); });
      case 4:
        tried([&] { io::check_run(bad_); });
        return tried([&] { fuzz::go_on(bad_, good_, edits.size()); });
      case 5:
        return tried([&] { io::write_paraview(bad_, true); });
      case 6:
        return tried([&] { fuzz::assess_demand(io::open_run(run), edits.size()); });
      default:
        return tried([&] { fuzz::report_with_limit(run, edits); });
    }
  }
  void open() const { io::open_run(bad_); }
  /// The summary of the changed run, which is that of the good one, or a refusal: whatever else comes out ends this.
  void read_damaged() const {
    tried([&] {
      if (fuzz::summary(io::open_run(bad_)) != bad_summary_) std::abort();
    });
    tried([&] {
      io::check_run(bad_);
      std::abort();  // it reads all
    });
  }

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
  std::string summary_, bad_summary_;  // of the good run; of the other before it is spoilt
  std::size_t modes_ = 0;
};

constexpr std::size_t kMostSamples = 16;

/// One of each schema, the newest last; then those of samples/. New ones come last: inputs of corpora choose by number.
std::vector<Sample> samples(const Folder& folder) {
  std::vector<Sample> all;
  const auto next = [&] { return folder.path() / std::to_string(all.size()); };
  for (int schema = io::kOldestSchema; schema <= io::test::kSampleSchemas; ++schema) all.emplace_back(next(), io::test::sample_run(schema));
  const auto kept = [](const std::string& name) {
    return io::test::unpacked(VOUSSOIR_SOURCE_DIR "/tests/fuzz/samples/" + name + ".h5.gz");
  };
  for (const char* name : {"pushover", "cyclic"}) all.emplace_back(next(), kept(name));
  for (const Parts parts : {Parts::kept, Parts::spoilt}) all.emplace_back(next(), kept("parted"), kept("parted-0000"), parts);
  for (const char* name : {"storeys", "rest", "settlement", "lost", "hangs", "long", "level"}) all.emplace_back(next(), kept(name));
  all.emplace_back(next(), kept("parted"), kept("parted-0000"), Parts::lost);
  all.emplace_back(next(), kept("stopped"), kept("stopped-0000"), Parts::kept);
  if (all.size() > kMostSamples) std::abort();
  return all;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Folder folder;
  static const std::vector<Sample> all = samples(folder);
  if (size < 1) return 0;
  const Sample& sample = all[data[0] % kMostSamples % all.size()];
  const unsigned reader = data[0] / kMostSamples % Sample::kReaders;
  const std::span<const std::uint8_t> edits(data + 1, size - 1);
  if (data[0] >= kMostSamples * Sample::kReaders && sample.sealed()) {
    if (sample.damage(edits)) sample.read_damaged();
    return 0;
  }
  const bool of_limit = reader + 1 == Sample::kReaders;
  sample.spoil(of_limit ? std::span<const std::uint8_t>() : edits);
  if (size > 1) return sample.read(reader, edits), 0;
  sample.open();  // unchanged: whatever is thrown ends this, since nothing would be read otherwise
  for (unsigned r = 0; r < Sample::kReaders; ++r) sample.read(r, edits);
  return 0;
}
