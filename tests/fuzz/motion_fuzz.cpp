// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "cases/case.h"
#include "cases/model.h"
#include "io/input/files/errors.h"
#include "io/input/motion/formats/read_motion.h"
#include "io/input/motion/spectra/spectra.h"
#include "io/input/motion/spectra/target_file.h"
#include "io/input/motion/support_motion.h"
#include "tests/fuzz/memory_file.h"

// The formats of motion. The first byte chooses the reader: a number of a format, or a letter. What is taken has a step and finite samples,
// and no more of them than bytes.

namespace {

using namespace voussoir;

void check(const cases::Accelerogram& a, std::size_t bytes) {
  if (!(a.dt > 0.0) || a.acceleration.size() > bytes) std::abort();
  for (const double v : a.acceleration) {
    if (!std::isfinite(v)) std::abort();
  }
}

void check(const cases::SupportHistory& h, std::size_t bytes) {
  if (h.time.size() != h.displacement.size() || h.time.size() > bytes) std::abort();
  for (std::size_t i = 1; i < h.time.size(); ++i) {
    if (!(h.time[i] > h.time[i - 1])) std::abort();
  }
}

void read_support(const std::string& path, std::size_t bytes) {
  cases::Model model;
  model.support_motions.push_back({{}, {}, false, path, ""});
  io::load_support_motions(model, "");
  check(model.support_motions[0], bytes);
}

/// One file for two supports, beside one that goes its way without a file, and for a load: supports may turn, loads may not.
void read_supports(const std::string& path, std::size_t bytes) {
  cases::Model model;
  for (const char* file : {path.c_str(), "", path.c_str()}) {
    cases::Block block;
    block.support_motion = static_cast<std::int32_t>(model.support_motions.size());
    model.blocks.push_back(std::move(block));
    model.support_motions.push_back({{0.0, 1.0}, {{}, {0.0, 0.0, -0.01}}, false, file, "block.motion"});
    if (*file != '\0') model.support_motions.back().time.clear(), model.support_motions.back().displacement.clear();
  }
  io::load_support_motions(model, "");
  check(model.support_motions[0], bytes);
  if (model.support_motions[1].time.back() != model.support_motions[0].time.back()) std::abort();
  const auto& turned = model.support_motions[2].rotation;
  if (!turned.empty() && turned.size() != model.support_motions[2].time.size()) std::abort();
  cases::Model loaded;
  loaded.support_motions.push_back({{}, {}, false, path, "load.history"}), loaded.load_history = {0};
  io::load_support_motions(loaded, "");
  if (!loaded.support_motions[0].rotation.empty()) std::abort();
}

using Reader = std::vector<io::Channel> (*)(const std::string&);
constexpr Reader kReaders[] = {io::read_bhrc, io::read_cosmos, io::read_csmip, io::read_esm, io::read_geonet, io::read_knet};
constexpr unsigned kFormats = 4 + std::size(kReaders);

void read_target(const std::string& name) {
  const io::TargetSpectrum target = io::read_target(name, "g");
  for (const double period : {0.0, 0.1, 1.0, 100.0}) {
    if (!std::isfinite(io::value_at(target, period, 0.05).value_or(0.0))) std::abort();
  }
}

/// A file whose first lines tell its format, or the ending of its name; and one of its channels, named in several ways.
void read_any(const std::string& path, std::size_t bytes) {
  const std::vector<io::Channel> channels = io::read_motion_file(path, {"g", 0.01});
  for (const io::Channel& c : channels) check(c.motion, bytes);
  for (const std::string& name :
       {std::string("#1"), std::string("#0"), "#" + (channels.empty() ? "" : channels[0].component), std::string()}) {
    for (const char axis : {'L', '\0'}) {
      try {
        static_cast<void>(io::read_channel(path + name, {"g", 0.01}, axis));
      } catch (const io::FileError&) {
      }
    }
  }
}

/// What the first byte chooses.
void read(std::uint8_t choice, const std::string& path, std::size_t bytes) {
  if (choice == 'T') return read_target(path);               // a target spectrum
  if (choice == 'S') return read_supports(path, bytes);      // ways of supports and of a load
  if (choice == 'A') return read_any(path, bytes);           // a format that its first lines tell
  if (choice == 'C') return read_any(path + ".csv", bytes);  // or CSV
  switch (choice % kFormats) {
    case 0:
      return check(io::read_at2(path), bytes);
    case 1:
      return check(io::read_motion_csv(path, "g"), bytes);
    case 2:
      return check(io::read_motion_csv(path, std::nullopt), bytes);
    case 3:
      return read_support(path, bytes);
    default:
      for (const io::Channel& c : kReaders[choice % kFormats - 4](path)) check(c.motion, bytes);
  }
}

/// A second name of a file, as long as this lasts.
class LinkedFile {
 public:
  LinkedFile(const std::string& path, std::string name) : name_(std::move(name)) {
    if (::link(path.c_str(), name_.c_str()) != 0) std::abort();
  }
  LinkedFile(const LinkedFile&) = delete;
  LinkedFile& operator=(const LinkedFile&) = delete;
  ~LinkedFile() { ::unlink(name_.c_str()); }

 private:
  std::string name_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static fuzz::MemoryFile file;
  static const LinkedFile as_csv(file.path(), file.path() + ".csv");
  if (size == 0) return 0;
  file.fill(data + 1, size - 1);
  try {
    if (data[0] == 'N')
      read_target("ec8:" + std::string(reinterpret_cast<const char*>(data) + 1, size - 1));  // a target spectrum by its name
    else
      read(data[0], file.path(), size);
  } catch (const io::FileError&) {
  } catch (const cases::InputError&) {  // of --target
  }
  return 0;
}
