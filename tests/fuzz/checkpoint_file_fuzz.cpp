// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>

#include "tests/fuzz/checkpoint_image.h"

// How a checkpoint is written down. The first byte chooses: the bytes as a file, which have to get past the seal; a good file on disk with
// bytes changed, which the seal has to tell; or a checkpoint behind a seal that holds, with one fault of structure and any values. What is
// taken is finite, rises where it should, refers to what there is, and is no larger than the file. HDF5's own bytes are left alone: of
// those it believes too much (README.md), which is what the seal is for.

namespace {

using namespace voussoir;

constexpr std::size_t kHead = 2, kChange = 9;  // bytes: object and fault; place and value
constexpr std::size_t kOnDisk = 3;             // bytes of a change: place, what is put on the byte there

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

std::size_t bytes_of(const cases::StonePiece& p) {
  const auto is_one_of = [](std::size_t n) { return [n](std::int32_t i) { return i >= 0 && static_cast<std::size_t>(i) < n; }; };
  require(std::ranges::all_of(p.beds, is_one_of(p.shape.faces.size())));
  std::size_t corners = 0;
  for (const auto& face : p.shape.faces) {
    require(face.size() >= 3 && std::ranges::all_of(face, is_one_of(p.shape.vertices.size())));
    corners += face.size();
  }
  for (const Vec3& v : p.shape.vertices) require(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z));
  return 3 * sizeof(double) * p.shape.vertices.size() + sizeof(std::int32_t) * (corners + p.shape.faces.size() + p.beds.size());
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
    require(h.rotation.empty() || h.rotation.size() == h.time.size());
    bytes += (h.time.size() * 4 + h.rotation.size() * 3) * sizeof(double);
  }
  for (const auto& stones : c.facts.stones)
    for (const cases::Stone& s : stones)
      for (const cases::StonePiece& p : s.pieces) bytes += bytes_of(p);
  require(finite(c.facts.step) && c.facts.step > 0.0 && finite(c.facts.time) && bytes <= file_bytes);
}

/// A checkpoint on disk.
class GoodFile {
 public:
  GoodFile() {
    fuzz::Scribe good(0, fuzz::Fault::none);
    const io::Checkpoint c = io::parse_sealed_checkpoint("good", good.write().bytes);
    std::vector<double> values(100, 0.5);
    const solver::Field field{"pose", "m", "element", solver::FieldType::f64, values.data(), values.size()};
    const fuzz::MemoryFile written;
    io::write_checkpoint(written.path(), c.facts, {&field, 1});
    bytes_ = io::test::bytes_of(written.path());
  }

  void read(std::span<const std::uint8_t> changes) {
    std::vector<std::byte> bytes = bytes_;
    for (; changes.size() >= kOnDisk; changes = changes.subspan(kOnDisk))
      bytes[(changes[0] + 256U * changes[1]) * 31U % bytes.size()] ^= std::byte{changes[2]};
    file_.fill(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    const bool changed = bytes != bytes_;
    try {
      check(io::read_checkpoint(file_.path()), bytes.size());
      require(!changed);
    } catch (const io::FileError&) {
      require(changed);
    }
  }

 private:
  std::vector<std::byte> bytes_;
  fuzz::MemoryFile file_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Images images;
  if (size < kHead) return 0;
  try {
    if (data[0] == 255) {
      io::parse_checkpoint("fuzz", std::as_bytes(std::span(data + 1, size - 1)));
    } else if (data[0] == 254) {
      static GoodFile good;
      good.read({data + 1, size - 1});
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
