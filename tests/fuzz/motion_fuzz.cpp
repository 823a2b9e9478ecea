// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <vector>

#include "cases/model.h"
#include "io/input/files/errors.h"
#include "io/input/motion/formats/read_motion.h"
#include "io/input/motion/support_motion.h"
#include "tests/fuzz/memory_file.h"

// The formats of motion. The first byte chooses the reader. What is taken has a step and finite samples, and no more of them than bytes.

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

using Reader = std::vector<io::Channel> (*)(const std::string&);
constexpr Reader kReaders[] = {io::read_bhrc, io::read_cosmos, io::read_csmip, io::read_esm, io::read_geonet, io::read_knet};
constexpr unsigned kFormats = 4 + std::size(kReaders);

void read(unsigned format, const std::string& path, std::size_t bytes) {
  switch (format) {
    case 0:
      return check(io::read_at2(path), bytes);
    case 1:
      return check(io::read_motion_csv(path, "g"), bytes);
    case 2:
      return check(io::read_motion_csv(path, std::nullopt), bytes);
    case 3:
      return read_support(path, bytes);
    default:
      for (const io::Channel& c : kReaders[format - 4](path)) check(c.motion, bytes);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static fuzz::MemoryFile file;
  if (size == 0) return 0;
  file.fill(data + 1, size - 1);
  try {
    read(static_cast<unsigned>(data[0]) % kFormats, file.path(), size);
  } catch (const io::FileError&) {
  }
  return 0;
}
