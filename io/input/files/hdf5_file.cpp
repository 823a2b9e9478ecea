// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/files/hdf5_file.h"

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>

#include "io/input/files/errors.h"
#include "io/input/files/hdf5/driver.h"
#include "io/input/files/hdf5/handle.h"
#include "io/input/files/hdf5/pieces.h"

namespace voussoir::io {
namespace {

using hdf5::Doing;
using hdf5::extent_of;
using hdf5::Handle;
using hdf5::link_properties;
using hdf5::simple_space;
using hdf5::types_of;
using hdf5::write_note;

constexpr std::size_t kMemoryStep = 4UL << 20;  // bytes by which a file in memory grows

// Version 1.8 of the format is compact and readable everywhere; virtual datasets need 1.10.
// No locks: some network file systems refuse them, and no process writes to a file that others can see.
Handle access_properties(const Doing& doing) {
  // After a write that failed for want of space HDF5 cannot close the file, and crashes when it tries once more at the end of the program.
  // This program's files are closed by then, or lost.
  [[maybe_unused]] static const herr_t once = H5dont_atexit();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  // Links to other files are not followed.
  [[maybe_unused]] static const herr_t never = H5Lunregister(H5L_TYPE_EXTERNAL);
  Handle access = doing.own(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  doing.check(H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V110));
#if H5_VERSION_GE(1, 10, 7)
  doing.check(H5Pset_file_locking(access, false, true));
#endif
  return access;
}

void select_rows(const Doing& doing, hid_t space, const Shape& shape, std::uint64_t first, std::uint64_t rows) {
  std::vector<hsize_t> start(shape.size(), 0), count(shape.begin(), shape.end());
  start[0] = first;
  count[0] = rows;
  doing.check(H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr));
}

std::optional<Hdf5Type> known_type(hid_t held) {
  using enum Hdf5Type;
  for (const Hdf5Type t : {f64, f32, u8, i32, i64})
    if (H5Tequal(held, types_of(t).file) > 0) return t;
  return std::nullopt;
}

bool is_empty(const Shape& shape) { return std::ranges::find(shape, 0U) != shape.end(); }

}  // namespace

// Layout with checksums, which cost 0.4 ms per MB. No compression: deflate takes 15 times as long as the write itself and saves a sixth.
Hdf5Layout checked_layout(std::size_t row_bytes) {
  constexpr std::size_t kChunkBytes = 256 * 1024;  // a few fit in HDF5's chunk cache of 1 MiB
  return {.chunk_rows = std::max<std::size_t>(1, kChunkBytes / std::max<std::size_t>(1, row_bytes)), .checksum = true, .deflate = 0};
}

namespace {

Handle layout_properties(const Doing& doing, const Shape& shape, const Hdf5Layout& layout) {
  Handle create = doing.own(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  // Without creation times, which would make equal runs write different files.
  doing.check(H5Pset_obj_track_times(create, false));
  if (layout.chunk_rows == 0 || shape.empty() || is_empty(shape)) return create;
  std::vector<hsize_t> chunk(shape.begin(), shape.end());
  chunk[0] = std::min<hsize_t>(layout.chunk_rows, shape[0]);
  doing.check(H5Pset_chunk(create, static_cast<int>(chunk.size()), chunk.data()));
  if (layout.deflate > 0) {
    doing.check(H5Pset_shuffle(create));
    doing.check(H5Pset_deflate(create, static_cast<unsigned>(layout.deflate)));
  }
  if (layout.checksum) doing.check(H5Pset_fletcher32(create));
  return create;
}

/// Rows [first, first + rows) of an open dataset and the dataspace in memory; all of a scalar.
struct Rows {
  Handle dataset, space, memory;
  bool empty;
  Rows(const Doing& doing, hid_t file, std::uint64_t first, std::uint64_t rows)
      : dataset(doing.own(H5Dopen2(file, doing.object.c_str(), H5P_DEFAULT), H5Dclose)),
        space(doing.own(H5Dget_space(dataset), H5Sclose)),
        memory(doing.own(H5Scopy(space), H5Sclose)),
        empty(rows == 0) {
    Shape shape = extent_of(doing, dataset);
    empty = empty || is_empty(shape);
    if (empty || shape.empty()) return;
    select_rows(doing, space, shape, first, rows);
    shape[0] = rows;
    doing.check(
        H5Sset_extent_simple(memory, static_cast<int>(shape.size()), std::vector<hsize_t>(shape.begin(), shape.end()).data(), nullptr));
  }
};

}  // namespace

std::size_t size_of(Hdf5Type type) noexcept {
  using enum Hdf5Type;
  return type == f64 || type == i64 ? 8 : type == f32 || type == i32 ? 4 : 1;
}

Hdf5File Hdf5File::create(const std::string& path, std::uint64_t head) {
  const Doing doing{path, "create the file", ""};
  const Handle access = access_properties(doing);
  const Handle create = doing.own(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  doing.check(H5Pset_userblock(create, head));
  const hid_t id = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, create, access);
  doing.check(id < 0 ? -1 : 0);
  return {path, id};
}

Hdf5File Hdf5File::open(const std::string& path) {
  const Doing doing{path, "open the file", ""};
  const Handle access = access_properties(doing);
  doing.check(hdf5::use_paged_files(access));
  const hid_t id = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access);
  doing.check(id < 0 ? -1 : 0);
  Hdf5File file(path, id);
  file.sealed_ = hdf5::paged_file(id).sealed();
  file.read_only_ = true;
  return file;
}

