// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/files/hdf5/driver.h"

#include <hdf5.h>

#include <limits>
#include <new>
#include <utility>

namespace voussoir::io::hdf5 {
namespace {

thread_local std::exception_ptr fault;

/// What HDF5 knows of an open file; `base` is its own part and has to be the first.
struct OpenFile {
  H5FD_t base{};
  PagedFile pages;
  haddr_t end_of_allocation = 0;
  explicit OpenFile(const char* path) : pages(path) {}
};

OpenFile& file_of(H5FD_t* file) { return *reinterpret_cast<OpenFile*>(file); }
const OpenFile& file_of(const H5FD_t* file) { return *reinterpret_cast<const OpenFile*>(file); }

H5FD_t* open_file(const char* path, unsigned flags, hid_t, haddr_t) {
  if ((flags & (H5F_ACC_RDWR | H5F_ACC_TRUNC | H5F_ACC_CREAT)) != 0) return nullptr;
  try {
    return &(new OpenFile(path))->base;
  } catch (...) {
    fault = std::current_exception();
    return nullptr;
  }
}

herr_t close_file(H5FD_t* file) {
  delete &file_of(file);
  return 0;
}

herr_t read_file(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t at, size_t bytes, void* to) {
  try {
    file_of(file).pages.read(at, bytes, static_cast<char*>(to));
    return 0;
  } catch (...) {
    fault = std::current_exception();
    return -1;
  }
}

herr_t write_file(H5FD_t*, H5FD_mem_t, hid_t, haddr_t, size_t, const void*) { return -1; }

herr_t query(const H5FD_t*, unsigned long* flags) {
  if (flags != nullptr) *flags = H5FD_FEAT_DATA_SIEVE;
  return 0;
}

haddr_t end_of_allocation(const H5FD_t* file, H5FD_mem_t) { return file_of(file).end_of_allocation; }

herr_t set_end_of_allocation(H5FD_t* file, H5FD_mem_t, haddr_t end) {
  file_of(file).end_of_allocation = end;
  return 0;
}

haddr_t end_of_file(const H5FD_t* file, H5FD_mem_t) { return file_of(file).pages.end(); }

herr_t handle_of(H5FD_t* file, hid_t, void** handle) {
  *handle = &file_of(file).pages;
  return 0;
}

H5FD_class_t paged_files() {
  H5FD_class_t c{};
#if H5_VERSION_GE(1, 13, 2)
  c.version = H5FD_CLASS_VERSION;
  c.value = static_cast<H5FD_class_value_t>(600);  // of those for programs' own use
#endif
  c.name = "voussoir_paged";
  c.maxaddr = static_cast<haddr_t>(std::numeric_limits<std::int64_t>::max());
  c.fc_degree = H5F_CLOSE_WEAK;
  c.open = open_file;
  c.close = close_file;
  c.query = query;
  c.get_eoa = end_of_allocation;
  c.set_eoa = set_end_of_allocation;
  c.get_eof = end_of_file;
  c.get_handle = handle_of;
  c.read = read_file;
  c.write = write_file;
  for (H5FD_mem_t& type : c.fl_map) type = H5FD_MEM_SUPER;
  return c;
}

}  // namespace

int use_paged_files(std::int64_t access_properties) {
  static const H5FD_class_t kind = paged_files();
  static const hid_t driver = H5FDregister(&kind);
  return H5Pset_driver(access_properties, driver, nullptr);
}

PagedFile& paged_file(std::int64_t file) {
  void* handle = nullptr;
  H5Fget_vfd_handle(file, H5P_DEFAULT, &handle);
  return *static_cast<PagedFile*>(handle);
}

std::exception_ptr take_fault() noexcept { return std::exchange(fault, nullptr); }

}  // namespace voussoir::io::hdf5
