// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/files/hdf5/handle.h"

#include <hdf5.h>
#include <sys/mman.h>

#include <new>

#include "io/input/files/errors.h"
#include "io/input/files/hdf5/driver.h"

namespace voussoir::io::hdf5 {
namespace {

// The system's message within a description by HDF5, which adds times and addresses.
std::string essence(const std::string& description) {
  const std::string mark = "error message = '";
  const std::size_t at = description.find(mark);
  if (at == std::string::npos) return description;
  const std::size_t from = at + mark.size();
  return description.substr(from, description.find('\'', from) - from);
}

// The innermost entry of the error stack, which is the cause. To be read at once, since the next call of HDF5 clears the stack.
std::string reason() {
  std::string text;
  H5Ewalk2(
      H5E_DEFAULT, H5E_WALK_UPWARD,
      [](unsigned n, const H5E_error2_t* entry, void* out) -> herr_t {
        if (n == 0 && entry->desc != nullptr) *static_cast<std::string*>(out) = entry->desc;
        return 0;
      },
      &text);
  return text.empty() ? "unknown HDF5 error" : essence(text);
}

constexpr std::size_t kRoom = 8U << 20U;  // bytes, more than HDF5 takes for one call with the chunks used here

}  // namespace

Room::Room() {
  void* room = ::mmap(nullptr, kRoom, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (room == MAP_FAILED) throw std::bad_alloc();
  ::munmap(room, kRoom);
}

void Doing::check_reads() const {
  const std::exception_ptr fault = take_fault();
  if (!fault) return;
  try {
    std::rethrow_exception(fault);
  } catch (const FileError& e) {
    if (object.empty()) throw;
    const std::string said = std::string(e.what()).substr(e.path().size() + 2);
    throw DamagedFile(e.path(), std::string("cannot ") + action + " " + object + ": " + said);
  }
}

void Doing::fail() const {
  check_reads();
  const std::string why = reason();
  throw FileError(path, std::string("cannot ") + action + (object.empty() ? "" : " " + object) + ": " + why);
}

TypePair types_of(Hdf5Type type) {
  switch (type) {
    case Hdf5Type::f64:
      return {H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE};
    case Hdf5Type::f32:
      return {H5T_NATIVE_FLOAT, H5T_IEEE_F32LE};
    case Hdf5Type::u8:
      return {H5T_NATIVE_UINT8, H5T_STD_U8LE};
    case Hdf5Type::i32:
      return {H5T_NATIVE_INT32, H5T_STD_I32LE};
    case Hdf5Type::i64:
      return {H5T_NATIVE_INT64, H5T_STD_I64LE};
  }
  return {-1, -1};
}

Handle link_properties(const Doing& doing) {
  Handle links = doing.own(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  doing.check(H5Pset_create_intermediate_group(links, 1));
  return links;
}

Handle text_type(const Doing& doing, std::size_t length) {
  Handle type = doing.own(H5Tcopy(H5T_C_S1), H5Tclose);
  doing.check(H5Tset_size(type, length));
  doing.check(H5Tset_cset(type, H5T_CSET_UTF8));
  if (length != H5T_VARIABLE) doing.check(H5Tset_strpad(type, H5T_STR_NULLPAD));
  return type;
}

Handle simple_space(const Doing& doing, const Shape& shape) {
  const std::vector<hsize_t> extent(shape.begin(), shape.end());
  return doing.own(shape.empty() ? H5Screate(H5S_SCALAR) : H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr),
                   H5Sclose);
}

void write_note(const Doing& doing, std::int64_t dataset, const Hdf5Note& note) {
  if (note.unit.empty()) return;
  const Handle type = text_type(doing, H5T_VARIABLE);
  const Handle space = simple_space(doing, {});
  for (const auto& [name, text] : {std::pair{"unit", note.unit.c_str()}, std::pair{"description", note.description.c_str()}}) {
    const Handle attribute = doing.own(H5Acreate2(dataset, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    doing.check(H5Awrite(attribute, type, &text));
  }
}

Shape extent_of(const Doing& doing, hid_t dataset) {
  const Handle space = doing.own(H5Dget_space(dataset), H5Sclose);
  const int rank = H5Sget_simple_extent_ndims(space);
  doing.check(rank);
  std::vector<hsize_t> extent(static_cast<std::size_t>(rank));
  doing.check(H5Sget_simple_extent_dims(space, extent.data(), nullptr));
  return {extent.begin(), extent.end()};
}

}  // namespace voussoir::io::hdf5