Hdf5File Hdf5File::open_in_memory(const std::string& name, std::span<const std::byte> image) {
  const Doing doing{name, "open the file", ""};
  const Handle access = access_properties(doing);
  doing.check(H5Pset_fapl_core(access, kMemoryStep, false));
  // HDF5 copies the image, although the parameter is not const.
  doing.check(H5Pset_file_image(access, const_cast<std::byte*>(image.data()), image.size()));
  // A name that does not exist, since HDF5 refuses the name of an existing file.
  const hid_t id = H5Fopen((name + "/in memory").c_str(), H5F_ACC_RDONLY, access);
  doing.check(id < 0 ? -1 : 0);
  return {name, id};
}

Hdf5File::Hdf5File(Hdf5File&& other) noexcept
    : path_(std::move(other.path_)),
      handle_(std::exchange(other.handle_, -1)),
      sealed_(other.sealed_),
      is_part_(other.is_part_),
      read_only_(other.read_only_),
      inspection_(std::move(other.inspection_)),
      sources_(std::move(other.sources_)),
      shapes_(std::move(other.shapes_)) {}

Hdf5File& Hdf5File::operator=(Hdf5File&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(handle_, other.handle_);
  std::swap(sealed_, other.sealed_);
  std::swap(is_part_, other.is_part_);
  std::swap(read_only_, other.read_only_);
  std::swap(inspection_, other.inspection_);
  std::swap(sources_, other.sources_);
  std::swap(shapes_, other.shapes_);
  return *this;
}

Hdf5File::~Hdf5File() {
  if (handle_ >= 0) H5Fclose(handle_);
}

void Hdf5File::close() {
  if (handle_ < 0) return;
  Doing{path_, "write the file", ""}.check(H5Fclose(std::exchange(handle_, -1)));
}

void Hdf5File::flush() { Doing{path_, "write the file", ""}.check(H5Fflush(handle_, H5F_SCOPE_LOCAL)); }

