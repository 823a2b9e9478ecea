// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <hdf5.h>

#include <algorithm>

#include "io/input/files/errors.h"
#include "io/input/files/hdf5/handle.h"
#include "io/input/files/hdf5_file.h"

/// Texts and attributes of Hdf5File.
namespace voussoir::io {
namespace {

using hdf5::Doing;
using hdf5::extent_of;
using hdf5::Handle;
using hdf5::link_properties;
using hdf5::simple_space;
using hdf5::text_type;

void write_attribute(const Doing& doing, hid_t file, const std::string& name, hid_t type, hid_t memory, hid_t space, const void* data) {
  const char* object = doing.object.c_str();
  const htri_t there = H5Aexists_by_name(file, object, name.c_str(), H5P_DEFAULT);
  doing.check(there);
  if (there > 0) doing.check(H5Adelete_by_name(file, object, name.c_str(), H5P_DEFAULT));
  const Handle attribute =
      doing.own(H5Acreate_by_name(file, object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  doing.check(H5Awrite(attribute, memory, data));
}

Handle open_attribute(const Doing& doing, hid_t file, const std::string& name) {
  return doing.own(H5Aopen_by_name(file, doing.object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
}

/// Reads a single number. An array is refused, since it would be written past the number.
template <class T>
T attribute_number(const Doing& doing, hid_t file, const std::string& name, hid_t memory) {
  const Handle attribute = open_attribute(doing, file, name);
  const Handle space = doing.own(H5Aget_space(attribute), H5Sclose);
  if (H5Sget_simple_extent_npoints(space) != 1)
    throw FileError(doing.path, "attribute " + name + " of " + doing.object + " is not one number");
  T value{};
  doing.check(H5Aread(attribute, memory, &value));
  return value;
}

}  // namespace

void Hdf5File::write_strings(const std::string& name, std::span<const std::string> values, const Hdf5Note& note) {
  const Doing doing{path_, "write", name};
  std::size_t length = 1;
  for (const std::string& s : values) length = std::max(length, s.size());
  std::vector<char> flat(length * values.size(), '\0');
  for (std::size_t i = 0; i < values.size(); ++i) std::ranges::copy(values[i], flat.begin() + static_cast<std::ptrdiff_t>(i * length));
  const Handle type = text_type(doing, length);
  const Handle space = simple_space(doing, {values.size()});
  const Handle dataset =
      doing.own(H5Dcreate2(handle_, name.c_str(), type, space, link_properties(doing), H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
  if (!values.empty()) doing.check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, flat.data()));
  hdf5::write_note(doing, dataset, note);
}

std::vector<std::string> Hdf5File::read_strings(const std::string& name) const {
  const Doing doing{path_, "read", name};
  const Handle dataset = doing.own(H5Dopen2(handle_, name.c_str(), H5P_DEFAULT), H5Dclose);
  const Handle type = doing.own(H5Dget_type(dataset), H5Tclose);
  const Shape shape = extent_of(doing, dataset);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0 || shape.size() != 1)
    throw FileError(path_, name + " is no list of texts of fixed length");
  const std::size_t length = H5Tget_size(type);
  static_cast<void>(count_of(name));
  std::vector<char> flat(length * shape[0]);
  if (!flat.empty()) doing.check(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, flat.data()));
  std::vector<std::string> values(shape[0]);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const char* from = flat.data() + i * length;
    values[i].assign(from, std::find(from, from + length, '\0'));
  }
  return values;
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, const std::string& text) {
  const Doing doing{path_, "write an attribute of", object};
  const Handle type = text_type(doing, H5T_VARIABLE);
  const char* value = text.c_str();
  write_attribute(doing, handle_, name, type, type, simple_space(doing, {}), &value);
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, double value) {
  const Doing doing{path_, "write an attribute of", object};
  write_attribute(doing, handle_, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, simple_space(doing, {}), &value);
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, std::int64_t value) {
  const Doing doing{path_, "write an attribute of", object};
  write_attribute(doing, handle_, name, H5T_STD_I64LE, H5T_NATIVE_INT64, simple_space(doing, {}), &value);
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, std::span<const std::string> texts) {
  const Doing doing{path_, "write an attribute of", object};
  const Handle type = text_type(doing, H5T_VARIABLE);
  std::vector<const char*> values;
  for (const std::string& t : texts) values.push_back(t.c_str());
  values.push_back(nullptr);  // HDF5 needs a valid pointer even without texts
  write_attribute(doing, handle_, name, type, type, simple_space(doing, {texts.size()}), values.data());
}

bool Hdf5File::has_attribute(const std::string& object, const std::string& name) const {
  const htri_t there = H5Aexists_by_name(handle_, object.c_str(), name.c_str(), H5P_DEFAULT);
  Doing{path_, "read an attribute of", object}.check_reads();
  return there > 0;
}

std::vector<std::string> Hdf5File::attribute_texts(const std::string& object, const std::string& name) const {
  const Doing doing{path_, "read an attribute of", object};
  const Handle attribute = open_attribute(doing, handle_, name);
  const Handle type = doing.own(H5Aget_type(attribute), H5Tclose);
  if (H5Tis_variable_str(type) <= 0) throw FileError(path_, "attribute " + name + " of " + object + " is no text");
  const Handle space = doing.own(H5Aget_space(attribute), H5Sclose);
  std::vector<char*> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  if (values.empty()) return {};
  doing.check(H5Aread(attribute, type, values.data()));
  std::vector<std::string> texts;
  for (const char* v : values) texts.emplace_back(v == nullptr ? "" : v);
  doing.check(H5Dvlen_reclaim(type, space, H5P_DEFAULT, values.data()));
  return texts;
}

std::string Hdf5File::attribute_text(const std::string& object, const std::string& name) const {
  const std::vector<std::string> texts = attribute_texts(object, name);
  return texts.empty() ? std::string() : texts.front();
}

double Hdf5File::attribute_double(const std::string& object, const std::string& name) const {
  return attribute_number<double>({path_, "read an attribute of", object}, handle_, name, H5T_NATIVE_DOUBLE);
}

std::int64_t Hdf5File::attribute_int(const std::string& object, const std::string& name) const {
  return attribute_number<std::int64_t>({path_, "read an attribute of", object}, handle_, name, H5T_NATIVE_INT64);
}

std::map<std::string, std::vector<std::string>> Hdf5File::attributes(const std::string& object) const {
  const Doing doing{path_, "list the attributes of", object};
  std::map<std::string, std::vector<std::string>> all;
  for (const std::string& name : attribute_names(object)) {
    const Handle attribute = open_attribute(doing, handle_, name);
    const Handle type = doing.own(H5Aget_type(attribute), H5Tclose);
    if (H5Tis_variable_str(type) > 0) {
      all[name] = attribute_texts(object, name);
      continue;
    }
    std::string bytes(H5Aget_storage_size(attribute), '\0');
    doing.check(H5Aread(attribute, type, bytes.data()));
    all[name] = {bytes};
  }
  return all;
}

}  // namespace voussoir::io
