// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/files/hdf5/pieces.h"

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <set>
#include <sstream>

#include "io/input/files/errors.h"

namespace voussoir::io {
namespace hdf5 {

bool is_part(const std::string& file) {
  constexpr std::size_t kHead = 6, kTail = 3;  // "parts/", ".h5"
  if (!file.starts_with("parts/") || !file.ends_with(".h5") || file.size() <= kHead + kTail) return false;
  return file.find_first_not_of("0123456789", kHead) == file.size() - kTail;
}

std::string virtual_name(const std::string& name) {
  std::string escaped;
  for (const char c : name) escaped += c == '%' ? std::string("%%") : std::string(1, c);
  return escaped;
}

namespace {

/// Text that HDF5 gives in pieces of known length.
template <class Get>
std::string text_of(Get get) {
  const ssize_t length = get(nullptr, 0);
  if (length <= 0) return "";
  std::string text(static_cast<std::size_t>(length) + 1, '\0');
  get(text.data(), text.size());
  text.resize(static_cast<std::size_t>(length));
  return text;
}

}  // namespace

std::vector<Piece> pieces_of(const Doing& doing, std::int64_t dataset) {
  const Handle create = doing.own(H5Dget_create_plist(dataset), H5Pclose);
  if (H5Pget_external_count(create) != 0) throw FileError(doing.path, doing.object + " has its values in another file; not followed");
  if (H5Pget_layout(create) != H5D_VIRTUAL) return {};
  std::size_t count = 0;
  doing.check(H5Pget_virtual_count(create, &count));
  const Shape shape = extent_of(doing, dataset);
  std::vector<Piece> pieces(count);
  std::uint64_t rows = 0;
  std::vector<hsize_t> start(shape.size()), end(shape.size());
  for (std::size_t i = 0; i < count; ++i) {
    Piece& p = pieces[i];
    p.file = text_of([&](char* to, std::size_t size) { return H5Pget_virtual_filename(create, i, to, size); });
    p.dataset = text_of([&](char* to, std::size_t size) { return H5Pget_virtual_dsetname(create, i, to, size); });
    const Handle space = doing.own(H5Pget_virtual_vspace(create, i), H5Sclose);
    if (H5Sget_simple_extent_ndims(space) != static_cast<int>(shape.size()))
      throw FileError(doing.path, doing.object + " has rows of another shape");
    doing.check(H5Sget_select_bounds(space, start.data(), end.data()));
    p.first = start.at(0), p.rows = end.at(0) - start.at(0) + 1;
    if (!is_part(p.file) || p.dataset != virtual_name(doing.object))
      throw FileError(doing.path, doing.object + " refers to " + p.file + "; only parts/NNNN.h5 in the same folder are read");
    p.dataset = doing.object;
    if (p.first != rows) throw FileError(doing.path, doing.object + " has rows out of order");
    rows += p.rows;
  }
  if (shape.empty() || rows != shape[0]) throw FileError(doing.path, doing.object + " has rows that are in no file");
  return pieces;
}

}  // namespace hdf5

namespace {

using hdf5::Doing;
using hdf5::Handle;

constexpr const char* kSeals = "part_seals";   // attribute of the file
constexpr std::uint64_t kMostDeflated = 1032;  // of bytes in one, by deflate

std::uint64_t product(const Shape& shape) {
  std::uint64_t n = 1;
  for (const std::uint64_t k : shape) n = k > 0 && n > std::numeric_limits<std::uint64_t>::max() / k ? 0 : n * k;
  return n;
}

/// " (2 of 3 parts are)", if the file names its parts.
std::string missing_of(const Hdf5File& run) {
  const std::vector<NamedPart> parts = run.named_parts();
  const std::filesystem::path folder = std::filesystem::path(run.path()).parent_path();
  std::error_code error;
  const auto gone = std::ranges::count_if(parts, [&](const NamedPart& p) { return !std::filesystem::exists(folder / p.file, error); });
  if (parts.empty()) return {};
  return " (" + std::to_string(gone) + " of " + std::to_string(parts.size()) + " parts are)";
}

}  // namespace

const Hdf5File& Hdf5File::source(const std::string& file) const {
  std::shared_ptr<const Hdf5File>& known = sources_[file];
  if (known) return *known;
  const std::filesystem::path at = std::filesystem::path(path_).parent_path() / file;
  std::error_code error;
  if (!std::filesystem::exists(at, error))
    throw FileError(at.string(), "is missing" + missing_of(*this) +
                                     ". Rows of a run that has not ended are in parts/ beside run.h5, and a copy needs them; if the run "
                                     "has gone on or ended since, read run.h5 again");
  auto opened = std::make_shared<Hdf5File>(open(at.string()));
  opened->is_part_ = true;
  if (sealed_ && !opened->sealed()) throw FileError(at.string(), "is not sealed, but " + path_ + " is");
  for (const NamedPart& p : named_parts())
    if (p.file == file && p.seal != opened->seal())
      throw FileError(at.string(), "is not the part that " + path_ + " was written with (its seal is " + opened->seal() +
                                       ", that of the part " + p.seal + "): it is of another run, or of another time of this one");
  known = std::move(opened);
  return *known;
}

const Hdf5File& Hdf5File::source(const hdf5::Piece& p, const Shape& whole) const {
  const Hdf5File& from = source(p.file);
  Shape there = from.shape(p.dataset);
  if (!there.empty() && there[0] >= p.rows) there[0] = whole[0];
  if (there != whole) throw FileError(from.path(), p.dataset + " has not the rows that " + path_ + " names");
  return from;
}

std::uint64_t Hdf5File::count_of(const std::string& name) const {
  const Doing doing{path_, "read", name};
  const Handle dataset = doing.own(H5Dopen2(handle_, name.c_str(), H5P_DEFAULT), H5Dclose);
  const std::vector<hdf5::Piece> pieces = hdf5::pieces_of(doing, dataset);
  const Shape whole = hdf5::extent_of(doing, dataset);
  if (is_part_ && !pieces.empty()) throw FileError(path_, name + " has its rows in other files; not followed from a part");
  if (pieces.empty()) {
    const Hdf5Dataset d = describe(name);
    const Handle create = doing.own(H5Dget_create_plist(dataset), H5Pclose);
    const std::uint64_t most = H5Pget_nfilters(create) > 1 ? kMostDeflated : 1;
    if (d.claimed / most > d.stored)
      throw FileError(path_, name + " claims " + std::to_string(d.claimed) + " bytes; the file has " + std::to_string(d.stored) + " of it");
  }
  for (const hdf5::Piece& p : pieces) static_cast<void>(source(p, whole).count_of(p.dataset));
  return product(whole);
}

// A line a part, in a text, since an attribute of many texts is limited in size.
std::vector<NamedPart> Hdf5File::named_parts() const {
  if (!has_attribute("/", kSeals)) return {};
  std::vector<NamedPart> parts;
  std::istringstream lines(attribute_text("/", kSeals));
  for (NamedPart p; lines >> p.file >> p.seal;) {
    if (!hdf5::is_part(p.file)) throw FileError(path_, "names " + p.file + " as a part; only parts/NNNN.h5 in the same folder are read");
    parts.push_back(p);
  }
  return parts;
}

void Hdf5File::name_parts(std::span<const NamedPart> parts) {
  std::string text;
  for (const NamedPart& p : parts) text += p.file + " " + p.seal + "\n";
  set_attribute("/", kSeals, text);
}

std::vector<std::string> Hdf5File::sources() const {
  std::set<std::string> files;
  for (const std::string& name : datasets()) {
    const Doing doing{path_, "read", name};
    for (const hdf5::Piece& p : hdf5::pieces_of(doing, doing.own(H5Dopen2(handle_, name.c_str(), H5P_DEFAULT), H5Dclose)))
      files.insert(p.file);
  }
  return {files.begin(), files.end()};
}

}  // namespace voussoir::io
