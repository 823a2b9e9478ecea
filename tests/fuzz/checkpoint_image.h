// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstring>
#include <span>
#include <string>
#include <unordered_set>
#include <vector>

#include "io/input/files/hdf5_file.h"
#include "io/output/results/checkpoint_file.h"
#include "tests/fuzz/memory_file.h"
#include "tests/io/bytes_of.h"

/// HDF5 files of small checkpoints, each with one fault of structure at most, and where in them the values lie.
namespace voussoir::fuzz {

enum class Fault : std::uint8_t { none, missing, text, group, floats, bytes, empty, scalar, deep, longer };
inline constexpr std::size_t kFaults = 10;

struct Image {
  std::vector<std::byte> bytes;
  std::vector<std::size_t> places;  // of values, 8 bytes each
};

/// Writes one checkpoint in which there is one of everything. All values are marks that can be found again.
class Scribe {
 public:
  /// \param spoilt  the number of the object that has the fault
  Scribe(std::size_t spoilt, Fault fault) : file_(io::Hdf5File::create(memory_.path())), spoilt_(spoilt), fault_(fault) {}

  Image write() {
    root();
    texts("/case/toml", {"title = \"" + word() + "\"\n"});
    for (const char* axis : {"/motion/x", "/motion/y", "/motion/z"}) {
      dataset(axis, io::Hdf5Type::f64, {2});
      attribute(axis, "dt", mark());
      attribute(axis, "name", word());
    }
    file_.make_group("/support");
    dataset("/support/0/time", io::Hdf5Type::f64, {2});
    dataset("/support/0/displacement", io::Hdf5Type::f64, {2, 3});
    attribute("/support/0", "open_ended", std::int64_t{1});
    dataset("/state/pose", io::Hdf5Type::f64, {3, 2});
    dataset("/state/damage", io::Hdf5Type::i64, {2});
    dataset("/state/point_face", io::Hdf5Type::i32, {4});
    dataset("/state/side_quick", io::Hdf5Type::u8, {8});
    texts("/stones/texts", {word(), word()});
    dataset("/stones/numbers", io::Hdf5Type::i32, {kStone.size()}, kStone.data());
    dataset("/stones/vertices", io::Hdf5Type::f64, {12});
    return find_marks();
  }
  [[nodiscard]] std::size_t objects() const { return at_; }

 private:
  /// A tetrahedron with one bed in one group (io/output/results/checkpoint_stones.h).
  static constexpr std::array<std::int32_t, 25> kStone{1, 1, 0, 1, 1, 4, 4, 1, 0, 3, 0, 2, 1, 3, 0, 1, 3, 3, 1, 2, 3, 3, 0, 3, 2};

  void root() {
    attribute("/", "format", std::string("voussoir checkpoint"));
    attribute("/", "physics_version", solver::kPhysicsVersion);
    attribute("/", "program", word());
    attribute("/", "model_hash", std::string("0123456789abcdef"));
    attribute("/", "kernels", std::string("fast"));
    attribute("/", "step", mark());
    attribute("/", "time", mark());
    for (std::size_t t = 0; t < io::kRowTables; ++t)
      attribute("/", std::string("rows_") + io::table_name(static_cast<io::RowTable>(t)),
                std::int64_t{1000} + static_cast<std::int64_t>(t));
  }

  Fault fault() { return at_++ == spoilt_ ? fault_ : Fault::none; }
  /// Rising numbers: whatever has to rise, does.
  double mark() { return marks_.emplace_back(1.0 + 0x1.23456789abcdp-8 * static_cast<double>(marks_.size())); }
  std::string word() { return words_.emplace_back("*word" + std::to_string(100 + words_.size())); }

