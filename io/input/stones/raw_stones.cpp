// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/stones/raw_stones.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <set>

#include "cases/input_error.h"
#include "geometry/solids/shells.h"
#include "io/input/files/errors.h"
#include "io/input/files/text_file.h"
#include "io/input/stones/words.h"

namespace voussoir::io {
namespace {

namespace fs = std::filesystem;
using geometry::Mesh;

constexpr std::size_t kLargestFile = std::size_t{512} << 20;  // bytes
constexpr double kEqual = 1e-9;     // of the size of an object: distance at which vertices are equal, as triangles may each have their own
constexpr double kFlat = 1e-9;      // of the size: distance of corners in one plane
constexpr double kStraight = 1e-3;  // rad

StoneFile read_one(const std::string& path) { return read_stone_file(path, read_text_file(path, kLargestFile)); }

/// Reads a folder: each file of a known format, in order of names; a file with a single object gives that object its own name.
StoneFile read_folder(const std::string& path) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(path, error)) {
    const std::string kind = upper(entry.path().extension().string());
    if (kind == ".OBJ" || kind == ".PLY" || kind == ".STL" || kind == ".VTU" || kind == ".JSON") files.push_back(entry.path());
  }
  if (error) throw FileError(path, "cannot be listed: " + error.message());
  if (files.empty()) throw FileError(path, "holds no .obj, .ply, .stl, .vtu or .json file");
  std::sort(files.begin(), files.end());
  StoneFile all;
  for (const fs::path& file : files) {
    StoneFile one = read_one(file.string());
    const bool alone = one.solids.size() == 1;
    for (FileSolid& s : one.solids) {
      s.groups.push_back(file.stem().string());
      s.name = alone || s.name.empty() ? file.stem().string() : file.stem().string() + "." + s.name;
      if (alone) s.groups.pop_back();
      all.solids.push_back(std::move(s));
    }
    for (const std::string& note : one.notes) all.notes.push_back(file.filename().string() + ": " + note);
    for (const std::string& doubt : one.doubts) all.doubts.push_back(file.filename().string() + ": " + doubt);
  }
  return all;
}

/// Whether all corners are in one plane, as of an interface, a text in the drawing, a ground plane; or in one place, so that welding left
/// no face.
bool is_flat(const Mesh& m) {
  if (m.faces.empty()) return true;
  const double size = geometry::diagonal(m);
  geometry::LoopPlane largest;
  for (std::size_t f = 0; f < m.faces.size(); ++f) {
    const geometry::LoopPlane p = geometry::loop_plane(m, f);
    if (p.area > largest.area) largest = p;
  }
  if (!(largest.area > 1e-12 * size * size)) return true;
  return std::all_of(m.vertices.begin(), m.vertices.end(),
                     [&](Vec3 v) { return std::abs(dot(v - largest.centre, largest.normal)) <= 1e-6 * size; });
}

/// Connected parts of an object that is loose faces, or has several bodies.
std::vector<FileSolid> parted(FileSolid solid, bool only_one_in_file, std::size_t& doubled) {
  const Mesh welded = geometry::welded(solid.mesh, kEqual * geometry::diagonal(solid.mesh));
  const Mesh joined = geometry::without_doubled_faces(welded);
  doubled += welded.faces.size() - joined.faces.size();
  std::vector<Mesh> shells = geometry::shells(joined);
  std::vector<FileSolid> out;
  if (shells.size() <= 1) {
    solid.mesh = joined;
    if (!solid.whole && only_one_in_file && solid.name.empty()) solid.name = "1";
    out.push_back(std::move(solid));
    return out;
  }
  for (std::size_t i = 0; i < shells.size(); ++i) {
    FileSolid part = solid;
    part.mesh = std::move(shells[i]);
    part.name = solid.name.empty() ? std::to_string(i + 1) : solid.name + "." + std::to_string(i + 1);
    if (!solid.name.empty()) part.groups.push_back(solid.name);
    out.push_back(std::move(part));
  }
  return out;
}

class Raw {
 public:
  Raw(const cases::StonesSpec& spec, const std::string& key, const std::string& folder, StonesTold told)
      : spec_(spec), key_(key), folder_(folder), notes_(told.notes), doubts_(told.doubts) {}

