// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// The only interface to HDF5. Every fault becomes a FileError with the file, the object and the reason given by HDF5 or the system.
namespace voussoir::io::hdf5 {
struct Piece;
}

namespace voussoir::io {

enum class Hdf5Type : std::uint8_t { f64, f32, u8, i32, i64 };

/// Size of one value in bytes.
[[nodiscard]] std::size_t size_of(Hdf5Type type) noexcept;

template <class T>
struct Hdf5TypeOf;
template <>
struct Hdf5TypeOf<double> {
  static constexpr Hdf5Type value = Hdf5Type::f64;
};
template <>
struct Hdf5TypeOf<float> {
  static constexpr Hdf5Type value = Hdf5Type::f32;
};
template <>
struct Hdf5TypeOf<std::uint8_t> {
  static constexpr Hdf5Type value = Hdf5Type::u8;
};
template <>
struct Hdf5TypeOf<std::int32_t> {
  static constexpr Hdf5Type value = Hdf5Type::i32;
};
template <>
struct Hdf5TypeOf<std::int64_t> {
  static constexpr Hdf5Type value = Hdf5Type::i64;
};

/// Extents of a dataset, slowest first. The first is the number of rows.
using Shape = std::vector<std::uint64_t>;

/// Storage layout of a dataset. chunk_rows = 0: contiguous. Checksum and compression need chunks, and are ignored without chunks.
struct Hdf5Layout {
  std::uint64_t chunk_rows = 0;
  bool checksum = false;  // Fletcher-32
  int deflate = 0;        // 1-9 with byte shuffle; 0: none
};

/// Layout of results: with checksums, so that readers detect damaged data.
Hdf5Layout checked_layout(std::size_t row_bytes);

/// Type and size of a dataset as declared, and its size in the file.
struct Hdf5Dataset {
  Shape shape;
  std::optional<Hdf5Type> type;  // none: not numbers of an Hdf5Type
  std::uint64_t claimed = 0;     // bytes by shape and type; the largest 64-bit number on overflow
  std::uint64_t stored = 0;      // bytes used by its values in the file
};

/// Attributes `unit` and `description` of each dataset written by this program. Without a unit no attributes are written.
struct Hdf5Note {
  std::string unit, description;
};

/// Rows [0, rows) of `dataset` in another file; `file` is relative to the folder of the referring file.
/// `dataset_rows` is the extent of that dataset.
struct VirtualSource {
  std::string file, dataset;
  std::uint64_t rows = 0, dataset_rows = 0;
};

/// A file that holds rows of another one, relative to the folder of that, and its seal (seal_text).
struct NamedPart {
  std::string file, seal;
};

class Hdf5File;
/// Called with rows that have been read, before they are used. \param data  rows of `type`, one after the other
using Inspection = std::function<void(const Hdf5File& file, const std::string& dataset, Hdf5Type type, std::uint64_t first,
                                      std::uint64_t rows, const void* data)>;

/// An open HDF5 file. Object names are paths from the root, "/a/b"; missing groups are created.
/// Files are opened without HDF5's file locks: a file under its final name is never written to.
class Hdf5File {
 public:
  /// Creates a file, replacing an existing one. \param head  bytes before the HDF5 contents that HDF5 leaves untouched: 0, 512, 1024, 2048,
  /// ...
  /// \throw FileError
  static Hdf5File create(const std::string& path, std::uint64_t head = 0);
  /// Opens a file for reading through PagedFile: of a sealed file nothing is read that is not what was written. \throw FileError (also if
  /// it is not HDF5, or no regular file); every function that reads throws DamagedFile for damaged pages
  static Hdf5File open(const std::string& path);
  /// Opens a file image in memory for reading; `name` is for messages. \throw FileError
  static Hdf5File open_in_memory(const std::string& name, std::span<const std::byte> image);

  Hdf5File(Hdf5File&& other) noexcept;
  Hdf5File& operator=(Hdf5File&& other) noexcept;
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;
  /// Closes the file; errors of the last write are ignored here, so writers call close().
  ~Hdf5File();

  /// Writes buffered data and closes. A second call has no effect. \throw FileError
  void close();
  /// Passes buffered data to the system. \throw FileError
  void flush();
  [[nodiscard]] const std::string& path() const noexcept { return path_; }
  /// Whether the file was opened for reading and is sealed page by page (sealed_pages.h).
  [[nodiscard]] bool sealed() const noexcept { return sealed_; }
  /// Its seal as text; empty if not sealed.
  [[nodiscard]] std::string seal() const;
  /// From now on all numbers that are read from a dataset of this file are given to this function, which throws if they make no sense.
  void inspect(Inspection inspection) { inspection_ = std::move(inspection); }
  /// The parts that this file names, in order, with their seals: of a file with rows in parts/. Empty: it names none. \throw FileError
  [[nodiscard]] std::vector<NamedPart> named_parts() const;
  /// Names files that hold rows of this one, with their seals.
  void name_parts(std::span<const NamedPart> parts);
  /// Files that virtual datasets take rows from, relative to the folder of this one, in alphabetical order. \throw FileError
  [[nodiscard]] std::vector<std::string> sources() const;