  template <class T>
  void attribute(const std::string& object, const std::string& name, const T& value) {
    const Fault f = fault();
    if (f == Fault::missing || (object != "/" && !file_.exists(object))) return;
    switch (f) {
      case Fault::text:
        return file_.set_attribute(object, name, word());
      case Fault::floats:
        return file_.set_attribute(object, name, mark());
      case Fault::bytes:
        return file_.set_attribute(object, name, std::int64_t{77});
      case Fault::empty:
        return file_.set_attribute(object, name, std::span<const std::string>());
      case Fault::longer:
        return file_.set_attribute(object, name, std::vector<std::string>{word(), word()});
      default:
        return file_.set_attribute(object, name, value);
    }
  }

  /// \param list  of one text at least
  void texts(const std::string& name, std::vector<std::string> list) {
    const Fault f = fault();
    if (f == Fault::missing) return;
    if (f == Fault::group) return file_.make_group(name);
    if (f == Fault::floats || f == Fault::scalar) return fill(name, io::Hdf5Type::f64, f == Fault::scalar ? io::Shape{} : io::Shape{3});
    if (f == Fault::empty) list.clear();
    if (f == Fault::longer) list.push_back(word());
    file_.write_strings(name, list);
  }

  /// \param values  that a dataset without fault has; none: marks
  void dataset(const std::string& name, io::Hdf5Type type, io::Shape shape, const void* values = nullptr) {
    switch (fault()) {
      case Fault::missing:
        return;
      case Fault::text:
        return file_.write_strings(name, std::vector<std::string>{word()});
      case Fault::group:
        return file_.make_group(name);
      case Fault::floats:
        return fill(name, io::Hdf5Type::f32, shape);
      case Fault::bytes:
        return fill(name, type == io::Hdf5Type::u8 ? io::Hdf5Type::f64 : io::Hdf5Type::u8, shape);
      case Fault::empty:
        shape[0] = 0;
        break;
      case Fault::scalar:
        shape.clear();
        break;
      case Fault::deep:
        shape.insert(shape.end(), {2, 2});
        break;
      case Fault::longer:
        shape[0] += 1;
        break;
      case Fault::none:
        if (values != nullptr) return file_.write_dataset(name, type, shape, values);
        break;
    }
    fill(name, type, shape);
  }

  void fill(const std::string& name, io::Hdf5Type type, const io::Shape& shape) {
    std::size_t bytes = size_of(type);
    for (const std::uint64_t n : shape) bytes *= n;
    std::vector<double> values((bytes + 7) / 8);
    for (double& v : values) v = mark();
    file_.write_dataset(name, type, shape, values.data());
  }

  Image find_marks() {
    std::unordered_set<std::uint64_t> wanted;
    const auto eight_bytes = [](const void* at) {
      std::uint64_t value = 0;
      std::memcpy(&value, at, sizeof value);
      return value;
    };
    for (const double m : marks_) wanted.insert(eight_bytes(&m));
    for (const std::string& w : words_) wanted.insert(eight_bytes(w.data()));
    for (const char* w : {"01234567", "89abcdef", "fast\0\0\0"}) wanted.insert(eight_bytes(w));
    for (std::uint64_t rows = 1000; rows < 1000 + io::kRowTables; ++rows) wanted.insert(rows);
    file_.close();
    Image image{io::test::bytes_of(memory_.path()), {}};
    for (std::size_t at = 0; at + 8 <= image.bytes.size(); ++at)
      if (wanted.contains(eight_bytes(image.bytes.data() + at))) image.places.push_back(at);
    const auto stone = std::as_bytes(std::span(kStone));
    const auto found = std::search(image.bytes.begin(), image.bytes.end(), stone.begin(), stone.end());
    for (std::size_t at = 0; found != image.bytes.end() && at + 8 <= stone.size(); at += 4)
      image.places.push_back(static_cast<std::size_t>(found - image.bytes.begin()) + at);
    return image;
  }

  MemoryFile memory_;
  io::Hdf5File file_;
  std::size_t spoilt_, at_ = 0;
  Fault fault_;
  std::vector<double> marks_;
  std::vector<std::string> words_;
};

}  // namespace voussoir::fuzz