  std::vector<RawStone> read() {
    StoneFile file = read_file();
    for (const std::string& note : file.notes) notes_.push_back(note);
    for (const std::string& doubt : file.doubts) doubts_.push_back(doubt);
    std::vector<RawStone> out;
    std::size_t flat = 0, bodies = 0, doubled = 0;
    const bool one = file.solids.size() == 1;
    for (FileSolid& given : file.solids) {
      if (given.mesh.faces.empty()) continue;
      std::vector<FileSolid> parts = parted(std::move(given), one, doubled);
      if (parts.size() > 1) bodies += parts.size();
      for (FileSolid& part : parts) {
        if (is_flat(part.mesh)) {
          ++flat;
        } else if (is_taken(part)) {
          out.push_back(stone_of(std::move(part)));
        }
      }
    }
    if (flat > 0) notes_.push_back(counted(flat, "flat surface") + " passed over: interfaces or the like, no solids");
    if (doubled > 0) notes_.push_back(counted(doubled, "face") + " that stand twice left out");
    if (bodies > 0) notes_.push_back(counted(bodies, "stone") + " are connected parts of what the file holds as one");
    check_names(out);
    return out;
  }

 private:
  StoneFile read_file() const {
    const fs::path path(spec_.file);
    const std::string whole = path.is_absolute() || folder_.empty() ? spec_.file : (fs::path(folder_) / path).string();
    try {
      return fs::is_directory(whole) ? read_folder(whole) : read_one(whole);
    } catch (const FileError& e) {
      throw NamedFileError(e, key_ + ".file");
    }
  }

  [[nodiscard]] bool is_taken(const FileSolid& s) {
    if (spec_.only.empty()) return true;
    bool taken = false;
    for (const std::string& name : spec_.only) {
      const bool fits = s.name == name || std::find(s.groups.begin(), s.groups.end(), name) != s.groups.end();
      if (fits) used_.insert(name);
      taken = taken || fits;
    }
    return taken;
  }

  void check_names(const std::vector<RawStone>& stones) const {
    for (std::size_t i = 0; i < spec_.only.size(); ++i) {
      if (!used_.contains(spec_.only[i]))
        throw cases::InputError(key_ + ".only[" + std::to_string(i) + "]",
                                quoted_word(spec_.only[i]) + " is no stone or group of " + quoted_word(spec_.file));
    }
    std::set<std::string> names;
    for (const RawStone& s : stones) {
      if (!names.insert(s.name).second)
        throw cases::InputError(key_ + ".file", stone_words(spec_, s.name) + ": the name stands twice, once more at " +
                                                    geometry::place_text(s.mesh.vertices.front()) + " m; give each stone its own");
    }
    if (stones.empty()) throw cases::InputError(key_ + ".file", quoted_word(spec_.file) + " holds no solid");
  }

  RawStone stone_of(FileSolid part) const {
    place(part.mesh);
    return {std::move(part.name), std::move(part.groups), std::move(part.mesh), part.support, 0};
  }

  /// Converts from the file's unit and axes to metres and the model's axes.
  void place(Mesh& m) const {
    const double unit = cases::metres_in(spec_.unit);
    geometry::Polyhedron p{std::move(m.vertices), {}};
    if (unit != 1.0) {
      for (Vec3& v : p.vertices) v *= unit;
    }
    if (spec_.turn.angle != 0.0) p = geometry::rotated(p, spec_.turn.axis, spec_.turn.angle * std::numbers::pi / 180.0, spec_.turn.about);
    if (!(spec_.place == Vec3{})) p = geometry::moved(p, spec_.place);
    m.vertices = std::move(p.vertices);
  }

  const cases::StonesSpec& spec_;
  const std::string& key_;
  const std::string& folder_;
  std::vector<std::string>&notes_, &doubts_;
  std::set<std::string> used_;  // names of `only` found in the file
};

}  // namespace

void close_up(RawStone& stone) {
  const double size = geometry::diagonal(stone.mesh);
  Mesh joined = geometry::welded(stone.mesh, 1e-7 * size);
  stone.turned = geometry::turn_outward(joined);
  if (const auto fault = geometry::fault_of(joined)) {
    stone.fault = *fault;
    stone.mesh = std::move(joined);
    return;
  }
  stone.mesh = geometry::with_merged_faces(joined, kFlat * size, kStraight);
  stone.merged = joined.faces.size() - stone.mesh.faces.size();
}

std::string counted(std::size_t n, const std::string& what) { return std::to_string(n) + " " + what + (n == 1 ? "" : "s"); }

std::string stone_words(const cases::StonesSpec& spec, const std::string& name) {
  return "stone " + quoted_word(name) + " of " + quoted_word(fs::path(spec.file).filename().string());
}

std::vector<RawStone> raw_stones(const cases::StonesSpec& spec, const std::string& key, const std::string& folder, StonesTold told) {
  return Raw(spec, key, folder, told).read();
}

}  // namespace voussoir::io
