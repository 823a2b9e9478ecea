// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>

#include "tests/fuzz/checkpoint_image.h"

// How a checkpoint is written down. The first byte chooses: the bytes as a file, which have to get past the seal; or a checkpoint behind a
// seal that holds, with one fault of structure and any values. What is taken is finite, rises where it should, and is no larger than the
// file. HDF5's own bytes are left alone: of those it believes too much (README.md), which is what the seal is for.

namespace {

using namespace voussoir;

constexpr std::size_t kHead = 2, kChange = 9;  // bytes: object and fault; place and value

std::size_t count_of_objects() {
  fuzz::Scribe good(0, fuzz::Fault::none);
  io::parse_sealed_checkpoint("good", good.write().bytes);
  return good.objects();
}

struct Images {
  std::vector<fuzz::Image> all;  // by object, then by fault

  Images() {
    for (std::size_t object = 0; object < count_of_objects(); ++object)
      for (std::size_t f = 0; f < fuzz::kFaults; ++f) all.push_back(fuzz::Scribe(object, static_cast<fuzz::Fault>(f)).write());
  }
};

std::vector<std::byte> changed(const fuzz::Image& image, std::span<const std::uint8_t> changes) {
  std::vector<std::byte> bytes = image.bytes;
  for (; changes.size() >= kChange; changes = changes.subspan(kChange))
    std::memcpy(bytes.data() + image.places[changes[0] % image.places.size()], changes.data() + 1, kChange - 1);
  return bytes;
}

void require(bool good) {
  if (!good) std::abort();
}

void check(const io::Checkpoint& c, std::size_t file_bytes) {
  std::size_t bytes = c.facts.case_toml.size();
  for (const auto& [name, f] : c.state) {
    require(f.bytes.size() == f.count * f.columns * size_of(f.type));
    bytes += f.bytes.size();
  }
  const auto finite = [](double v) { return std::isfinite(v); };
  for (const cases::Accelerogram& a : c.facts.motion.axis) {
    require(std::ranges::all_of(a.acceleration, finite) && (a.acceleration.empty() || (finite(a.dt) && a.dt > 0.0)));
    bytes += a.acceleration.size() * sizeof(double);
  }
  for (const cases::SupportHistory& h : c.facts.supports) {
    require(h.time.size() == h.displacement.size() && h.time.size() != 1 && std::ranges::is_sorted(h.time));
    bytes += h.time.size() * 4 * sizeof(double);
  }
  require(finite(c.facts.step) && c.facts.step > 0.0 && finite(c.facts.time) && bytes <= file_bytes);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Images images;
  if (size < kHead) return 0;
  try {
    if (data[0] == 255) {
      io::parse_checkpoint("fuzz", std::as_bytes(std::span(data + 1, size - 1)));
    } else {
      const std::size_t objects = images.all.size() / fuzz::kFaults;
      const fuzz::Image& image = images.all[data[0] % objects * fuzz::kFaults + data[1] % fuzz::kFaults];
      const std::vector<std::byte> bytes = changed(image, {data + kHead, size - kHead});
      check(io::parse_sealed_checkpoint("fuzz", bytes), bytes.size());
    }
  } catch (const io::FileError&) {
  }
  return 0;
}
