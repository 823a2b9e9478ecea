// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <hdf5.h>

#include <algorithm>
#include <map>
#include <utility>

#include "io/input/files/errors.h"
#include "io/input/files/hdf5/handle.h"

/// What is in a file. Links and attributes are listed in the order that HDF5 has them in: where it sorts them, HDF5 1.10 crashes if it
/// cannot read all (H5G__link_release_table).
namespace voussoir::io {
namespace {

using hdf5::Doing;
using hdf5::Handle;

using Names = std::vector<std::string>;

constexpr int kDeepest = 16;  // groups in each other; results have three

herr_t add_link(hid_t, const char* name, const H5L_info_t*, void* out) {
  static_cast<Names*>(out)->emplace_back(name);
  return 0;
}

herr_t add_attribute(hid_t, const char* name, const H5A_info_t*, void* out) {
  static_cast<Names*>(out)->emplace_back(name);
  return 0;
}

Names links_of(const Doing& doing, std::int64_t group) {
  Names names;
  doing.check(H5Literate(group, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, add_link, &names));
  std::ranges::sort(names);
  return names;
}

/// Walks all objects of a file. A results file has each object once, under one name.
class Walk {
 public:
  Walk(const std::string& path, std::int64_t file) : path_(path), file_(file) {}

  Names datasets() {
    enter("/");
    std::ranges::sort(datasets_);
    return std::move(datasets_);
  }

 private:
  void enter(const std::string& name, int depth = 0) {
    if (depth > kDeepest) throw FileError(path_, name + " is deeper than " + std::to_string(kDeepest) + " groups");
    const Doing doing{path_, "list", name};
    const Handle object = doing.own(H5Oopen(file_, name.c_str(), H5P_DEFAULT), H5Oclose);
    H5O_info_t info{};
    doing.check(H5Oget_info2(object, &info, H5O_INFO_BASIC));
    const auto [known, is_new] = names_.emplace(info.addr, name);
    if (!is_new) throw FileError(path_, name + " is the same object as " + known->second + "; results have one name for each");
    Names attributes;
    hsize_t first = 0;
    doing.check(H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_NATIVE, &first, add_attribute, &attributes));
    if (info.type == H5O_TYPE_DATASET) return add_dataset(doing, object, name);
    if (info.type != H5O_TYPE_GROUP) throw FileError(path_, name + " is neither a group nor a dataset");
    for (const std::string& inner : links_of(doing, object))
      follow(object, name == "/" ? name + inner : name + "/" + inner, inner, depth + 1);
  }

  void follow(std::int64_t group, const std::string& name, const std::string& inner, int depth) {
    const Doing doing{path_, "read", name};
    H5L_info_t link{};
    doing.check(H5Lget_info(group, inner.c_str(), &link, H5P_DEFAULT));
    if (link.type != H5L_TYPE_HARD)
      throw FileError(path_, name + (link.type == H5L_TYPE_SOFT ? " is a soft link" : " is a link to another file") + "; not followed");
    enter(name, depth);
  }

  void add_dataset(const Doing& doing, std::int64_t dataset, const std::string& name) {
    const Handle create = doing.own(H5Dget_create_plist(dataset), H5Pclose);
    if (H5Pget_external_count(create) != 0) throw FileError(path_, name + " has its values in another file; not followed");
    datasets_.push_back(name);
  }

  const std::string& path_;
  std::int64_t file_;
  std::map<haddr_t, std::string> names_;  // by address
  Names datasets_;
};

}  // namespace

std::vector<std::string> Hdf5File::datasets() const { return Walk(path_, handle_).datasets(); }

std::vector<std::string> Hdf5File::children(const std::string& group) const {
  const Doing doing{path_, "list", group};
  return links_of(doing, doing.own(H5Gopen2(handle_, group.c_str(), H5P_DEFAULT), H5Gclose));
}

std::vector<std::string> Hdf5File::attribute_names(const std::string& object) const {
  const Doing doing{path_, "list the attributes of", object};
  Names names;
  hsize_t first = 0;
  doing.check(H5Aiterate_by_name(handle_, object.c_str(), H5_INDEX_NAME, H5_ITER_NATIVE, &first, add_attribute, &names, H5P_DEFAULT));
  std::ranges::sort(names);
  return names;
}

}  // namespace voussoir::io