  void make_group(const std::string& name);
  /// Copies a group with all that is in it, under the same name. \throw FileError
  void copy_group(const Hdf5File& from, const std::string& name);
  [[nodiscard]] bool exists(const std::string& name) const;
  /// Paths of all datasets, in alphabetical order. \throw FileError for links (soft ones, or to other files), objects with two names, among
  /// them cycles, objects of other kinds, and values in other files
  [[nodiscard]] std::vector<std::string> datasets() const;
  /// Names in a group, in alphabetical order.
  [[nodiscard]] std::vector<std::string> children(const std::string& group) const;

  /// Whether the object is a group.
  [[nodiscard]] bool is_group(const std::string& name) const;
  /// Whether the object is a dataset of texts.
  [[nodiscard]] bool is_text(const std::string& name) const;

  void create_dataset(const std::string& name, Hdf5Type type, const Shape& shape, const Hdf5Layout& layout = {}, const Hdf5Note& note = {});
  /// Creates and fills a dataset; `data` has the given type. \throw FileError
  void write_dataset(const std::string& name, Hdf5Type type, const Shape& shape, const void* data, const Hdf5Layout& layout = {},
                     const Hdf5Note& note = {});
  /// Writes or reads rows [first, first + rows) of a dataset; `data` has them row by row in the given type. \throw FileError
  void write_rows(const std::string& name, Hdf5Type type, std::uint64_t first, std::uint64_t rows, const void* data);
  void read_rows(const std::string& name, Hdf5Type type, std::uint64_t first, std::uint64_t rows, void* data) const;
  /// Reads a whole dataset, converted to T. \throw FileError
  template <class T>
  [[nodiscard]] std::vector<T> read(const std::string& name) const {
    const Shape extent = shape(name);
    std::vector<T> values(count_of(name));
    read_rows(name, Hdf5TypeOf<T>::value, 0, extent.empty() ? 1 : extent[0], values.data());
    return values;
  }
  /// Number of values of a dataset, after a check that the file holds them. \throw FileError
  [[nodiscard]] std::uint64_t count_of(const std::string& name) const;
  /// Writes one string per row, of fixed length in the file (UTF-8, padded with zeros).
  void write_strings(const std::string& name, std::span<const std::string> values, const Hdf5Note& note = {});
  [[nodiscard]] std::vector<std::string> read_strings(const std::string& name) const;

  /// Creates a virtual dataset whose rows are those of the sources, in order. Other programs read rows of a missing source as NaN, or as −1
  /// (all bits set) in integers; this class refuses to. Without rows the dataset is an ordinary empty one. \param row  shape of a row,
  /// empty for a scalar
  void create_virtual(const std::string& name, Hdf5Type type, const Shape& row, std::span<const VirtualSource> sources,
                      const Hdf5Note& note = {});

  [[nodiscard]] Shape shape(const std::string& name) const;
  /// The type of a dataset. \throw FileError if its values are not numbers of an Hdf5Type
  [[nodiscard]] Hdf5Type type(const std::string& name) const;
  /// Declared and stored size of a dataset. To be checked before allocating memory, since a dataset may claim more than the file contains.
  [[nodiscard]] Hdf5Dataset describe(const std::string& name) const;

  /// Sets attributes of a group or dataset ("/": the file). Text is UTF-8 of any length.
  void set_attribute(const std::string& object, const std::string& name, const std::string& text);
  void set_attribute(const std::string& object, const std::string& name, double value);
  void set_attribute(const std::string& object, const std::string& name, std::int64_t value);
  void set_attribute(const std::string& object, const std::string& name, std::span<const std::string> texts);
  [[nodiscard]] bool has_attribute(const std::string& object, const std::string& name) const;
  [[nodiscard]] std::vector<std::string> attribute_texts(const std::string& object, const std::string& name) const;
  [[nodiscard]] std::string attribute_text(const std::string& object, const std::string& name) const;
  [[nodiscard]] double attribute_double(const std::string& object, const std::string& name) const;
  [[nodiscard]] std::int64_t attribute_int(const std::string& object, const std::string& name) const;
  /// All attributes of an object: texts unchanged, numbers as their bytes.
  [[nodiscard]] std::map<std::string, std::vector<std::string>> attributes(const std::string& object) const;

 private:
  [[nodiscard]] std::vector<std::string> attribute_names(const std::string& object) const;
  [[nodiscard]] const Hdf5File& source(const std::string& file) const;
  /// The file of a piece. \param whole  shape of the virtual dataset \throw FileError if the dataset there has not the rows of the piece
  [[nodiscard]] const Hdf5File& source(const hdf5::Piece& piece, const Shape& whole) const;

  Hdf5File(std::string path, std::int64_t handle) : path_(std::move(path)), handle_(handle) {}

  std::string path_;
  std::int64_t handle_ = -1;
  bool sealed_ = false, is_part_ = false;  // a part holds its rows itself
  bool read_only_ = false;                 // so that shapes stay what they are
  Inspection inspection_;
  mutable std::map<std::string, std::shared_ptr<const Hdf5File>> sources_;  // opened, by name
  mutable std::map<std::string, Shape> shapes_;                             // asked for, of a file that is read only
};

}  // namespace voussoir::io
