// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "io/input/files/hdf5_file.h"

/// Shared by the sources of Hdf5File: handles and checks; not for other code. HDF5's handles are 64-bit integers, its status values ints.
namespace voussoir::io::hdf5 {

/// An HDF5 handle, closed by the destructor.
class Handle {
 public:
  using Close = int (*)(std::int64_t);
  Handle(std::int64_t id, Close close) : id_(id), close_(close) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&&) = delete;
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  operator std::int64_t() const noexcept { return id_; }

 private:
  std::int64_t id_;
  Close close_;
};

/// Memory for one call of HDF5, tried before it: the library itself ends in a segmentation fault where it gets none.
struct Room {
  /// \throw std::bad_alloc if little is left
  Room();
};

/// The current action, object and file, for messages.
struct Doing {
  const std::string& path;
  const char* action;
  const std::string& object;
  Room room{};

  /// \throw FileError with HDF5's reason if the status is negative
  void check(int status) const {
    if (status < 0) fail();
    check_reads();
  }
  /// \throw DamagedFile if a read of the file has failed, which HDF5 does not always tell
  void check_reads() const;
  /// Takes ownership of a handle. \throw FileError with HDF5's reason if the handle is negative
  [[nodiscard]] Handle own(std::int64_t id, Handle::Close close) const {
    if (id < 0) fail();
    Handle handle(id, close);
    check_reads();
    return handle;
  }
  [[noreturn]] void fail() const;
};

/// HDF5's types in memory and in the file. Not owned.
struct TypePair {
  std::int64_t memory, file;
};
TypePair types_of(Hdf5Type type);

/// Properties of links to objects whose groups may not exist yet.
Handle link_properties(const Doing& doing);
/// The type of UTF-8 text of `length` bytes; H5T_VARIABLE: any length.
Handle text_type(const Doing& doing, std::size_t length);
/// The dataspace of a shape; for an empty shape, of one value.
Handle simple_space(const Doing& doing, const Shape& shape);
/// Writes the note of a newly created dataset.
void write_note(const Doing& doing, std::int64_t dataset, const Hdf5Note& note);
Shape extent_of(const Doing& doing, std::int64_t dataset);

}  // namespace voussoir::io::hdf5
