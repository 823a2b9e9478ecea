// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/run_image.h"

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>

#include "tests/io/bytes_of.h"

namespace voussoir::fuzz {
namespace {

/// A handle of HDF5 that closes itself.
class Id {
 public:
  Id(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  Id(const Id&) = delete;
  Id& operator=(const Id&) = delete;
  ~Id() {
    if (id_ >= 0) close_(id_);
  }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

hid_t open_image(const std::vector<std::byte>& bytes) {
  constexpr std::size_t kStep = 64 * 1024;
  const Id access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V110);
  H5Pset_fapl_core(access, kStep, false);
  H5Pset_file_image(access, const_cast<std::byte*>(bytes.data()), bytes.size());
  return H5Fopen("image of a run", H5F_ACC_RDWR, access);
}

/// The head of an edit, and what it puts.
struct Edit {
  unsigned kind;
  std::size_t object, place;
  std::array<std::uint8_t, 8> value;

  explicit Edit(const std::uint8_t* from)
      : kind(from[0]), object(from[1] + 256U * from[2]), place(from[3] + 256U * from[4] + 65536U * from[5]) {
    std::copy_n(from + 6, value.size(), value.begin());
  }
  [[nodiscard]] double number() const {
    double v = 0;
    std::memcpy(&v, value.data(), sizeof v);
    return v;
  }
  [[nodiscard]] std::string text() const { return {value.begin(), std::ranges::find(value, 0)}; }
};

/// Some bytes of the entries of a dataset, whatever their type: one entry of numbers, or eight bytes of texts.
void put_value(hid_t file, const std::string& name, const Edit& e) {
  const Id dataset(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
  const Id create(H5Dget_create_plist(dataset), H5Pclose);
  if (H5Pget_layout(create) == H5D_VIRTUAL) return;  // its values are in another file
  const Id type(H5Dget_type(dataset), H5Tclose), space(H5Dget_space(dataset), H5Sclose);
  const hssize_t count = H5Sget_simple_extent_npoints(space);
  const std::size_t size = H5Tget_size(type);
  constexpr std::size_t kMost = 1U << 20U;
  if (count <= 0 || H5Tis_variable_str(type) > 0 || static_cast<std::size_t>(count) * size > kMost) return;
  std::vector<std::uint8_t> all(static_cast<std::size_t>(count) * size);
  if (H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()) < 0) return;
  const std::size_t unit = std::min<std::size_t>(size, e.value.size()), at = e.place % (all.size() / unit) * unit;
  std::copy_n(e.value.begin(), std::min(unit, all.size() - at), all.begin() + static_cast<std::ptrdiff_t>(at));
  H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data());
}

/// A new dataset in place of another. \param type  of the file and of memory; its values are zero, or the edit's
void replace(hid_t file, const std::string& name, hid_t type, const std::vector<hsize_t>& shape, const Edit& e) {
  H5Ldelete(file, name.c_str(), H5P_DEFAULT);
  const Id space(shape.empty() ? H5Screate(H5S_SCALAR) : H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose);
  const Id create(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  const Id dataset(H5Dcreate2(file, name.c_str(), type, space, H5P_DEFAULT, create, H5P_DEFAULT), H5Dclose);
  std::size_t count = 1;
  for (const hsize_t n : shape) count *= n;
  std::vector<std::uint8_t> values(count * H5Tget_size(type));
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = e.value[i % e.value.size()];
  if (count > 0 && H5Tis_variable_str(type) <= 0 && H5Tget_class(type) != H5T_REFERENCE && H5Tget_class(type) != H5T_VLEN)
    H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
}

std::vector<hsize_t> shape_of(hid_t file, const std::string& name) {
  const Id dataset(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
  const Id space(H5Dget_space(dataset), H5Sclose);
  std::vector<hsize_t> shape(static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space))));
  H5Sget_simple_extent_dims(space, shape.data(), nullptr);
  return shape;
}

/// Claims rows that the file does not hold.
void claim(hid_t file, const std::string& name, const Edit& e) {
  std::vector<hsize_t> shape = shape_of(file, name);
  if (shape.empty()) return;
  H5Ldelete(file, name.c_str(), H5P_DEFAULT);
  const Id create(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  std::vector<hsize_t> chunk(shape.size(), 1);
  H5Pset_chunk(create, static_cast<int>(chunk.size()), chunk.data());
  shape[0] = hsize_t{1} << (e.value[0] % 48U);
  const Id space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose);
  const Id dataset(H5Dcreate2(file, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, create, H5P_DEFAULT), H5Dclose);
}

/// Rows in a file beside this one.
void make_virtual(hid_t file, const std::string& name, const Edit& e) {
  std::vector<hsize_t> shape = shape_of(file, name);
  if (shape.empty()) return;
  H5Ldelete(file, name.c_str(), H5P_DEFAULT);
  const Id space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose);
  const Id create(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  constexpr const char* kFiles[] = {"parts/0000.h5", "run.h5", ".", "/dev/zero", "../run.h5", "parts/1.h5"};
  H5Pset_virtual(create, space, kFiles[e.value[0] % std::size(kFiles)], name.c_str(), space);
  const Id dataset(H5Dcreate2(file, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, create, H5P_DEFAULT), H5Dclose);
}

/// A dataset of another kind in place of one.
void change_kind(hid_t file, const std::string& name, const Edit& e) {
  std::vector<hsize_t> shape = shape_of(file, name);
  const Id text(H5Tcopy(H5T_C_S1), H5Tclose), any_text(H5Tcopy(H5T_C_S1), H5Tclose), pair(H5Tcreate(H5T_COMPOUND, 8), H5Tclose);
  H5Tset_size(text, 1 + e.value[1] % 16U);
  H5Tset_size(any_text, H5T_VARIABLE);
  H5Tinsert(pair, "a", 0, H5T_STD_I32LE);
  const Id lists(H5Tvlen_create(H5T_NATIVE_INT), H5Tclose);
  const std::array<hid_t, 13> types{text,           any_text,       pair,          lists,         H5T_STD_REF_OBJ,
                                    H5T_IEEE_F64LE, H5T_IEEE_F32LE, H5T_STD_I64LE, H5T_STD_I32LE, H5T_STD_U8LE,
                                    H5T_STD_I16BE,  H5T_IEEE_F64BE, H5T_STD_U64LE};
  switch (e.place % 6) {
    case 0:
      break;
    case 1:
      shape.clear();
      break;
    case 2:
      shape.assign(1, e.value[2] % 8U);
      break;
    case 3:
      if (shape.size() < 4) shape.insert(shape.end(), 2, 2);
      break;
    case 4:
      if (!shape.empty()) shape[0] = e.value[2] % 64U;
      break;
    default:
      if (shape.size() > 1) shape.pop_back();
  }
  std::size_t count = 1;
  for (const hsize_t n : shape) count *= n;
  constexpr std::size_t kMost = 1U << 16U;
  if (count <= kMost) replace(file, name, types[e.value[0] % types.size()], shape, e);
}

void change_dataset(hid_t file, const std::vector<std::string>& names, const Edit& e) {
  const std::string& name = names[e.object % names.size()];
  const std::string& other = names[(e.object + e.place + 1) % names.size()];
  if (H5Lexists(file, name.c_str(), H5P_DEFAULT) <= 0) return;
  const std::string group = name.substr(0, std::max<std::size_t>(1, name.rfind('/')));
  switch (e.kind % 16) {
    case 8:
      H5Ldelete(file, name.c_str(), H5P_DEFAULT);
      return;
    case 9:
      return change_kind(file, name, e);
    case 10:
      return claim(file, name, e);
    case 11:
      return make_virtual(file, name, e);
    case 12: {
      H5Ldelete(file, name.c_str(), H5P_DEFAULT);
      const Id made(H5Gcreate2(file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
      if (e.place % 2 == 0) H5Lcreate_hard(file, group.c_str(), made, "up", H5P_DEFAULT, H5P_DEFAULT);  // a cycle
      return;
    }
    case 13:
      H5Ldelete(file, name.c_str(), H5P_DEFAULT);
      e.place % 2 == 0 ? H5Lcreate_soft(other.c_str(), file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT)
                       : H5Lcreate_external("run.h5", other.c_str(), file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
      return;
    case 14:
      H5Ldelete(file, name.c_str(), H5P_DEFAULT);
      H5Ocopy(file, other.c_str(), file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
      return;
    case 15:
      H5Ldelete(file, group.c_str(), H5P_DEFAULT);
      return;
    default:
      return put_value(file, name, e);
  }
}

/// An attribute of text: some of it becomes the edit's.
void put_text(hid_t file, const std::string& object, const std::string& name, const Edit& e) {
  const Id attribute(H5Aopen_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  const Id type(H5Aget_type(attribute), H5Tclose), space(H5Aget_space(attribute), H5Sclose);
  if (H5Tis_variable_str(type) <= 0 || H5Sget_simple_extent_npoints(space) != 1) return;
  char* held = nullptr;
  if (H5Aread(attribute, type, &held) < 0 || held == nullptr) return;
  std::string text(held);
  H5free_memory(held);
  const std::string put = e.text();
  const std::size_t at = e.place % (text.size() + 1);
  if (e.kind % 2 == 0)
    text.replace(at, std::min(put.size(), text.size() - at), put);
  else
    text.erase(at, 1 + e.value[0]);
  const char* all = text.c_str();
  H5Awrite(attribute, type, &all);
}

void change_attribute(hid_t file, const std::string& object, const std::string& name, const Edit& e) {
  const auto anew = [&](hid_t type, const void* value) {
    H5Adelete_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT);
    const Id space(e.place % 3 == 0 ? H5Screate(H5S_NULL) : H5Screate(H5S_SCALAR), H5Sclose);
    const Id made(H5Acreate_by_name(file, object.c_str(), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    if (made >= 0 && e.place % 3 != 0) H5Awrite(made, type, value);
  };
  switch (e.kind % 8) {
    case 0:
      H5Adelete_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT);
      return;
    case 1:
      return anew(H5T_IEEE_F64LE, e.value.data());
    case 2: {
      const Id text(H5Tcopy(H5T_C_S1), H5Tclose);
      H5Tset_size(text, H5T_VARIABLE);
      const std::string word = e.text();
      const char* all = word.c_str();
      return anew(text, &all);
    }
    case 3: {
      const Id attribute(H5Aopen_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
      const double v = e.number();
      H5Awrite(attribute, H5T_NATIVE_DOUBLE, &v);
      return;
    }
    case 4: {
      const Id attribute(H5Aopen_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
      H5Awrite(attribute, H5T_NATIVE_INT64, e.value.data());
      return;
    }
    case 5:
      return anew(H5T_STD_I64LE, e.value.data());
    default:
      return put_text(file, object, name, e);
  }
}

void name_parts(hid_t file, const std::string& seals) {
  const Id attribute(H5Aopen(file, "part_seals", H5P_DEFAULT), H5Aclose);
  const Id type(H5Aget_type(attribute), H5Tclose);
  const char* text = seals.c_str();
  if (H5Awrite(attribute, type, &text) < 0) std::abort();
}

}  // namespace

RunImage::RunImage(const std::string& path) : bytes_(io::test::bytes_of(path)) {
  constexpr std::array kHdf5{std::byte{0x89}, std::byte{'H'}, std::byte{'D'}, std::byte{'F'}};
  sealed_ = !std::ranges::equal(std::span(bytes_).first(kHdf5.size()), kHdf5);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const Id file(open_image(bytes_), H5Fclose);
  if (file < 0) std::abort();
  const auto visit = [](hid_t, const char* name, const H5O_info_t* info, void* out) -> herr_t {
    if (info->type == H5O_TYPE_DATASET) static_cast<RunImage*>(out)->datasets_.push_back(std::string("/") + name);
    return 0;
  };
  H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_INC, visit, this, H5O_INFO_BASIC);
  std::vector<std::string> objects{"/", "/case", "/provenance", "/summary", "/assessment", "/capacity", "/measures"};
  objects.insert(objects.end(), datasets_.begin(), datasets_.end());
  for (const std::string& object : objects) {
    const auto note = [](hid_t, const char* name, const H5A_info_t*, void* out) -> herr_t {
      static_cast<std::vector<std::string>*>(out)->emplace_back(name);
      return 0;
    };
    std::vector<std::string> names;
    H5Aiterate_by_name(file, object.c_str(), H5_INDEX_NAME, H5_ITER_INC, nullptr, note, &names, H5P_DEFAULT);
    for (const std::string& name : names) attributes_.push_back({object, name});
  }
}

// In a file: of an image, H5Fget_file_image (1.10) gives a superblock whose checksum is wrong, which no reader opens.
void RunImage::write_edited(const std::string& path, std::span<const std::uint8_t> edits, const std::string& part_seals) const {
  std::ofstream out(path, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes_.data()), static_cast<std::streamsize>(bytes_.size()));
  out.close();
  const Id access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V110);
  const Id file(H5Fopen(path.c_str(), H5F_ACC_RDWR, access), H5Fclose);
  if (!out || file < 0) std::abort();
  if (!part_seals.empty()) name_parts(file, part_seals);
  for (; edits.size() >= kEdit; edits = edits.subspan(kEdit)) {
    const Edit e(edits.data());
    if (e.kind < 128) {
      change_dataset(file, datasets_, e);
    } else {
      const Attribute& a = attributes_[e.object % attributes_.size()];
      change_attribute(file, a.object, a.name, e);
    }
  }
}

}  // namespace voussoir::fuzz