void Hdf5File::make_group(const std::string& name) {
  const Doing doing{path_, "create group", name};
  if (exists(name)) return;
  const Handle group = doing.own(H5Gcreate2(handle_, name.c_str(), link_properties(doing), H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
}

void Hdf5File::copy_group(const Hdf5File& from, const std::string& name) {
  const Doing reading{from.path_, "read", name};
  const herr_t done = H5Ocopy(from.handle_, name.c_str(), handle_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  reading.check_reads();
  Doing{path_, "write", name}.check(done);
}

bool Hdf5File::exists(const std::string& name) const {
  // Every group of the path is tested, as HDF5 requires.
  for (std::size_t end = name.find('/', 1);; end = name.find('/', end + 1)) {
    const std::string head = name.substr(0, end);
    const htri_t there = head == "/" ? 1 : H5Lexists(handle_, head.c_str(), H5P_DEFAULT);
    Doing{path_, "read", name}.check_reads();
    if (there <= 0) return false;
    if (end == std::string::npos) return true;
  }
}

std::string Hdf5File::seal() const { return sealed_ ? seal_text(hdf5::paged_file(handle_).seal()) : ""; }

bool Hdf5File::is_group(const std::string& name) const {
  const Doing doing{path_, "read", name};
  const Handle object = doing.own(H5Oopen(handle_, name.c_str(), H5P_DEFAULT), H5Oclose);
  return H5Iget_type(object) == H5I_GROUP;
}

bool Hdf5File::is_text(const std::string& name) const {
  const Doing doing{path_, "read", name};
  const Handle dataset = doing.own(H5Dopen2(handle_, name.c_str(), H5P_DEFAULT), H5Dclose);
  return H5Tget_class(doing.own(H5Dget_type(dataset), H5Tclose)) == H5T_STRING;
}

void Hdf5File::create_dataset(const std::string& name, Hdf5Type type, const Shape& shape, const Hdf5Layout& layout, const Hdf5Note& note) {
  write_dataset(name, type, shape, nullptr, layout, note);
}

void Hdf5File::write_dataset(const std::string& name, Hdf5Type type, const Shape& shape, const void* data, const Hdf5Layout& layout,
                             const Hdf5Note& note) {
  const Doing doing{path_, "write", name};
  const Handle space = simple_space(doing, shape);
  const Handle create = layout_properties(doing, shape, layout);
  const Handle links = link_properties(doing);
  const Handle dataset = doing.own(H5Dcreate2(handle_, name.c_str(), types_of(type).file, space, links, create, H5P_DEFAULT), H5Dclose);
  write_note(doing, dataset, note);
  if (data != nullptr && !is_empty(shape)) doing.check(H5Dwrite(dataset, types_of(type).memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, data));
}

void Hdf5File::write_rows(const std::string& name, Hdf5Type type, std::uint64_t first, std::uint64_t rows, const void* data) {
  const Doing doing{path_, "write", name};
  const Rows part(doing, handle_, first, rows);
  if (!part.empty) doing.check(H5Dwrite(part.dataset, types_of(type).memory, part.memory, part.space, H5P_DEFAULT, data));
}

void Hdf5File::read_rows(const std::string& name, Hdf5Type type, std::uint64_t first, std::uint64_t rows, void* data) const {
  const Doing doing{path_, "read", name};
  const Rows part(doing, handle_, first, rows);
  const std::vector<hdf5::Piece> pieces = hdf5::pieces_of(doing, part.dataset);
  if (!pieces.empty()) {
    if (is_part_) throw FileError(path_, name + " has its rows in other files; not followed from a part");
    const Shape whole = extent_of(doing, part.dataset);
    auto* to = static_cast<char*>(data);
    std::uint64_t bytes = size_of(type);
    for (std::size_t i = 1; i < whole.size(); ++i) bytes *= whole[i];
    for (const hdf5::Piece& p : pieces) {
      const std::uint64_t from = std::max(first, p.first), to_row = std::min(first + rows, p.first + p.rows);
      if (from < to_row) source(p, whole).read_rows(p.dataset, type, from - p.first, to_row - from, to + (from - first) * bytes);
    }
  } else if (!part.empty) {
    doing.check(H5Dread(part.dataset, types_of(type).memory, part.memory, part.space, H5P_DEFAULT, data));
  }
  if (inspection_ && !part.empty) inspection_(*this, name, type, first, rows, data);
}

void Hdf5File::create_virtual(const std::string& name, Hdf5Type type, const Shape& row, std::span<const VirtualSource> sources,
                              const Hdf5Note& note) {
  const Doing doing{path_, "create", name};
  Shape shape(1 + row.size(), 0);
  std::ranges::copy(row, shape.begin() + 1);
  for (const VirtualSource& s : sources) shape[0] += s.rows;
  if (is_empty(shape)) return create_dataset(name, type, shape, {}, note);
  const Handle create = layout_properties(doing, shape, {});
  std::array<unsigned char, 8> bits{};
  bits.fill(0xff);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const bool real = type == Hdf5Type::f64 || type == Hdf5Type::f32;
  doing.check(real ? H5Pset_fill_value(create, H5T_NATIVE_DOUBLE, &nan) : H5Pset_fill_value(create, types_of(type).memory, bits.data()));
  const Handle space = simple_space(doing, shape);
  std::uint64_t first = 0;
  for (const VirtualSource& s : sources) {
    if (s.rows == 0) continue;
    Shape there = shape;
    there[0] = s.dataset_rows;
    const Handle source = simple_space(doing, there);
    select_rows(doing, source, there, 0, s.rows);
    select_rows(doing, space, shape, first, s.rows);
    doing.check(H5Pset_virtual(create, space, s.file.c_str(), hdf5::virtual_name(s.dataset).c_str(), source));
    first += s.rows;
  }
  const Handle links = link_properties(doing);
  const Handle dataset = doing.own(H5Dcreate2(handle_, name.c_str(), types_of(type).file, space, links, create, H5P_DEFAULT), H5Dclose);
  write_note(doing, dataset, note);
}

Shape Hdf5File::shape(const std::string& name) const {
  if (const auto known = shapes_.find(name); known != shapes_.end()) return known->second;
  const Doing doing{path_, "read", name};
  Shape shape = extent_of(doing, doing.own(H5Dopen2(handle_, name.c_str(), H5P_DEFAULT), H5Dclose));
  if (read_only_) shapes_.emplace(name, shape);
  return shape;
}

Hdf5Dataset Hdf5File::describe(const std::string& name) const {
  const Doing doing{path_, "read", name};
  const Handle dataset = doing.own(H5Dopen2(handle_, name.c_str(), H5P_DEFAULT), H5Dclose);
  const Handle type = doing.own(H5Dget_type(dataset), H5Tclose);
  Hdf5Dataset d{extent_of(doing, dataset), known_type(type), H5Tget_size(type), H5Dget_storage_size(dataset)};
  if (is_empty(d.shape)) d.claimed = 0;
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  for (const std::uint64_t n : d.shape) d.claimed = n > 0 && d.claimed > kMost / n ? kMost : d.claimed * n;
  return d;
}

Hdf5Type Hdf5File::type(const std::string& name) const {
  const Doing doing{path_, "read", name};
  const Handle dataset = doing.own(H5Dopen2(handle_, name.c_str(), H5P_DEFAULT), H5Dclose);
  const std::optional<Hdf5Type> type = known_type(doing.own(H5Dget_type(dataset), H5Tclose));
  if (!type) throw FileError(path_, name + " holds no numbers of a known type");
  return *type;
}

}  // namespace voussoir::io
